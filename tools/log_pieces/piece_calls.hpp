// A game's calls, each with the time at which its evidence begins, and the comparison of the calls
// in a piece of a log with those in the whole game.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "referee/decision.hpp"

namespace autoref::tools {

struct PieceCall {
  referee::Event event = referee::Event::kBegin;
  std::optional<Side> side;  // the side that gets the restart or, if play continues, is at fault
  std::optional<RobotId> robot;
  double time_s = 0;
  double evidence_from_s = 0;  // when the call's evidence begins; earlier frames do not matter
  double phase_from_s = 0;     // when the stop or the play began
  bool in_stop = false;
};

class CallList {
 public:
  void add(const referee::Decision& decision);
  // The same calls, each `by_s` later.
  CallList later(double by_s) const;
  const std::vector<PieceCall>& calls() const { return calls_; }
  // Whether a command stopped play within 0.1 s of `time_s`.
  bool is_stopped_at(double time_s) const;

 private:
  std::vector<PieceCall> calls_;
  std::vector<double> changes_s_;  // alternating: play begins, play stops
  double phase_from_s_ = 0;
};

struct Piece {
  double from_s = 0;
  double to_s = 0;
  double joined_s = 0;  // calls within this time after the start do not count
};

struct Tally {
  std::string name;  // name of the piece, for messages on stderr
  int pieces = 0;
  int calls = 0;        // calls of the whole game with all evidence within the piece
  int agreed = 0;       // those calls that the piece also has
  int extra = 0;        // calls of the piece that the whole game does not have
  int unknown_due = 0;  // calls whose evidence lies before the piece
  int unknown = 0;      // those of them for which the piece has "unknown" or no call
  int same = 0;         // those of them for which the piece has the same call
  int repeated = 0;     // extra calls that the whole game made earlier in the same stop or restart
  int unsignalled = 0;  // calls in a stop that was not signalled

  void add(const CallList& whole, const CallList& judged, const Piece& piece);
  Tally& operator+=(const Tally& other);
  static std::string heading();
  std::string row(const std::string& title) const;
  bool is_good() const;
};

std::vector<std::string> camera_names();

}  // namespace autoref::tools
