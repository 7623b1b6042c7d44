#include "runner/experiments/judge_plan.hpp"

#include <fmt/format.h>

#include "runner/experiments/plan.hpp"
#include "runner/settings/fields.hpp"

namespace autoref::runner {
namespace {

// A book brings its own length of halves, which the base's replaces.
void set_rules(GameConfiguration& game, const std::string& rules) {
  const MatchConfiguration base = game.match;
  set_by_path(game, "match.rules", rules);
  game.match.half_s = base.half_s;
  game.match.halves = base.halves;
}

JudgeGame game_of(const JudgePlan& plan, const std::string& rules, const std::string& camera,
                  int number) {
  const int pair = (number + 1) / 2;
  const int leg = 2 - number % 2;
  JudgeGame game{"", rules, camera, plan.base};
  set_rules(game.configuration, rules);
  set_by_path(game.configuration, "sim.camera", camera);
  if (!plan.matchups.empty()) {
    const auto& matchup = plan.matchups[static_cast<std::size_t>(pair - 1) % plan.matchups.size()];
    game.configuration.a.strategy = matchup[0];
    game.configuration.b.strategy = matchup[1];
  }
  set_leg(game.configuration, plan.seed, pair, leg);
  game.id =
      fmt::format("{} {} {} {}", rules, camera,
                  name_of({game.configuration.a.strategy, game.configuration.b.strategy}), number);
  check_game(game.configuration);
  return game;
}

}  // namespace

std::string name_of(const std::array<std::string, 2>& matchup) {
  return matchup[0] + "~" + matchup[1];
}

std::vector<JudgeGame> games_of(const JudgePlan& plan) {
  std::vector<JudgeGame> games;
  for (int number = 1; number <= plan.games; ++number) {
    for (const std::string& rules : plan.rules) {
      for (const std::string& camera : plan.cameras) {
        games.push_back(game_of(plan, rules, camera, number));
      }
    }
  }
  return games;
}

}  // namespace autoref::runner
