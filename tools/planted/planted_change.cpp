#include "tools/planted/planted_change.hpp"

#include <memory>
#include <stdexcept>
#include <utility>

#include "experiments/results/row_format.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "game/loop/game.hpp"
#include "game/loop/team_controller.hpp"
#include "game/settings/fields.hpp"
#include "io/processes/workers.hpp"

namespace autoref::tools {
namespace {

class ChangedTeam final : public strategies::Strategy {
 public:
  ChangedTeam(std::unique_ptr<strategies::Strategy> team, const CommandChange& change,
              const Field& field)
      : team_(std::move(team)), change_(change), field_(field) {}

  void decide(const TeamView& view, TeamCommands& commands) override {
    team_->decide(view, commands);
    change_(*team_, view, field_, commands);
  }
  TeamRequests requests() const override { return team_->requests(); }

 private:
  std::unique_ptr<strategies::Strategy> team_;
  CommandChange change_;
  Field field_;
};

void slow_down_keeper(const strategies::Strategy& team, const TeamView& /*view*/,
                      const Field& /*field*/, TeamCommands& commands) {
  constexpr double kShare = 0.3;
  const int keeper = team.requests().keeper;
  if (keeper >= 0) commands.at(static_cast<std::size_t>(keeper)).velocity_mps *= kShare;
}

// The new team is team a.
game::GameRecord play_with(const game::GameConfiguration& game, const CommandChange& change) {
  const auto make_team = [&](const game::TeamConfiguration& team,
                             const strategies::TeamContext& context) {
    std::unique_ptr<strategies::Strategy> made = game::make_registered_team(team, context);
    if (!change || context.side != game.match.a_plays) return made;
    made = std::make_unique<ChangedTeam>(std::move(made), change, game.field);
    return made;
  };
  return game::play(game, {}, make_team);
}

}  // namespace

PlantedChange slow_keeper() { return {"slow keeper", slow_down_keeper, {}}; }

PlantedChange never_passes() {
  return {"never passes",
          {},
          {{"params.after_pass", "0"}, {"params.after_chip", "0"}, {"params.receivers", "0"}}};
}

experiments::Comparison comparison_of(const PlantedChange& change, int pairs) {
  experiments::Comparison comparison;
  game::set_by_path(comparison.base, "match.rules", "2026-b");
  for (const char* name : {experiments::kOldTeam, experiments::kNewTeam})
    comparison.teams[name].strategy = "cobalt";
  const std::string prefix = std::string("teams.") + experiments::kNewTeam + ".";
  for (const TeamSettingChange& setting : change.settings) {
    game::set_by_path({comparison.base, comparison.teams[experiments::kNewTeam], prefix},
                      prefix + setting.path, setting.value);
  }
  comparison.test.max_pairs = pairs;
  return comparison;
}

std::string matchup_of(const experiments::Comparison& comparison) {
  return experiments::matchup_name(experiments::matchups_of(comparison).front());
}

experiments::RowsById play_all(const experiments::Comparison& comparison,
                               const CommandChange& change) {
  const std::vector<experiments::ScheduledGame> scheduled = comparison.games();
  const experiments::RowFormat format({});
  std::vector<std::size_t> jobs;
  jobs.reserve(scheduled.size());
  for (std::size_t i = 0; i < scheduled.size(); ++i) jobs.push_back(i);
  const auto work = [&](const io::Job& job) {
    experiments::GameRow row = experiments::row_of(scheduled[job.number]);
    row.record = play_with(experiments::resolved(scheduled[job.number]), change);
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

}  // namespace autoref::tools
