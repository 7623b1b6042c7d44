// One robot or ball through the detections of several cameras, and which of several balls is
// followed.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "soccer/geometry.hpp"

namespace autoref::league {

// One detection by one camera.
struct Detected {
  std::uint32_t camera = 0;
  float confidence = 0;
  Vec2 position_m{0, 0};
  Vec2 heading{1, 0};
};

// Cameras disagree by some 20 mm, so that a robot or ball would jump whenever another camera is
// used. It therefore stays with its camera as long as that camera sees it. Then the other camera's
// detection is moved and turned by their latest disagreement, which is forgotten slowly.
class FollowedBody {
 public:
  // Detections of one frame within this distance are the same body seen by several cameras.
  static constexpr double kSameBody_m = 0.06;

  bool is_known() const { return last_.has_value(); }
  double seen_s() const { return seen_s_; }  // the last detection
  const Vec2& position_m() const { return last_->position_m; }
  std::uint32_t camera() const { return last_->camera; }

  // Where the body is if it has kept its velocity for `time_s`, at most 0.5 s. It must be known.
  Vec2 expected_m(double time_s) const;

  // Adds the detections of a frame, of which `chosen` is the body; prefers a detection of the same
  // body by the last camera. Returns the detection used, and corrected, if another camera was used
  // before.
  Detected add(double time_s, std::span<const Detected> all, const Detected& chosen);

  void forget() { *this = {}; }

 private:
  void hand_over(double time_s, const Detected& used);
  void forget_disagreement(double duration_s);
  void note_views(double time_s, std::span<const Detected> all, const Detected& used);

  std::optional<Detected> last_;
  double seen_s_ = 0;
  Vec2 velocity_mps_{0, 0};
  Vec2 shift_m_{0, 0};           // added to detections
  double turn_rad_ = 0;          // added to headings
  std::vector<Detected> views_;  // the body in the last frame in which several cameras saw it
  double viewed_s_ = 0;
};

// The detection nearest to `position_m`; nullptr if there is none.
const Detected* nearest_to(const Vec2& position_m, std::span<const Detected> all);

// Decides which of the balls that vision reports is the one in play. Follows one ball; at first,
// the most confident one. While it is hidden, it may appear again where a robot may have carried it
// or where its velocity brings it; a ball elsewhere, or one that a camera sees beside it in most
// frames, is another ball and remains one. Another ball takes the followed one's place
// - if it is the only one in the frame and at most one has been seen beside the followed one in the
//   last 3 s: at once, since it may just be kicked there, and false detections are rare then;
// - if the followed ball has disappeared and the other one was not seen beside it: after 0.1 s if
//   it moves, else after 0.5 s;
// - if both were seen together: 3 s after the followed one has disappeared, or as long after it as
//   it was followed, if the other one appeared later or moves;
// - if the followed ball lies still for 2 s, or since it appeared, while the other moves by 0.5 m.
class BallChoice {
 public:
  // Returns the detection of the ball in play, or nullptr if it is not among `all`, the detections
  // of one frame. Times must increase.
  const Detected* choose(double time_s, std::span<const Detected> all);

 private:
  struct OtherBall {
    Detected seen;
    Vec2 first_m{0, 0};
    double first_s = 0;
    double seen_s = 0;
    std::int64_t first_frame = 0;
    std::int64_t frames = 0;  // in which it was seen
    bool was_beside = false;  // together with the followed ball
  };

  const Detected* find_followed(double time_s, std::span<const Detected> all) const;
  const Detected* find_successor(double time_s, std::span<const Detected> all);
  bool is_steady(const OtherBall& other) const;
  bool replaces(const OtherBall& other, double time_s) const;
  void note_others(double time_s, std::span<const Detected> all, const Detected* chosen);
  OtherBall* other_at(double time_s, const Detected& seen);
  bool may_be_at(const Vec2& position_m, double time_s) const;
  bool is_other(double time_s, const Detected& seen) const;
  void follow(double time_s, std::span<const Detected> all, const Detected& chosen);

  FollowedBody ball_;
  double since_s_ = 0;   // followed since then, with short gaps
  double latest_s_ = 0;  // the latest frame
  std::int64_t frames_ = 0;
  Vec2 rest_m_{0, 0};  // the ball has been near this position
  double rest_s_ = 0;  // since then
  std::vector<OtherBall> others_;
  Detected used_;
};

}  // namespace autoref::league
