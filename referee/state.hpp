// The states of the referee's machine.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace autoref::referee {

// The states of the paper's machine (section 4.3, figure 3), the end of the game, a team's timeout,
// the wait for a person's answer to a call, and ball placement by the teams. Never change a number:
// state hashes contain them.
enum class State : std::uint8_t {
  kInit = 0,
  kWaitStart = 1,
  kWaitStop = 2,
  kRun = 3,
  kDelayWait = 4,
  kOver = 5,
  kTimeout = 6,
  kCalled = 7,
  kPlacement = 8,
};

// The paper's name, such as "WAIT_STOP".
std::string_view name_of(State state);

// A set of the machine's states.
class States {
 public:
  constexpr States(std::initializer_list<State> states) {
    for (const State state : states) bits_ |= bit(state);
  }
  constexpr bool has(State state) const { return (bits_ & bit(state)) != 0; }

 private:
  static constexpr unsigned bit(State state) { return 1U << static_cast<unsigned>(state); }
  unsigned bits_ = 0;
};

}  // namespace autoref::referee
