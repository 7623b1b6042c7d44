#include "runner/experiments/situations_schedule.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <utility>

#include "runner/experiments/matchup_schedule.hpp"
#include "runner/experiments/playing_order.hpp"
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

// Settings of the scenes of a matchup.
SharedSettings settings_of(const Situations& situations, const SituationMatchup& matchup) {
  GameSettings game = situations.base;
  game.a = situations.attackers.at(matchup.attackers);
  game.b = situations.defenders.at(matchup.defenders);
  game.scene = situations.situations.at(matchup.situation).scene;
  return SharedSettings(std::move(game));
}

ScheduledGame scheduled(const SituationMatchup& matchup, const SharedSettings& settings,
                        const LegSettings& its_leg, int pair, int leg) {
  const std::string played =
      fmt::format("{}+{}~{}", matchup.situation, matchup.attackers, matchup.defenders);
  return {game_id(played, pair, leg), {matchup.situation}, pair, leg, settings.with(its_leg),
          matchup.attackers,          matchup.defenders};
}

// Indices into matchups_of().
std::vector<std::size_t> playing_order(const Situations& situations) {
  return combinations_order(
      {situations.situations.size(), situations.defenders.size(), situations.attackers.size()});
}

}  // namespace

std::vector<ScheduledGame> scheduled_games(const Situations& situations) {
  const std::vector<SituationMatchup> matchups = matchups_of(situations);
  refuse_too_many(2.0 * situations.pairs * static_cast<double>(matchups.size()));
  check(situations);
  std::vector<SharedSettings> settings;
  settings.reserve(matchups.size());
  for (const SituationMatchup& matchup : matchups)
    settings.push_back(settings_of(situations, matchup));
  const std::vector<std::size_t> order = playing_order(situations);
  std::vector<ScheduledGame> games;
  for (int pair = 1; pair <= situations.pairs; ++pair) {
    std::map<std::string, std::shared_ptr<const StartState>> starts;
    for (const auto& [name, situation] : situations.situations)
      starts[name] = std::make_shared<const StartState>(
          drawn_state(situation, name, situations.base.field, situations.seed, pair));
    for (const std::size_t i : order) {
      const SharedSettings scene = settings[i].starting_from(starts.at(matchups[i].situation));
      for (const int leg : {1, 2}) {
        games.push_back(
            scheduled(matchups[i], scene, leg_of(situations.seed, pair, leg), pair, leg));
        games.back().unit = (games.size() - 1) / 2;
        games.back().variant = i;
        games.back().variants = matchups.size();
      }
    }
  }
  return games;
}

}  // namespace autoref::runner
