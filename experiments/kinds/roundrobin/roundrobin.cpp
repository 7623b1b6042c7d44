#include "experiments/kinds/roundrobin/roundrobin.hpp"

#include "experiments/kinds/results.hpp"
#include "experiments/kinds/version_keys.hpp"
#include "experiments/kinds/version_results.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {

constinit const Kind RoundRobin::kKind = {"roundrobin", "Every team against every other.", make};

std::vector<Key> RoundRobin::keys() {
  std::vector<Key> keys = {
      base_key(*this), versioned_teams_key("teams", "each with any setting that a team can have",
                                           teams, base, {}, versions)};
  for (Key& key : earlier_keys(versions)) keys.push_back(std::move(key));
  keys.push_back(pairs_key(pairs, "pairs of legs per matchup"));
  keys.push_back(seed_key(seed));
  return keys;
}

std::optional<VersionedTeams> RoundRobin::versioned_teams() {
  return VersionedTeams{&versions, &teams, nullptr, &base, seed};
}

std::vector<ScheduledGame> RoundRobin::games() const {
  const Teams played = played_teams(teams, versions);
  const auto count = static_cast<double>(played.size());
  refuse_too_many(pairs * count * (count - 1));
  check(base, teams);
  check(versions, teams, "teams");
  return games_of(*this, matchups_among(played), round_robin_order(played.size()), pairs);
}

ExperimentResults RoundRobin::results(const RowsById& rows) const {
  std::vector<Group> groups = grouped(matchups_among(played_teams(teams, versions)), rows);
  std::vector<Standing> standings = standings_of(groups);
  ExperimentResults results = tournament_results(std::move(groups), std::move(standings), "team");
  add_team_differences(results);
  add_version_ratings(results, versions, rows, RatedAgainst::kEachOther);
  return results;
}

}  // namespace autoref::experiments
