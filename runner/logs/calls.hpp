// Calls of a referee, told from the commands that it sends, and how well two referees agree.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "soccer/referee_signal.hpp"

namespace autoref::runner {

// Play is stopped, and later goes on with a restart: the league's evaluation of 2016 calls that an
// event.
struct Call {
  double stop_s = 0;
  double restart_s = 0;
  Command restart;
};

// Makes calls of commands as they come: a STOP, and the restart that follows it. Halts and timeouts
// between them change nothing; a second STOP neither.
class CallMaker {
 public:
  void take(double time_s, Command command);
  const std::vector<Call>& calls() const { return calls_; }

 private:
  std::optional<double> stopped_s_;
  std::vector<Call> calls_;
};

// A recorded call and the judge's, or one of them alone.
struct CallPair {
  std::optional<Call> recorded;
  std::optional<Call> refereed;
  bool is_right() const { return recorded && refereed; }
};

struct Agreement {
  std::vector<CallPair> pairs;  // by time
  int right = 0;
  int recorded = 0;
  int refereed = 0;

  // Shares of the judge's and of the recorded calls that are right; 0 where there are none.
  double precision() const;
  double recall() const;
  double f1() const;
  // The technical challenge of 2016: 1 for a right call, -2 for a wrong one.
  int challenge_score() const { return right - 2 * (refereed - right); }
};

// A judge's call is right where its restart is the recorded one's and they overlap in time, the
// judge being up to `lead_s` ahead. Both are ordered by time; each call is paired once, with the
// first that fits.
Agreement agreement_of(std::span<const Call> recorded, std::span<const Call> refereed,
                       double lead_s = 2.0);

}  // namespace autoref::runner
