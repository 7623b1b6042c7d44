// The referee's right and wrong calls in one judged game, as data and as a cell of the game's row.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "soccer/side.hpp"

namespace autoref::experiments {

enum class CallOutcome : std::uint8_t {
  kRight,      // happened and was called
  kWrong,      // called, but did not happen
  kMissed,     // happened, but was not called
  kOvertaken,  // happened, but another correct call stopped play at the same time
};

// A true event, a call, or both if they match.
struct CallVerdict {
  std::string name;  // name of the event
  CallOutcome outcome = CallOutcome::kRight;
  double time_s = 0;              // time of the event, or of the call if nothing happened
  std::optional<Side> offender;   // the offending side; nullopt if there is none
  double delay_s = 0;             // delay from the event to a correct call
  std::optional<double> error_m;  // position error of a correct call
  // The referee's confidence in the call, from 0 to 1; nullopt if nothing was called.
  std::optional<double> confidence;
  bool is_early = false;       // correct by luck: the call came before the event
  bool is_borderline = false;  // the true value was near the threshold
  bool is_in_air = false;      // the ball was in the air
  bool is_second = false;      // the call is wrong because the event had already been called
};

// How often the referee named the right team as the last to touch the ball, counted over the calls
// that depend on the last touch.
struct LastTouchTally {
  int right = 0;
  int wrong = 0;
  int unknown = 0;
};

struct CallEvaluation {
  std::vector<CallVerdict> verdicts;  // verdicts in order of time
  // Indexed by the team that actually touched the ball: a, b.
  std::array<LastTouchTally, 2> last_touch;
  // The tallies for contested touches only: those where both teams touched the ball within the last
  // 0.1 s before it left the field.
  std::array<LastTouchTally, 2> contested_touch;
  std::vector<std::string> calls_in_stop;  // made during a stop: "goal at 12.350 s"
};

// The evaluation as the text of a cell in the game's row: one line. Times and distances have four
// decimals.
std::string text_of(const CallEvaluation& evaluation);

// Returns nullopt if the text is not an evaluation.
std::optional<CallEvaluation> evaluation_in(std::string_view text);

}  // namespace autoref::experiments
