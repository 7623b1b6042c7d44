// Games in which only the rules on goals are in force.
#pragma once

#include <string_view>

#include "tests/referee/support/scripted_game.hpp"

namespace autoref::referee {

inline Configuration of_goals_only(std::string_view book, double half_s) {
  Configuration configuration;
  configuration.rules = *find_rule_book(book);
  configuration.rules.in_force = {RuleId::kGoal, RuleId::kBallLeavesField, RuleId::kGoalLead,
                                  RuleId::kTimeouts};
  configuration.half_s = half_s;
  return configuration;
}

// During play, puts the ball into the goal of `conceded`.
inline void score(ScriptedGame& game, Side conceded) {
  game.kick_from(opponent_of(conceded), 1, {goal_sign(conceded) * 2.5, 0},
                 {goal_sign(conceded) * 6, 0});
  game.run_until("goal");
}

inline void score_times(ScriptedGame& game, Side conceded, int count) {
  for (int i = 0; i < count; ++i) {
    score(game, conceded);
    if (i + 1 < count) game.run_until("start");
  }
}

}  // namespace autoref::referee
