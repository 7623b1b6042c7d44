// Detects that the ball of a recorded or live game has been replaced: that it is suddenly farther
// away than any ball can fly. A false detection does not last; a ball that somebody has put
// elsewhere does.
#pragma once

#include <boost/container/static_vector.hpp>
#include <optional>

#include "soccer/frame.hpp"

namespace autoref::referee {

class BallJumpFilter {
 public:
  static constexpr std::size_t kConfirmed = 3;  // detections at the new place, in a row
  using Frames = boost::container::static_vector<Frame, kConfirmed>;

  // Removes the ball from a frame if it is too far from the last accepted one. Once kConfirmed
  // successive balls agree, the newest is kept; the frames with all of them are then in jumped().
  void filter(Frame& frame);

  // The frames since the ball's jump if this frame has confirmed it, otherwise empty.
  const Frames& jumped() const { return jumped_; }

  void forget();

 private:
  struct Detection {
    Vec2 position_m{0, 0};
    Vec2 camera_m{0, 0};
    double time_s = 0;
  };
  static Detection detection_in(const Frame& frame);
  static bool is_possible(const Detection& from, const Detection& to);
  bool follows_pending(const Detection& now) const;

  std::optional<Detection> last_;  // accepted
  Frames pending_;
  Frames jumped_;
};

}  // namespace autoref::referee
