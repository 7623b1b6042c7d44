// Who touched the ball since play was started, in order, and what the ball did between the touches.
//
// It is made of the last touch as the detector tells it from frame to frame: touches by the same
// robot without a pause are one, and a touch that the detector tells otherwise a moment later is
// changed, too.
#pragma once

#include <boost/container/static_vector.hpp>
#include <optional>

#include "referee/moment.hpp"
#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

struct BallTouch {
  std::optional<Side> side;      // none: unknown
  std::optional<RobotId> robot;  // none: unknown, or one of several of that side
  double began_s = 0;
  double ended_s = 0;        // so far, of the newest
  Vec2 began_m{0, 0};        // the ball when it was known
  double highest_m = 0;      // the ball's lowest point, from the touch to the next
  bool height_known = true;  // during all of that
  bool rolled = false;       // lay or rolled on the carpet after the touch, for 0.1 s
};

class TouchHistory {
 public:
  // Takes in one frame of play that was started at `began_s`.
  void update(const Moment& moment, double began_s);

  // Touches so far; only the newest of them are kept.
  int count() const { return count_; }
  bool has(int back) const { return back < static_cast<int>(kept_.size()); }
  // The `back`-th touch before the newest one; must be kept.
  const BallTouch& at(int back) const {
    return kept_[kept_.size() - 1 - static_cast<std::size_t>(back)];
  }
  const BallTouch* newest() const { return kept_.empty() ? nullptr : &kept_.back(); }

 private:
  void take_in(const LastTouch& told, const Vec2& ball_m);
  void follow_ball(BallTouch& touch, const BallSight& ball, double now_s);

  static constexpr std::size_t kKept = 4;
  boost::container::static_vector<BallTouch, kKept> kept_;
  int count_ = 0;
  std::optional<double> on_carpet_since_s_;  // since the newest touch
};

}  // namespace autoref::referee
