// Scripted games under rule books other than the paper's.
#pragma once

#include <string_view>

#include "tests/referee/support/scripted_game.hpp"

namespace autoref::referee {

// A configuration with that rule book and its field.
inline Configuration by_book(std::string_view book) {
  Configuration configuration;
  configuration.rules = find_rule_book(book).value();
  configuration.field = find_game_setup(book).value().field;
  return configuration;
}

// West has put the ball over the touch line at y > 0, and the referee has just stopped play: a
// throw-in for east at x = 0.4.
inline ScriptedGame stopped_game(const Configuration& configuration) {
  ScriptedGame game(configuration);
  game.line_up().kick_off();
  game.kick_from(Side::kWest, 1, {0.4, configuration.field.half_width_m() - 0.2}, {0, 4});
  game.run_until("throw_in");
  return game;
}

// The same game after the throw-in has been signalled; the ball waits for east 3.
inline ScriptedGame throw_in_game(const Configuration& configuration) {
  ScriptedGame game = stopped_game(configuration);
  game.robot(Side::kWest, 1).position_m = Vec2(-1, 0);
  game.run_until("start");
  return game;
}

inline bool is_foul_of(const Decision& decision, RobotId robot) {
  return decision.finding.offender == robot.side && decision.finding.robots.size() == 1 &&
         decision.finding.robots.front() == robot;
}

}  // namespace autoref::referee
