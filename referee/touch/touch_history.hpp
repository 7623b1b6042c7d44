// The touches of the ball since play started, in order, and the ball's motion between them.
//
// The history is built from the last touch that the online detector reports in each frame. Repeated
// touches by one robot count as one touch until the ball has separated from the robot's hull. If
// the detector changes a touch's robot or time shortly afterwards, or withdraws the touch, the
// history follows.
#pragma once

#include <boost/container/static_vector.hpp>
#include <optional>

#include "referee/referee_input.hpp"
#include "referee/touch/frame_history.hpp"
#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

struct BallTouch {
  std::optional<Side> side;      // nullopt if unknown
  std::optional<RobotId> robot;  // nullopt if unknown or ambiguous
  double began_s = 0;
  double ended_s = 0;     // the newest touch may still continue
  double reported_s = 0;  // time of the frame that first reported it
  Vec2 began_m{0, 0};     // the detection of the ball nearest to `began_s`
  Vec2 ended_m{0, 0};     // the detection of the ball nearest to `ended_s`
  std::optional<RobotObservation>
      toucher;                    // the robot at the end of the touch; nullopt if not seen
  std::optional<double> apart_s;  // when the ball separated from that robot
  double highest_m = 0;           // greatest height of the ball's lowest point until the next touch
  // Whether the height was known throughout the time until the next touch.
  bool height_known = true;
  bool rolled = false;  // whether the ball has been on the carpet for the last 0.1 s
};

class TouchHistory {
 public:
  // Updates the history with one frame of the play that started at `began_s`.
  void update(const RefereeInput& input, double began_s);

  // Number of touches so far; only the newest touches are stored.
  int count() const { return count_; }
  int kept() const { return static_cast<int>(kept_.size()); }
  bool has(int back) const { return back < kept(); }
  // The `back`-th touch before the newest one; it must still be stored.
  const BallTouch& at(int back) const {
    return kept_[kept_.size() - 1 - static_cast<std::size_t>(back)];
  }
  const BallTouch* newest() const { return kept_.empty() ? nullptr : &kept_.back(); }
  // Whether at most one robot has touched the ball; an unknown robot counts as a second robot.
  bool is_one_robots() const;

 private:
  void take_in(const RefereeInput& input);
  void begin(const RefereeInput& input);
  void extend(BallTouch& touch, const RefereeInput& input);
  void correct(const RefereeInput& input);
  void withdraw();
  void follow_ball(BallTouch& touch, const RefereeInput& input);

  static constexpr std::size_t kKept = 4;
  boost::container::static_vector<BallTouch, kKept> kept_;
  int count_ = 0;
  std::optional<double> on_carpet_since_s_;  // since the newest touch
};

// Whether the detector will no longer revise the touch, except in rare cases.
bool is_settled(const BallTouch& touch, double now_s);

}  // namespace autoref::referee
