// Tries out the program of a team.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/loop/game_configuration.hpp"
#include "league/team/greeting.hpp"

namespace autoref::game {

// A program's behaviour in the first seconds of a game.
struct TeamCheck {
  std::optional<league::Greeting> greeting;  // nullopt: none arrived
  double start_ms = 0;                       // time from the program's start to its first answer
  // Time from writing each later frame until its answer arrives; sorted.
  std::vector<double> answers_ms;
  double played_s = 0;       // simulated duration of the game
  int robots_commanded = 0;  // robots that got a command to move or kick
  int keeper = -1;           // keeper's number that was last requested
  bool asked_for_timeout = false;
  std::string ending;                 // how the program ended after END; empty after a fault
  std::optional<bool> is_repeatable;  // nullopt after a fault
  std::string fault;                  // empty if there was none
};

// Plays a game with a program as team a, then replays it to see whether the program repeats its
// commands. Throws InputOutputError.
TeamCheck check_team(const GameConfiguration& game);

}  // namespace autoref::game
