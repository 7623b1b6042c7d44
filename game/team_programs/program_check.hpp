// Tries out a team that is a program.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/loop/game_configuration.hpp"
#include "league/team/greeting.hpp"

namespace autoref::game {

// What a program did in the first seconds of a game.
struct TeamCheck {
  std::optional<league::Greeting> greeting;  // nullopt: none came
  double start_ms = 0;                       // from the program's start to its first answer
  std::vector<double> answers_ms;            // from writing each later frame to its answer, sorted
  double played_s = 0;                       // of the game
  int robots_commanded = 0;                  // robots that were ever told to move or kick
  int keeper = -1;                           // last requested
  bool asked_for_timeout = false;
  std::string ending;                 // how it ended after END; empty after a fault
  std::optional<bool> is_repeatable;  // nullopt after a fault
  std::string fault;                  // empty if there was none
};

// Plays a game in which team a is a program, and plays it again to see whether the program repeats
// its commands. Throws InputOutputError.
TeamCheck check_team(const GameConfiguration& game);

}  // namespace autoref::game
