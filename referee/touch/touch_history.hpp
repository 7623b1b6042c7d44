// Who touched the ball since play was started, in order, and what the ball did between the touches.
//
// It is made of the last touch as the detector tells it from frame to frame. Touches by one robot
// are one until the ball has been apart from its hull. What the detector tells otherwise a moment
// later is changed, too: who it was, when it was, or that it was no touch at all.
#pragma once

#include <boost/container/static_vector.hpp>
#include <optional>

#include "referee/referee_input.hpp"
#include "referee/touch/frame_history.hpp"
#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

struct BallTouch {
  std::optional<Side> side;      // none: unknown
  std::optional<RobotId> robot;  // none: unknown, or one of several of that side
  double began_s = 0;
  double ended_s = 0;                       // so far, of the newest
  double reported_s = 0;                    // time of the frame that first told of it
  Vec2 began_m{0, 0};                       // the ball as seen nearest to it
  Vec2 ended_m{0, 0};                       // and to its end
  std::optional<RobotObservation> toucher;  // where the robot was when it ended; none: not seen
  std::optional<double> apart_s;            // since when the ball has been away from that robot
  double highest_m = 0;                     // the ball's lowest point, from the touch to the next
  bool height_known = true;                 // during all of that
  bool rolled = false;                      // it has been on the carpet for 0.1 s, and still is
};

class TouchHistory {
 public:
  // Takes in one frame of play that was started at `began_s`.
  void update(const RefereeInput& input, double began_s);

  // Touches so far; only the newest of them are kept.
  int count() const { return count_; }
  int kept() const { return static_cast<int>(kept_.size()); }
  bool has(int back) const { return back < kept(); }
  // The `back`-th touch before the newest one; must be kept.
  const BallTouch& at(int back) const {
    return kept_[kept_.size() - 1 - static_cast<std::size_t>(back)];
  }
  const BallTouch* newest() const { return kept_.empty() ? nullptr : &kept_.back(); }
  // Whether no second robot has touched the ball; a touch by somebody unknown may be a second
  // robot's.
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

// Whether the detector will not tell the touch otherwise any more, but for rare cases.
bool is_settled(const BallTouch& touch, double now_s);

}  // namespace autoref::referee
