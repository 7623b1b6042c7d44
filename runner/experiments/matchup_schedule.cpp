#include "runner/experiments/matchup_schedule.hpp"

#include <fmt/format.h>

#include "runner/experiments/schedule.hpp"
#include "runner/settings/fields.hpp"

namespace autoref::runner {
namespace {

std::vector<ScheduledGame> scheduled(const NamedTeams& named, const std::vector<Matchup>& matchups,
                                     int pairs) {
  refuse_too_many(2.0 * pairs * static_cast<double>(matchups.size()));
  std::vector<ScheduledGame> games;
  for (int pair = 1; pair <= pairs; ++pair) {
    for (const Matchup& matchup : matchups) {
      for (const int leg : {1, 2}) {
        games.push_back(scheduled(named, matchup, pair, leg));
        games.back().unit = (games.size() - 1) / 2;
      }
    }
  }
  return games;
}

}  // namespace

void check(const GameSettings& base, const Teams& teams, std::string_view branch) {
  check_game(base);
  for (const auto& [name, team] : teams) {
    const std::string path = fmt::format("{}.{}", branch, name);
    refuse_network(team, path);
    check_team(base, team, path);
  }
}

ScheduledGame scheduled(const NamedTeams& named, const Matchup& matchup, int pair, int leg) {
  ScheduledGame game{game_id(matchup_name(matchup), pair, leg),
                     {},
                     pair,
                     leg,
                     named.base,
                     matchup.team_a,
                     matchup.team_b};
  game.configuration.a = named.teams.at(matchup.team_a);
  game.configuration.b = named.teams.at(matchup.team_b);
  set_leg(game.configuration, named.seed, pair, leg);
  return game;
}

std::vector<ScheduledGame> scheduled_games(const RoundRobin& robin) {
  const auto teams = static_cast<double>(robin.teams.size());
  refuse_too_many(robin.pairs * teams * (teams - 1));
  check(robin.base, robin.teams);
  return scheduled(robin, matchups_of(robin), robin.pairs);
}

std::vector<ScheduledGame> scheduled_games(const SprtMatch& match) {
  check(match.base, match.teams);
  return scheduled(match, {matchup_of(match)}, match.sprt.max_pairs);
}

std::vector<ScheduledGame> scheduled_games(const Gauntlet& gauntlet) {
  refuse_too_many(2.0 * gauntlet.pairs * static_cast<double>(gauntlet.teams.size()) *
                  static_cast<double>(gauntlet.challengers.size()));
  check(gauntlet.base, gauntlet.teams);
  check(gauntlet.base, gauntlet.challengers, "challengers");
  return scheduled(everyone_in(gauntlet), matchups_of(gauntlet), gauntlet.pairs);
}

}  // namespace autoref::runner
