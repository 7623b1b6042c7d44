// A fault of a team's program.
#pragma once

#include <stdexcept>
#include <string>

namespace autoref::league {

// what() says in plain words what is wrong with what the program sent, without naming the program.
class TeamFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace autoref::league
