#include "runner/experiments/situations_schedule.hpp"

#include <fmt/format.h>

#include "runner/experiments/matchup_schedule.hpp"
#include "runner/settings/setting_error.hpp"

namespace autoref::runner {
namespace {

// The robots of a situation must exist in every team that plays it.
void check_robots(const std::vector<DrawnRobot>& robots, const Teams& teams,
                  const std::string& path) {
  for (const DrawnRobot& robot : robots) {
    for (const auto& [name, team] : teams) {
      if (robot.number < team.robots) continue;
      throw SettingError(
          fmt::format("{}.{}", path, robot.number),
          fmt::format(": team '{}' has {} robots, numbered from 0", name, team.robots));
    }
  }
}

void check(const Situations& situations) {
  check(situations.base, situations.attackers, "attackers");
  check(situations.base, situations.defenders, "defenders");
  for (const auto& [name, situation] : situations.situations) {
    const std::string path = fmt::format("situations.{}", name);
    check_robots(situation.attackers, situations.attackers, path + ".attackers");
    check_robots(situation.defenders, situations.defenders, path + ".defenders");
  }
}

ScheduledGame scheduled(const Situations& situations, const SituationMatchup& matchup,
                        const StartState& start, int pair, int leg) {
  const std::string played =
      fmt::format("{}+{}~{}", matchup.situation, matchup.attackers, matchup.defenders);
  ScheduledGame game{game_id(played, pair, leg), {matchup.situation}, pair, leg, situations.base,
                     matchup.attackers,          matchup.defenders};
  GameSettings& configuration = game.configuration;
  configuration.a = situations.attackers.at(matchup.attackers);
  configuration.b = situations.defenders.at(matchup.defenders);
  configuration.scene = situations.situations.at(matchup.situation).scene;
  set_leg(configuration, situations.seed, pair, leg);
  configuration.start = configuration.match.a_plays == Side::kWest ? start : mirrored(start);
  return game;
}

}  // namespace

std::vector<ScheduledGame> scheduled_games(const Situations& situations) {
  const std::vector<SituationMatchup> matchups = matchups_of(situations);
  refuse_too_many(2.0 * situations.pairs * static_cast<double>(matchups.size()));
  check(situations);
  std::vector<ScheduledGame> games;
  for (int pair = 1; pair <= situations.pairs; ++pair) {
    std::map<std::string, StartState> states;
    for (const auto& [name, situation] : situations.situations)
      states[name] = drawn_state(situation, name, situations.base.field, situations.seed, pair);
    for (const SituationMatchup& matchup : matchups) {
      for (const int leg : {1, 2}) {
        games.push_back(scheduled(situations, matchup, states.at(matchup.situation), pair, leg));
        games.back().unit = (games.size() - 1) / 2;
      }
    }
  }
  return games;
}

}  // namespace autoref::runner
