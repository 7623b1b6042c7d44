// Teams that the user names on the command line.
#pragma once

#include <string>

#include "game/settings/assignments.hpp"

namespace autoref::app {

struct TeamArgument {
  std::string text;            // as given
  std::string name;            // a name that a team in a scenario may have, made from the text
  game::Assignments settings;  // with the paths of one team's settings, such as "strategy"
};

// A team is one of:
//
//   - a name that `autoref show teams` lists;
//   - a file *.yaml with a team's settings, either by themselves or below a single key, as in the
//     result.yaml of a tuning;
//   - a program: a file that can be executed, a file *.py, or a command with its arguments.
//
// Throws InputError naming `place`, such as "OLD", or the file.
TeamArgument team_argument(const std::string& text, const std::string& place);

}  // namespace autoref::app
