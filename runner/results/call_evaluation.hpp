// What the referee got right and wrong in one judged game.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "soccer/side.hpp"

namespace autoref::runner {

namespace ground_truth {

enum class Outcome : std::uint8_t {
  kRight,      // happened and was called
  kWrong,      // called, but did not happen
  kMissed,     // happened, but was not called
  kOvertaken,  // happened, but another right call ended play at the same moment
};

// A true event, a call, or both if they belong together.
struct Verdict {
  std::string name;  // of the event
  Outcome outcome = Outcome::kRight;
  double time_s = 0;              // of the event, or of the call if nothing happened
  std::optional<Side> offender;   // empty if the event has none
  double delay_s = 0;             // of a right call, after the event
  std::optional<double> error_m;  // of a right call's position
  bool is_early = false;          // right by luck: the call came before the event
  bool is_borderline = false;     // the truth was near the threshold
  bool is_in_air = false;         // the ball was in the air
  bool is_second = false;         // wrong because there already was a call for the event
};

}  // namespace ground_truth

// How often the referee named the right team as the last to touch the ball, in calls that depend on
// it.
struct LastTouchTally {
  int right = 0;
  int wrong = 0;
  int unknown = 0;
};

struct CallEvaluation {
  std::vector<ground_truth::Verdict> verdicts;  // in order of time
  std::array<LastTouchTally, 2> last_touch;     // by the team that actually touched it: a, b
  std::vector<std::string> calls_in_stop;  // calls that require play, such as "goal at 12.350 s"
};

}  // namespace autoref::runner
