#include "runner/experiments/judge_schedule.hpp"

#include <fmt/format.h>

#include "runner/experiments/cells.hpp"
#include "runner/experiments/schedule.hpp"
#include "runner/settings/fields.hpp"

namespace autoref::runner {
namespace {

JudgeGame game_of(const JudgeSchedule& schedule, const std::string& rules,
                  const std::string& camera, int number) {
  const int pair = (number + 1) / 2;
  const int leg = 2 - number % 2;
  JudgeGame game{"", rules, camera, configured(schedule, rules, camera)};
  if (!schedule.matchups.empty()) {
    const auto& matchup =
        schedule.matchups[static_cast<std::size_t>(pair - 1) % schedule.matchups.size()];
    game.configuration.a.strategy = matchup[0];
    game.configuration.b.strategy = matchup[1];
    game.configuration.a.command.clear();
    game.configuration.b.command.clear();
  }
  set_leg(game.configuration, schedule.seed, pair, leg);
  const std::string matchup =
      name_of({name_of(game.configuration.a), name_of(game.configuration.b)});
  game.id = fmt::format("{} {} {} {}", rules, camera, matchup, number);
  game.game_id = game_id(fmt::format("{}+{}+{}", rules, camera, matchup), pair, leg);
  game.pair = pair;
  game.leg = leg;
  check_game(game.configuration);
  return game;
}

}  // namespace

std::string name_of(const std::array<std::string, 2>& matchup) {
  return matchup[0] + "~" + matchup[1];
}

std::vector<JudgeGame> games_of(const JudgeSchedule& schedule) {
  refuse_too_many(static_cast<double>(schedule.rules.size()) *
                      static_cast<double>(schedule.cameras.size()) * schedule.games,
                  "games");
  std::vector<JudgeGame> games;
  for (int number = 1; number <= schedule.games; ++number) {
    for (const std::string& rules : schedule.rules) {
      for (const std::string& camera : schedule.cameras) {
        games.push_back(game_of(schedule, rules, camera, number));
      }
    }
  }
  return games;
}

std::vector<ScheduledGame> scheduled_games(const JudgeSchedule& schedule) {
  std::vector<ScheduledGame> games;
  for (const JudgeGame& game : games_of(schedule)) {
    const GameSettings& c = game.configuration;
    games.push_back({game.game_id,
                     {game.rules, game.camera},
                     game.pair,
                     game.leg,
                     c,
                     name_of(c.a),
                     name_of(c.b),
                     static_cast<std::size_t>(game.pair - 1)});
  }
  return games;
}

}  // namespace autoref::runner
