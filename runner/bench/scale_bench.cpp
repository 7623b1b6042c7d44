#include "runner/bench/scale_bench.hpp"

#include <algorithm>
#include <stdexcept>

#include "runner/game/game.hpp"
#include "runner/io/processor_time.hpp"
#include "runner/statistics/median_interval.hpp"
#include "runner/statistics/sample.hpp"
#include "sim/camera_presets.hpp"

namespace autoref::runner {
namespace {

constexpr std::size_t kMostRobots = sim::TeamSpec::Robots::static_capacity;

GameConfiguration short_game(const ScaleOptions& options) {
  GameConfiguration game = fixed_game(options.teams, 0);
  game.match.half_s = options.half_s;
  return game;
}

ScaleSeries robots_series(const ScaleOptions& options) {
  ScaleSeries series{"robots per side", "robot", {}, 0};
  const GameConfiguration base = short_game(options);
  for (std::size_t robots = 1; robots <= kMostRobots; ++robots) {
    GameConfiguration game = base;
    if (robots == game.a.robots.size()) series.base = robots - 1;
    game.a.robots.resize(robots);
    game.b.robots.resize(robots);
    series.games.push_back({std::to_string(robots), static_cast<int>(robots), std::move(game)});
  }
  return series;
}

// With detections that miss and deviate, so that there is something to merge.
ScaleSeries cameras_series(const ScaleOptions& options) {
  ScaleSeries series{"cameras (rc2026-a)", "camera", {}, 0};
  for (const int cameras : {1, 2, 4}) {
    GameConfiguration game = short_game(options);
    sim::apply_camera_preset("rc2026-a", game.sim);
    game.sim.vision.cameras = cameras;
    series.games.push_back({std::to_string(cameras), cameras, std::move(game)});
  }
  return series;
}

ScaleSeries presets_series(const ScaleOptions& options) {
  ScaleSeries series{"camera preset", "", {}, 0};
  for (const std::string& preset : sim::camera_preset_names()) {
    GameConfiguration game = short_game(options);
    sim::apply_camera_preset(preset, game.sim);
    series.games.push_back({preset, 0, std::move(game)});
  }
  return series;
}

double ns_per_frame(GameConfiguration game, int round) {
  game.seed = fixed_seed(round);
  const double before_s = processor_s_of(RUSAGE_SELF);
  const GameRecord record = play(game);
  if (record.status != Status::kOk) throw std::logic_error(record.void_reason);
  return 1e9 * (processor_s_of(RUSAGE_SELF) - before_s) / static_cast<double>(record.frames);
}

}  // namespace

std::vector<ScaleSeries> scale_series(const ScaleOptions& options) {
  return {robots_series(options), cameras_series(options), presets_series(options)};
}

double ScaleTable::per_unit(const ScaleRow& row) const {
  return static_cast<double>(rows[base].units) / row.units;
}

Growth growth_of(const ScaleTable& table) {
  const ScaleRow* highest = nullptr;
  for (const ScaleRow& row : table.rows) {
    if (row.units <= table.rows[table.base].units) continue;
    if (highest == nullptr ||
        table.per_unit(row) * row.ratio > table.per_unit(*highest) * highest->ratio)
      highest = &row;
  }
  if (highest == nullptr) return Growth::kNotApplicable;
  const double factor = table.per_unit(*highest);
  if (factor * highest->ratio <= 1) return Growth::kLinearOrBetter;
  return factor * highest->interval.low > 1 ? Growth::kSuperlinear : Growth::kUndecided;
}

ScaleTable scale_table(const ScaleSeries& series,
                       const std::vector<std::vector<double>>& ns_per_frame) {
  const std::vector<double>& base = ns_per_frame[series.base];
  ScaleTable table{series.name, series.unit, series.base, median(base), {}};
  for (std::size_t i = 0; i < series.games.size(); ++i) {
    std::vector<double> ratios;
    ratios.reserve(base.size());
    for (std::size_t round = 0; round < base.size(); ++round)
      ratios.push_back(ns_per_frame[i][round] / base[round]);
    const ScaledGame& game = series.games[i];
    table.rows.push_back({game.name, game.units, median(ratios), median_interval(ratios).value()});
  }
  return table;
}

std::vector<ScaleTable> bench_scale(const ScaleOptions& options) {
  const std::vector<ScaleSeries> all = scale_series(options);
  struct Place {
    std::size_t series, row;
  };
  std::vector<Place> order;
  std::vector<std::vector<std::vector<double>>> ns;
  for (std::size_t i = 0; i < all.size(); ++i) {
    ns.emplace_back(all[i].games.size());
    for (std::size_t row = 0; row < all[i].games.size(); ++row) order.push_back({i, row});
  }
  for (int round = 0; round < options.rounds; ++round) {
    for (const Place& place : order)
      ns[place.series][place.row].push_back(
          ns_per_frame(all[place.series].games[place.row].game, round));
    std::reverse(order.begin(), order.end());
  }
  std::vector<ScaleTable> tables;
  tables.reserve(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) tables.push_back(scale_table(all[i], ns[i]));
  return tables;
}

}  // namespace autoref::runner
