#include "benchmarks/frame_costs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "game/loop/game.hpp"
#include "game/loop/state_hash.hpp"
#include "io/command.hpp"
#include "sim/presets.hpp"

namespace autoref::benchmarks {
namespace {

constexpr std::size_t kMostRobots = sim::TeamSpec::Robots::static_capacity;
constexpr double kMeasuredHalf_s = 60;  // length of each half of a game

game::GameConfiguration short_game(const Options& options) {
  game::GameConfiguration game = game::fixed_game(0, options.team());
  game.match.half_s = kMeasuredHalf_s;
  return game;
}

ScaleSeries robots_series(const Options& options) {
  ScaleSeries series{"robots per side", "robot", {}, 0};
  const game::GameConfiguration base = short_game(options);
  for (std::size_t robots = 1; robots <= kMostRobots; ++robots) {
    game::GameConfiguration game = base;
    if (robots == game.a.robots.size()) series.base = robots - 1;
    game.a.robots.resize(robots);
    game.b.robots.resize(robots);
    series.games.push_back({std::to_string(robots), static_cast<int>(robots), std::move(game)});
  }
  return series;
}

// Some detections are missed and all have errors, so that the merger has work to do.
ScaleSeries cameras_series(const Options& options) {
  ScaleSeries series{"cameras (rc2026-a)", "camera", {}, 0};
  for (const int cameras : {1, 2, 4}) {
    game::GameConfiguration game = short_game(options);
    sim::apply_camera_preset("rc2026-a", game.sim);
    game.sim.vision.cameras = cameras;
    series.games.push_back({std::to_string(cameras), cameras, std::move(game)});
  }
  return series;
}

ScaleSeries presets_series(const Options& options) {
  ScaleSeries series{"camera preset", "", {}, 0};
  for (const std::string& preset : sim::camera_preset_names()) {
    game::GameConfiguration game = short_game(options);
    sim::apply_camera_preset(preset, game.sim);
    series.games.push_back({preset, 0, std::move(game)});
  }
  return series;
}

double ns_per_frame(game::GameConfiguration game, int round) {
  game.seed = game::fixed_seed(round);
  const double before_s = io::processor_s_of(RUSAGE_SELF);
  const game::GameRecord record = game::play(game);
  if (record.status != game::Status::kOk) throw std::logic_error(record.void_reason);
  return 1e9 * (io::processor_s_of(RUSAGE_SELF) - before_s) / static_cast<double>(record.frames);
}

std::string growth_sentence(const ScaleTable& table) {
  const std::string& base = table.rows[table.base].name;
  switch (growth_of(table)) {
    case Growth::kLinearOrBetter:
      return fmt::format("Linear or better: no row beyond {} costs more per {}.\n\n", base,
                         table.unit);
    case Growth::kUndecided:
      return fmt::format(
          "Not distinguishable from linear: a row beyond {} costs more per {}, but the interval "
          "contains 1.\n\n",
          base, table.unit);
    case Growth::kSuperlinear:
      return fmt::format("Worse than linear: a row beyond {} costs more per {}.\n\n", base,
                         table.unit);
    case Growth::kNotApplicable:
      break;
  }
  return "";
}

std::string markdown_row(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

std::string markdown_of(const ScaleTable& table) {
  const bool has_units = !table.unit.empty();
  std::vector<std::string> head = {table.name, "cost of a frame"};
  if (has_units) head.push_back("cost per " + table.unit);
  std::string text = markdown_row(head);
  text += has_units ? "|---|--:|--:|\n" : "|---|--:|\n";
  for (const ScaleRow& row : table.rows) {
    std::vector<std::string> cells = {row.name, text_of_ratio(row.ratio)};
    if (has_units) cells.push_back(text_of_ratio(row.ratio, table.per_unit(row)));
    text += markdown_row(cells);
  }
  text +=
      fmt::format("\n1 is the row {}: {:.0f} ns of processor time per frame on this machine.\n\n",
                  table.rows[table.base].name, table.base_ns_per_frame);
  return text + growth_sentence(table);
}

}  // namespace

std::vector<ScaleSeries> scale_series(const Options& options) {
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
        table.per_unit(row) * row.ratio.median > table.per_unit(*highest) * highest->ratio.median)
      highest = &row;
  }
  if (highest == nullptr) return Growth::kNotApplicable;
  const double factor = table.per_unit(*highest);
  if (factor * highest->ratio.median <= 1) return Growth::kLinearOrBetter;
  return factor * highest->ratio.interval.low > 1 ? Growth::kSuperlinear : Growth::kUndecided;
}

ScaleTable scale_table(const ScaleSeries& series,
                       const std::vector<std::vector<double>>& ns_per_frame) {
  const std::vector<double>& base = ns_per_frame[series.base];
  ScaleTable table{series.name, series.unit, series.base, experiments::median(base), {}};
  for (std::size_t i = 0; i < series.games.size(); ++i) {
    std::vector<double> ratios;
    ratios.reserve(base.size());
    for (std::size_t round = 0; round < base.size(); ++round)
      ratios.push_back(ns_per_frame[i][round] / base[round]);
    const ScaledGame& game = series.games[i];
    table.rows.push_back({game.name, game.units, measured_ratio(ratios)});
  }
  return table;
}

void print_frame_costs(const Options& options) {
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
  std::string text = fmt::format(
      "# The cost of a frame\n\nProcessor time per frame of games of `{0}` against `{0}`, two "
      "halves of {1:g} s, relative to one row of each table in the same round: median of {2} "
      "rounds with its 95 % confidence interval (sign test).\n\n",
      options.team(), kMeasuredHalf_s, options.rounds);
  for (std::size_t i = 0; i < all.size(); ++i) text += markdown_of(scale_table(all[i], ns[i]));
  text.pop_back();
  fmt::print("{}", text);
}

}  // namespace autoref::benchmarks
