// Follows one robot or ball through the detections of several cameras, and decides which of several
// balls to follow.
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

// Cameras disagree by some 20 mm, so a robot or ball would jump whenever another camera is used.
// Therefore, one camera's detections of the body are used as long as that camera sees it. After a
// change, the new camera's detections are corrected by the latest difference in position and
// heading between the two cameras. This correction slowly fades.
class FollowedBody {
 public:
  // Detections of one frame within this distance are the same body seen by several cameras.
  static constexpr double kSameBody_m = 0.06;

  bool is_known() const { return last_.has_value(); }
  double seen_s() const { return seen_s_; }  // time of the last detection
  const Vec2& position_m() const { return last_->position_m; }
  std::uint32_t camera() const { return last_->camera; }

  // The body's position at `time_s` if it has kept its velocity, which is assumed for at most 0.5
  // s. The body must be known.
  Vec2 expected_m(double time_s) const;

  // Adds the detections of a frame; `chosen` is the body among them. A detection of the same body
  // by the camera used last is preferred. Returns the detection used, corrected if another camera
  // was used before.
  Detected add(double time_s, std::span<const Detected> all, const Detected& chosen);

  void forget() { *this = {}; }

 private:
  void hand_over(double time_s, const Detected& used);
  void forget_disagreement(double duration_s);
  void note_views(double time_s, std::span<const Detected> all, const Detected& used);

  std::optional<Detected> last_;
  double seen_s_ = 0;
  Vec2 velocity_mps_{0, 0};
  Vec2 shift_m_{0, 0};           // correction added to detected positions
  double turn_rad_ = 0;          // correction added to headings
  std::vector<Detected> views_;  // the body in the last frame in which several cameras saw it
  double viewed_s_ = 0;
};

// The detection nearest to `position_m`; nullptr if there is none.
const Detected* nearest_to(const Vec2& position_m, std::span<const Detected> all);

// Decides which of the balls reported by vision is the one in play. One ball is followed; at first,
// it is the one with the highest confidence. While this ball is hidden, it can reappear where a
// robot may have carried it or where its velocity takes it. A ball elsewhere is another ball, and
// remains another ball. So is a ball that its camera sees together with the followed ball in most
// frames. Another ball replaces the followed ball
// - immediately, if it is the only ball in the frame and at most one detection of another ball was
//   seen together with the followed ball in the last 3 s: false detections are then rare, so the
//   followed ball may just have been kicked there;
// - if the two were never seen together and the followed ball has disappeared: 0.1 s after the
//   other ball appeared if that moves, or 0.5 s after it appeared if it does not;
// - 3 s after the followed ball disappeared, if the two were seen together. If the other ball
//   appeared later or moves, the wait is at most as long as the ball was followed;
// - if the two were seen together and the other ball moves by 0.5 m, while the followed ball has
//   lain still for 2 s or ever since it appeared.
class BallChoice {
 public:
  // Returns the detection of the ball in play, or nullptr if that ball is not in `all`, the
  // detections of one frame. Times must increase from call to call.
  const Detected* choose(double time_s, std::span<const Detected> all);

 private:
  struct OtherBall {
    Detected seen;
    Vec2 first_m{0, 0};
    double first_s = 0;
    double seen_s = 0;
    std::int64_t first_frame = 0;
    std::int64_t frames = 0;  // number of frames in which this ball was seen
    bool was_beside = false;  // whether this ball was seen together with the followed ball
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
  double since_s_ = 0;   // time since which the ball has been followed, including short gaps
  double latest_s_ = 0;  // time of the latest frame
  std::int64_t frames_ = 0;
  Vec2 rest_m_{0, 0};  // the ball has stayed near this position since `rest_s_`
  double rest_s_ = 0;  // since this time
  std::vector<OtherBall> others_;
  Detected used_;
};

}  // namespace autoref::league
