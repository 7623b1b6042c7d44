// Teams that are shell scripts.
#pragma once

#include <string>

#include "game/loop/game_configuration.hpp"
#include "tests/game/team_programs/marked_processes.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::game {

inline const std::string kGreets = "echo 'autoref-team 1 json'\n";

// Reads a line of input into `line`, and the number of its frame into `frame`, which is empty for
// START.
inline const std::string kReads =
    "next() { read -r line || exit 0; frame=${line#*'\"frame\":{\"frame\":'}; "
    "case $line in *'\"frame\":{'*) frame=${frame%%,*};; *) frame=;; esac; }\n";

inline const std::string kAnswers = "answer() { echo \"{\\\"frame\\\":$frame$1}\"; }\n";

// Drives slower in its first run than in all later ones. It creates the folder `mark`, which must
// not exist yet.
inline std::string changing_script(const std::string& mark) {
  return "speed=0.75\nmkdir '" + mark + "' 2>/dev/null && speed=0.25\n" + kGreets + kReads +
         kAnswers +
         "while :; do next; [ -z \"$frame\" ] || answer \",\\\"commands\\\":[{\\\"robot\\\":1,"
         "\\\"vx_mps\\\":$speed}]\"; done\n";
}

// Answers `frames` frames and then runs `then` instead of answering.
inline std::string script_that(int frames, const std::string& then) {
  return kGreets + kReads + kAnswers + "next\nn=0\nwhile [ $n -lt " + std::to_string(frames) +
         " ]; do next; answer; n=$((n + 1)); done\nnext\n" + then + "\n";
}

// Stands still for the whole game.
inline std::string idle_script() {
  return kGreets + kReads + kAnswers + "while :; do next; [ -z \"$frame\" ] || answer; done\n";
}

inline TeamConfiguration shell_team(const std::string& script) {
  TeamConfiguration team;
  TeamProgram program;
  program.command = {"/bin/sh", "-c", script};
  program.environment = {marker()};
  program.answer_s = 60;  // however busy the machine is
  program.memory_mb = 64;
  team.program = program;
  return team;
}

inline GameConfiguration shell_game(const std::string& script_a, double half_s = 0.2) {
  GameConfiguration game = short_game(half_s, 5);
  game.a = shell_team(script_a);
  return game;
}

}  // namespace autoref::game
