// Checks that a comparison names the right reason: cobalt plays against a cobalt with a planted
// weakness, and the most certain part of the difference is printed.
//
//   planted_causes [GAMES]     GAMES per weakness; default: 100
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "experiments/analysis/difference_parts.hpp"
#include "experiments/analysis/play_differences.hpp"
#include "experiments/kinds/compare/comparison.hpp"
#include "experiments/kinds/compare/parts_report.hpp"
#include "experiments/kinds/compare/play_report.hpp"
#include "experiments/results/row_format.hpp"
#include "game/loop/game.hpp"
#include "game/loop/team_controller.hpp"
#include "game/settings/fields.hpp"
#include "io/processes/workers.hpp"
#include "io/table.hpp"
#include "strategies/strategy.hpp"

namespace autoref::tools {
namespace {

// Changes a team's commands.
using Weakness = std::function<void(const strategies::Strategy& team, const TeamView& view,
                                    const Field& field, TeamCommands& commands)>;

class WeakTeam final : public strategies::Strategy {
 public:
  WeakTeam(std::unique_ptr<strategies::Strategy> team, const Weakness& weakness, const Field& field)
      : team_(std::move(team)), weakness_(weakness), field_(field) {}

  void decide(const TeamView& view, TeamCommands& commands) override {
    team_->decide(view, commands);
    weakness_(*team_, view, field_, commands);
  }
  TeamRequests requests() const override { return team_->requests(); }

 private:
  std::unique_ptr<strategies::Strategy> team_;
  Weakness weakness_;
  Field field_;
};

// All robots stand still while the team should take a free kick near the opponents' corners.
void without_corner_kicks(const strategies::Strategy& /*team*/, const TeamView& view,
                          const Field& field, TeamCommands& commands) {
  constexpr double kNear_m = 0.5;
  const Vec2 ball_m = view.ball.position_m;
  const bool is_free_kick = view.play == Play::kDirectFree || view.play == Play::kIndirectFree;
  const bool is_in_corner = ball_m.x() > field.half_length_m() - kNear_m &&
                            std::abs(ball_m.y()) > field.half_width_m() - kNear_m;
  if (view.ours && is_free_kick && is_in_corner) commands = {};
}

void with_slow_keeper(const strategies::Strategy& team, const TeamView& /*view*/,
                      const Field& /*field*/, TeamCommands& commands) {
  constexpr double kShare = 0.3;
  const int keeper = team.requests().keeper;
  if (keeper >= 0) commands.at(static_cast<std::size_t>(keeper)).velocity_mps *= kShare;
}

struct PlantedCause {
  std::string name;
  Weakness weakness;                // of the new team; empty: none
  std::vector<std::string> params;  // changed parameters of the new team, "name=value"
};

const std::vector<PlantedCause> kCauses = {
    {"takes no corner kicks", without_corner_kicks, {}},
    {"slow keeper", with_slow_keeper, {}},
    {"never passes", {}, {"after_pass=0", "after_chip=0", "receivers=0"}},
    {"no weakness", {}, {}}};

experiments::Comparison comparison_of(const PlantedCause& cause, int games) {
  experiments::Comparison comparison;
  game::set_by_path(comparison.base, "match.rules", "2026-b");
  for (const char* name : {experiments::kOldTeam, experiments::kNewTeam})
    comparison.teams[name].strategy = "cobalt";
  for (const std::string& param : cause.params) {
    const std::size_t equals = param.find('=');
    comparison.teams[experiments::kNewTeam].params[param.substr(0, equals)] =
        std::atof(param.c_str() + equals + 1);
  }
  comparison.test.max_pairs = games / 2;
  return comparison;
}

// The new team is team a.
game::GameRecord play_with(const game::GameConfiguration& game, const PlantedCause& cause) {
  const auto make_team = [&](const game::TeamConfiguration& team,
                             const strategies::TeamContext& context) {
    std::unique_ptr<strategies::Strategy> made = game::make_registered_team(team, context);
    if (!cause.weakness || context.side != game.match.a_plays) return made;
    made = std::make_unique<WeakTeam>(std::move(made), cause.weakness, game.field);
    return made;
  };
  return game::play(game, {}, make_team);
}

experiments::RowsById rows_of_games(const PlantedCause& cause,
                                    const experiments::Comparison& comparison) {
  const std::vector<experiments::ScheduledGame> scheduled = comparison.games();
  const experiments::RowFormat format({});
  std::vector<std::size_t> jobs;
  for (std::size_t i = 0; i < scheduled.size(); ++i) jobs.push_back(i);
  const auto work = [&](const io::Job& job) {
    experiments::GameRow row = experiments::row_of(scheduled[job.number]);
    row.record = play_with(experiments::resolved(scheduled[job.number]), cause);
    return format.line(row);
  };
  experiments::RowsById rows;
  const auto done = [&](const io::JobResult& result) {
    if (!result.failure.empty()) throw std::runtime_error(result.failure);
    const auto row = format.read(result.payload).value();
    if (experiments::is_void(row.record)) throw std::runtime_error(row.record.void_reason);
    rows[row.game_id] = row;
  };
  io::WorkerOptions pool;
  pool.workers = io::processors();
  if (io::do_jobs(jobs, pool, {work, done, [] {}}) == io::Ending::kInterrupted)
    throw io::Interrupted();
  return rows;
}

// The report's lines and tables of reasons.
std::string reasons_after(const PlantedCause& cause, int games) {
  const experiments::Comparison comparison = comparison_of(cause, games);
  const experiments::RowsById rows = rows_of_games(cause, comparison);
  std::vector<int> pairs;
  for (int pair = 1; pair <= games / 2; ++pair) pairs.push_back(pair);
  const std::vector<experiments::PairedOpponent> opponents = {
      {experiments::matchup_name(experiments::matchups_of(comparison)[0]), std::nullopt}};
  const auto parts = experiments::difference_parts(opponents, pairs, rows);
  const auto play = experiments::play_differences(opponents, pairs, rows);
  std::string text = fmt::format("{}\n\n{}\n\n{}", experiments::most_certain_text(parts),
                                 experiments::most_certain_text(play),
                                 io::text_of(experiments::parts_table(parts, false)));
  if (const io::TextBlocks table = experiments::play_table(play); !table.empty())
    text += "\n" + io::text_of(table);
  return text;
}

int main_of(int games) {
  fmt::print(
      "# Planted weaknesses\n\n{} games of cobalt with each weakness (new) against cobalt without "
      "it (old), rules 2026-b.\n\n",
      games);
  for (const PlantedCause& cause : kCauses) {
    fmt::print("## {}\n\n{}\n", cause.name, reasons_after(cause, games));
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace autoref::tools

int main(int argc, char** argv) try {
  const int games = argc > 1 ? std::atoi(argv[1]) : 100;
  return games < 2 ? 2 : autoref::tools::main_of(games);
} catch (const std::exception& error) {
  std::fprintf(stderr, "planted_causes: %s\n", error.what());
  return 1;
}
