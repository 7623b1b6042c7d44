#include "experiments/kinds/roundrobin/roundrobin.hpp"

#include "experiments/kinds/results.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {

constinit const Kind RoundRobin::kKind = {"roundrobin", "Every team against every other.", make};

std::vector<Key> RoundRobin::keys() {
  return {base_key(*this), teams_key(*this, "each with any setting that a team can have"),
          pairs_key(pairs, "pairs of legs per matchup"), seed_key(seed)};
}

std::vector<ScheduledGame> RoundRobin::games() const {
  const auto count = static_cast<double>(teams.size());
  refuse_too_many(pairs * count * (count - 1));
  check(base, teams);
  return games_of(*this, matchups_among(teams), round_robin_order(teams.size()), pairs);
}

ExperimentResults RoundRobin::results(const RowsById& rows) const {
  std::vector<Group> groups = grouped(matchups_among(teams), rows);
  std::vector<Standing> standings = standings_of(groups);
  ExperimentResults results = tournament_results(std::move(groups), std::move(standings), "team");
  add_team_differences(results);
  return results;
}

}  // namespace autoref::experiments
