#include "league/followed_body.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/trigonometry.hpp"

namespace autoref::league {
namespace {

constexpr double kLongestExpectation_s = 0.5;
constexpr double kRecent_s = 0.25;  // older disagreements are not used
constexpr double kMostDisagreement_rad = 0.1;
constexpr double kJump_m = 0.3;  // the body was carried there, or it is another one
constexpr double kForgets_mps = 0.03;
constexpr double kForgets_radps = 0.03;

const Detected* view_of(std::uint32_t camera, std::span<const Detected> views) {
  const auto view = std::find_if(views.begin(), views.end(),
                                 [camera](const Detected& seen) { return seen.camera == camera; });
  return view == views.end() ? nullptr : &*view;
}

}  // namespace

Vec2 FollowedBody::expected_m(double time_s) const {
  return last_->position_m + std::min(time_s - seen_s_, kLongestExpectation_s) * velocity_mps_;
}

Detected FollowedBody::take(double time_s, std::span<const Detected> all, const Detected& chosen) {
  Detected used = chosen;
  if (last_ && used.camera != last_->camera) {
    for (const Detected& seen : all) {
      if (seen.camera == last_->camera &&
          (seen.position_m - chosen.position_m).norm() < kSameBody_m)
        used = seen;
    }
    if (used.camera != last_->camera) hand_over(time_s, used);
  }
  if (last_ && (used.position_m - expected_m(time_s)).norm() > kJump_m) {
    shift_m_ = Vec2(0, 0);
    turn_rad_ = 0;
  }
  note_views(time_s, all, used);
  const double duration_s = time_s - seen_s_;
  if (last_) forget_disagreement(duration_s);
  used.position_m += shift_m_;
  if (turn_rad_ != 0) used.heading = to_world(heading_of(turn_rad_), used.heading);
  const bool is_recent = last_ && duration_s > 0 && duration_s < kRecent_s;
  velocity_mps_ = is_recent ? Vec2((used.position_m - last_->position_m) / duration_s) : Vec2(0, 0);
  last_ = used;
  seen_s_ = time_s;
  return used;
}

void FollowedBody::hand_over(double time_s, const Detected& used) {
  const Detected* before = view_of(last_->camera, views_);
  const Detected* after = view_of(used.camera, views_);
  if (before == nullptr || after == nullptr || time_s - viewed_s_ > kRecent_s) {
    shift_m_ = Vec2(0, 0);
    turn_rad_ = 0;
    return;
  }
  shift_m_ += before->position_m - after->position_m;
  turn_rad_ += angle_between(after->heading, before->heading);
  if (shift_m_.norm() > kSameBody_m) shift_m_ = Vec2(0, 0);
  if (std::abs(turn_rad_) > kMostDisagreement_rad) turn_rad_ = 0;
}

void FollowedBody::forget_disagreement(double duration_s) {
  const double shift_m = shift_m_.norm();
  const double less_m = std::min(shift_m, kForgets_mps * duration_s);
  if (shift_m > 0) shift_m_ *= 1 - less_m / shift_m;
  const double less_rad = std::min(std::abs(turn_rad_), kForgets_radps * duration_s);
  turn_rad_ -= std::copysign(less_rad, turn_rad_);
}

void FollowedBody::note_views(double time_s, std::span<const Detected> all, const Detected& used) {
  const auto is_other_view = [&used](const Detected& seen) {
    return seen.camera != used.camera && (seen.position_m - used.position_m).norm() < kSameBody_m;
  };
  if (std::none_of(all.begin(), all.end(), is_other_view)) return;
  views_.assign(1, used);
  std::copy_if(all.begin(), all.end(), std::back_inserter(views_), is_other_view);
  viewed_s_ = time_s;
}

const Detected* nearest_to(const Vec2& position_m, std::span<const Detected> all) {
  const auto nearest =
      std::min_element(all.begin(), all.end(), [&](const Detected& one, const Detected& other) {
        return (one.position_m - position_m).squaredNorm() <
               (other.position_m - position_m).squaredNorm();
      });
  return nearest == all.end() ? nullptr : &*nearest;
}

}  // namespace autoref::league
