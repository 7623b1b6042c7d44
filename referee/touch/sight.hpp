// The referee's view of a game: the current frame, completed with estimates from the tracks, the
// ball, and who touched it in the current play.
#pragma once

#include <boost/container/static_vector.hpp>
#include <optional>

#include "referee/referee_configuration.hpp"
#include "referee/referee_input.hpp"
#include "referee/touch/frame_history.hpp"
#include "referee/touch/online_touch_detector.hpp"
#include "referee/touch/retrospective_touch_detector.hpp"
#include "soccer/frame.hpp"
#include "soccer/tracks.hpp"

namespace autoref::referee {

// Detects that the ball of a recorded or live game has been replaced: it is suddenly farther away
// than any ball can fly. A false detection disappears again, but a ball that somebody has moved
// stays at its new position.
class BallJumpFilter {
 public:
  static constexpr std::size_t kConfirmed = 3;  // consecutive detections at the new position
  using Frames = boost::container::static_vector<Frame, kConfirmed>;

  // Removes the ball from a frame if it is too far from the last accepted detection. Once
  // kConfirmed consecutive detections agree, the ball stays in the newest frame, and jumped()
  // returns the frames of all of them.
  void filter(Frame& frame);

  // The frames since the ball's jump, if this frame has confirmed it; otherwise empty.
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

  std::optional<Detection> last_;  // the last accepted detection
  Frames pending_;
  Frames jumped_;
};

class Sight {
 public:
  // If `ball_may_jump` (recorded and live games), a ball that is suddenly farther away than any
  // ball can fly is ignored until it has been seen at its new position several times.
  Sight(const Configuration& configuration, bool ball_may_jump);
  Sight(const Sight&) = delete;
  Sight& operator=(const Sight&) = delete;

  // Adds the next frame, without objects that have non-finite numbers or a ball that jumps. Returns
  // true if there was a long gap before this frame, in which case earlier frames are forgotten.
  // While play is stopped (`is_play` is false), a ball may jump, since people move it.
  bool add(const Frame& frame, bool is_play);

  // Adds the tracks' estimates of unseen robots and of a flying ball to the frame added last. Must
  // be called exactly once for each frame (asserted).
  void complete(const Tracks& tracks);

  // Whether a frame has been completed.
  bool has_begun() const { return has_begun_; }
  const Frame& frame() const { return frame_; }
  const Tracks& tracks() const { return tracks_; }
  const std::optional<BallSight>& ball() const { return ball_; }
  const FrameHistory& history() const { return history_; }
  const LastTouch& last_touch() const { return online_touch_.last(); }
  // The last touch, judged in hindsight from everything seen since then, for a ball that has just
  // left the field.
  LastTouch last_touch_in_hindsight() const {
    return retrospective_touch_.detect(online_touch_.last());
  }

  // Begins a new period of play in this frame, with the ball at rest at `ball_from_m`; nullopt if
  // its beginning was not seen.
  void begin_play(const Frame& frame, const std::optional<Vec2>& ball_from_m);
  // Forgets how the current play began, so the referee has to join play in this frame.
  void rejoin_play() { joins_ = true; }
  // The frame in which the current play has to be joined; null if the play is already being
  // followed.
  const Frame* frame_to_join() const;
  // Starts following play in frame_to_join(), which must not be null.
  void join_play();

  // Follows the ball and its touches through this frame, unless the play has to be joined in it.
  void follow_ball();

 private:
  void forget(bool is_play);
  void add_unseen_robots();
  void lift_ball();
  void see_ball();

  bool ball_may_jump_;
  Frame frame_;
  Tracks tracks_;
  std::optional<BallSight> ball_;
  bool has_begun_ = false;
  bool is_complete_ = true;              // whether frame_ is complete
  bool joins_ = false;                   // play is joined afresh in this frame
  std::optional<BeforeGap> before_gap_;  // used when joining play after a gap in vision
  bool was_lifted_ = false;              // whether lift_ball() moved the ball in the previous frame
  FrameHistory history_;                 // frames of the current play
  OnlineTouchDetector online_touch_;
  RetrospectiveTouchDetector retrospective_touch_;
  BallJumpFilter ball_jump_;
};

}  // namespace autoref::referee
