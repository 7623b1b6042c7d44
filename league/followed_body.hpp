// One robot or ball through the detections of several cameras.
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

  // Takes the detections of a frame, of which `chosen` is the body; prefers a detection of the same
  // body by the last camera. Returns the detection used, and corrected, if another camera was used
  // before.
  Detected take(double time_s, std::span<const Detected> all, const Detected& chosen);

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

}  // namespace autoref::league
