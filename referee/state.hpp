// The states of the referee's machine, and the start of a game in the middle of a half.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>

#include "soccer/geometry.hpp"
#include "soccer/named.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::referee {

// The states of the paper's machine (section 4.3, figure 3), and those for the end of the game, a
// team's timeout, waiting for a person's answer to a call, and ball placement by the teams. Never
// change a state's number: state hashes contain them.
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

// The paper's names.
constexpr auto names_of(State /*any*/) {
  return std::to_array<Named<State>>({{State::kInit, "INIT"},
                                      {State::kWaitStart, "WAIT_START"},
                                      {State::kWaitStop, "WAIT_STOP"},
                                      {State::kRun, "RUN"},
                                      {State::kDelayWait, "DELAY_WAIT"},
                                      {State::kOver, "OVER"},
                                      {State::kTimeout, "TIMEOUT"},
                                      {State::kCalled, "CALLED"},
                                      {State::kPlacement, "PLACEMENT"}});
}

using autoref::name_of;

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

// Whether the ball can be played, even if AutoRef has made a call.
constexpr bool is_play(State state) { return state == State::kRun || state == State::kCalled; }

// Starts a game in the middle of a half instead of with the first kick-off. Earlier touches of the
// ball are unknown.
struct MidwayStart {
  // The pending restart: PREPARE_KICKOFF, PREPARE_PENALTY, DIRECT_FREE or INDIRECT_FREE for one
  // side, or FORCE_START. If it is nullopt, play is on.
  std::optional<Command> restart = {};
  // Where the ball is placed for the restart; unused if play is on.
  Vec2 ball_m{0, 0};
  // If true, STOP comes first, and the restart follows as usual. Otherwise, the restart is
  // signalled immediately; a kick-off or a penalty kick then still waits until the robots are
  // ready.
  bool is_stopped = false;
  // The signal before the start, from which score, stage, clock, cards, fouls, timeouts and ends
  // are taken. Its stage is neither a shoot-out, nor the break before one, nor the end of the game.
  // If it is nullopt, the first half begins with the first frame, with the score 0:0.
  std::optional<RefereeSignal> signal = {};
  // The goals in that signal that were scored in earlier halves.
  PerSide<int> goals_in_earlier_halves = {};
};

}  // namespace autoref::referee
