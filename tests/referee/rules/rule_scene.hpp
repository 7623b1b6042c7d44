// Scripted games under rule books other than the paper's.
#pragma once

#include "tests/referee/support/booked_game.hpp"
#include "tests/referee/support/scripted_game.hpp"

namespace autoref::referee {

inline Configuration without(Configuration configuration, RuleId rule) {
  configuration.rules.in_force[rule] = false;
  return configuration;
}

// Whether the referee calls the event within the next seconds of play.
inline bool is_called(ScriptedGame& game, std::string_view transition, double seconds = 1.0) {
  game.run(seconds);
  return game.count(transition) > 0;
}

}  // namespace autoref::referee
