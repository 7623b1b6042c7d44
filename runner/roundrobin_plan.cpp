#include "runner/roundrobin_plan.hpp"

#include <fmt/format.h>

#include "runner/fields.hpp"

namespace autoref::runner {
namespace {

void check(const RoundRobin& robin) {
  check_game(robin.base);
  for (const auto& [name, team] : robin.teams) {
    check_team(robin.base, team, fmt::format("teams.{}", name));
  }
}

PlannedGame planned(const RoundRobin& robin, const Matchup& matchup, int pair, int leg) {
  PlannedGame game{game_id(matchup_name(matchup), pair, leg),
                   {},
                   pair,
                   leg,
                   robin.base,
                   matchup.team_a,
                   matchup.team_b};
  game.configuration.a = robin.teams.at(matchup.team_a);
  game.configuration.b = robin.teams.at(matchup.team_b);
  set_leg(game.configuration, robin.seed, pair, leg);
  return game;
}

}  // namespace

std::vector<PlannedGame> plan(const RoundRobin& robin) {
  const std::vector<Matchup> matchups = matchups_of(robin);
  refuse_too_many(2.0 * robin.pairs * static_cast<double>(matchups.size()));
  check(robin);
  std::vector<PlannedGame> games;
  for (int pair = 1; pair <= robin.pairs; ++pair) {
    for (const Matchup& matchup : matchups) {
      for (const int leg : {1, 2}) games.push_back(planned(robin, matchup, pair, leg));
    }
  }
  return games;
}

}  // namespace autoref::runner
