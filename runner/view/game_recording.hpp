// A game as a recording: every frame and what the referee said, packed for a page (page.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runner/view/packed_column.hpp"
#include "runner/view/recorded_decision.hpp"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::runner {

struct RecordedSignal {
  double time_s = 0;
  RefereeSignal signal;
};

// The stage's clock showed `left_s` from `time_s` on.
struct ClockMark {
  double time_s = 0;
  int left_s = 0;
};

class GameRecording {
 public:
  // What comes beyond is left out: 4.6 hours at 60 frames a second, and no game.
  static constexpr std::size_t kMostFrames = 1'000'000;
  static constexpr std::size_t kMostSignals = 100'000;

  // Times must grow.
  void add(const Frame& frame);

  // Keeps the signal where it shows something else than the last one. Times that fall are raised.
  void add(double time_s, const RefereeSignal& signal);

  // Keeps the decision if pages show it.
  void add(RecordedDecision decision);

  std::size_t frames() const { return frames_; }
  double first_s() const { return first_s_; }
  double last_s() const { return last_s_; }
  const std::vector<RecordedSignal>& signals() const { return signals_; }
  const std::vector<ClockMark>& clock() const { return clock_; }
  const std::vector<RecordedDecision>& decisions() const { return decisions_; }
  bool is_full() const { return is_full_; }  // something was left out

  // Those who were ever seen, in the order of their columns.
  std::vector<RobotId> robots() const;

  // Per frame its time in 0.1 ms as uint32, the lowest byte first. Then columns
  // (packed_column.hpp): of each robot x and y in mm and its heading in 0.1 degrees, counter-
  // clockwise from x; last of the ball x, y and height in mm, the height kNothing where vision
  // cannot tell it.
  std::string bytes() const;

 private:
  using Triple = std::array<PackedColumn, 3>;
  using Columns = std::array<std::optional<Triple>, kMaxRobots>;  // by number; none: never seen

  void add_time(double time_s);
  void add_robots(const SeenRobots& robots, Columns& columns);

  std::size_t frames_ = 0;
  double first_s_ = 0;
  double last_s_ = 0;
  std::string times_;
  PerSide<Columns> robots_;
  Triple ball_;
  std::vector<RecordedSignal> signals_;
  std::vector<ClockMark> clock_;
  std::vector<RecordedDecision> decisions_;
  bool is_full_ = false;
};

}  // namespace autoref::runner
