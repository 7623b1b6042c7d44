// A referee's calls, derived from its commands or listed by a person, and the agreement between two
// referees.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"

namespace autoref::logs {

// A call: a stop in play and the restart that ends it. The league's evaluation of 2016 calls this
// an event.
struct Call {
  double stop_s = 0;
  double restart_s = 0;
  Command restart;
  std::string_view event{};    // the reason (referee/events.def); empty if only commands are known
  std::optional<Side> side{};  // the event's team: the scorer of a goal, otherwise the offender
};

// The event and its team, such as "goal (yellow)"; for a call without an event, the restart.
std::string title_of(const Call& call);

// Derives calls from a stream of commands: a STOP and the restart after it. Halts, timeouts and
// further STOPs in between are ignored.
class CallMaker {
 public:
  void add(double time_s, Command command);
  const std::vector<Call>& calls() const { return calls_; }

 private:
  std::optional<double> stopped_s_;
  std::vector<Call> calls_;
};

// A recorded call and the matching AutoRef call; if one of them has no match, the other is missing.
struct CallPair {
  std::optional<Call> recorded;
  std::optional<Call> refereed;
  bool is_right() const { return recorded && refereed; }
};

// The time at which play stopped for the call.
double time_of(const CallPair& pair);

struct Agreement {
  std::vector<CallPair> pairs;  // pairs in order of time
  int right = 0;
  int recorded = 0;
  int refereed = 0;

  // Precision and recall of AutoRef's calls; 0 if there are no calls.
  double precision() const;
  double recall() const;
  double f1() const;
  // Score in the technical challenge of 2016: 1 for a right call, -2 for a wrong one.
  int challenge_score() const { return right - 2 * (refereed - right); }
};

// What the other referee did, and when, if only one referee made the call. Empty for a right call.
std::string other_referee_text(const CallPair& pair, const Agreement& agreement);

// Matches AutoRef's calls with the recorded ones. A call is right if a recorded call has the same
// restart and the two overlap in time; AutoRef may be up to `lead_s` early. Both lists must be in
// order of time. Each call is matched at most once, with the first call that fits.
Agreement agreement_of(std::span<const Call> recorded, std::span<const Call> refereed,
                       double lead_s = 2.0);

// Matches AutoRef's calls with those of a person's annotations. A call is right if the event and
// (if the annotation names one) the side are the same and the times differ by at most
// `tolerance_s`.
Agreement agreement_with_annotations(std::span<const Call> annotated,
                                     std::span<const Call> refereed, double tolerance_s = 2.0);

// Reads a person's own list of calls in a recorded game: CSV with the header "time,call,side", rows
// in any order; the result is in order of time.
//   time  seconds from the start of the log, or minutes and seconds: 83.2 or 1:23.2
//   call  an event that AutoRef can call (docs/reference/rules.md), such as throw_in
//   side  yellow or blue: the team that scored or, for other calls, the offender; empty if unknown
// Throws InputError with `file` and line.
std::vector<Call> annotations_in(std::string_view text, const std::string& file);

}  // namespace autoref::logs
