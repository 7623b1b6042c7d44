// A fault of a team's program, and a function that quotes its output in messages.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace autoref::league {

// what() says in plain words what is wrong with the program's output, without naming the program.
class TeamFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// `bytes` in quotation marks, truncated after 40 bytes. Bytes that are not printable ASCII are
// written as \xHH.
std::string excerpt_of(std::string_view bytes);

}  // namespace autoref::league
