// A fault of a team's program.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace autoref::league {

// what() says in plain words what is wrong with what the program sent, without naming the program.
class TeamFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Quoting of a program's output in messages.

// `bytes` in quotation marks, cut after 40 bytes; those that are not printable ASCII are written as
// \xHH.
std::string excerpt_of(std::string_view bytes);

}  // namespace autoref::league
