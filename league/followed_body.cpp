#include "league/followed_body.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/trigonometry.hpp"

namespace autoref::league {
namespace {

constexpr double kLongestExpectation_s = 0.5;
constexpr double kRecent_s = 0.25;  // older disagreements are not used
constexpr double kMostDisagreement_rad = 0.1;
// Over a longer distance, the body was carried, or it is a different body.
constexpr double kJump_m = 0.3;
constexpr double kForgets_mps = 0.03;
constexpr double kForgets_radps = 0.03;

const Detected* view_of(std::uint32_t camera, std::span<const Detected> views) {
  const auto view = std::find_if(views.begin(), views.end(),
                                 [camera](const Detected& seen) { return seen.camera == camera; });
  return view == views.end() ? nullptr : &*view;
}

constexpr double kAnyway_m = 0.3;   // a distance that a body may always have moved
constexpr double kKicked_mps = 12;  // above any kick, including the parallax of a chip
constexpr double kCarried_mps = 3;  // speed of a robot that carries and hides the ball
constexpr double kOtherNoise_m = 0.05;
constexpr double kLongestMotion_s = 0.1;
constexpr double kForgotten_s = 3;
// Waiting time for a moving ball that appeared after the followed one.
constexpr double kSuccessor_s = 0.1;
constexpr double kStill_s = 0.5;  // waiting time for a ball that lies still
// Waiting time for a ball that was seen together with the followed one.
constexpr double kTogether_s = 3;
constexpr double kStill_m = 0.1;
constexpr double kLiesStill_s = 2;
constexpr double kMoves_m = 0.5;
constexpr std::int64_t kRareOthers = 1;  // detections within kForgotten_s
constexpr std::size_t kMostOthers = 64;

// How far another ball may have moved since it was seen.
double reach_of_other_m(double hidden_s) {
  return kOtherNoise_m + kCarried_mps * std::min(hidden_s, kLongestMotion_s);
}

bool is_near(const Vec2& one_m, const Vec2& other_m, double distance_m) {
  return (one_m - other_m).squaredNorm() <= distance_m * distance_m;
}

// Whether these detections show one ball, perhaps seen by several cameras.
bool is_one_ball(std::span<const Detected> all) {
  return !all.empty() && std::all_of(all.begin(), all.end(), [&](const Detected& seen) {
    return is_near(seen.position_m, all[0].position_m, FollowedBody::kSameBody_m);
  });
}

}  // namespace

Vec2 FollowedBody::expected_m(double time_s) const {
  return last_->position_m + std::min(time_s - seen_s_, kLongestExpectation_s) * velocity_mps_;
}

Detected FollowedBody::add(double time_s, std::span<const Detected> all, const Detected& chosen) {
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

const Detected* BallChoice::choose(double time_s, std::span<const Detected> all) {
  const Detected* chosen = find_followed(time_s, all);
  const Detected* successor = find_successor(time_s, all);
  if (successor != nullptr) {
    ball_.forget();
    chosen = successor;
  }
  note_others(time_s, all, chosen);
  if (chosen != nullptr) follow(time_s, all, *chosen);
  latest_s_ = time_s;
  ++frames_;
  return chosen == nullptr ? nullptr : &used_;
}

void BallChoice::follow(double time_s, std::span<const Detected> all, const Detected& chosen) {
  const bool is_new =
      !ball_.is_known() || (time_s - ball_.seen_s() > kSuccessor_s &&
                            !is_near(chosen.position_m, ball_.expected_m(time_s), kAnyway_m));
  used_ = ball_.add(time_s, all, chosen);
  if (is_new) since_s_ = time_s;
  if (!is_new && is_near(used_.position_m, rest_m_, kStill_m)) return;
  rest_m_ = used_.position_m;
  rest_s_ = time_s;
}

// Whether the followed ball, if it is hidden, can reappear there.
bool BallChoice::may_be_at(const Vec2& position_m, double time_s) const {
  const double hidden_s = time_s - ball_.seen_s();
  const double reach_m =
      kAnyway_m + kKicked_mps * std::min(hidden_s, time_s - latest_s_) + kCarried_mps * hidden_s;
  return is_near(position_m, ball_.position_m(), reach_m) ||
         is_near(position_m, ball_.expected_m(time_s), kAnyway_m);
}

const Detected* BallChoice::find_followed(double time_s, std::span<const Detected> all) const {
  if (!ball_.is_known()) {
    const auto best = std::max_element(
        all.begin(), all.end(),
        [](const Detected& a, const Detected& b) { return a.confidence < b.confidence; });
    return best == all.end() ? nullptr : &*best;
  }
  const Vec2 expected_m = ball_.expected_m(time_s);
  const Detected* nearest = nullptr;
  for (const Detected& seen : all) {
    if (!may_be_at(seen.position_m, time_s) || is_other(time_s, seen)) continue;
    if (nearest == nullptr || (seen.position_m - expected_m).squaredNorm() <
                                  (nearest->position_m - expected_m).squaredNorm())
      nearest = &seen;
  }
  return nearest;
}

// Whether this is a known other ball: the detection is at least as near to where that ball was last
// seen as to the expected position of the followed ball.
bool BallChoice::is_other(double time_s, const Detected& seen) const {
  const double away_m = (seen.position_m - ball_.expected_m(time_s)).norm();
  return std::any_of(others_.begin(), others_.end(), [&](const OtherBall& other) {
    const double reach_m = reach_of_other_m(time_s - other.seen_s);
    return other.was_beside && is_steady(other) && other.seen.camera == seen.camera &&
           is_near(seen.position_m, other.seen.position_m, std::min(reach_m, away_m));
  });
}

BallChoice::OtherBall* BallChoice::other_at(double time_s, const Detected& seen) {
  OtherBall* nearest = nullptr;
  for (OtherBall& other : others_) {
    const double reach_m = reach_of_other_m(time_s - other.seen_s);
    if (other.seen.camera != seen.camera ||
        !is_near(seen.position_m, other.seen.position_m, reach_m))
      continue;
    if (nearest == nullptr || (seen.position_m - other.seen.position_m).squaredNorm() <
                                  (seen.position_m - nearest->seen.position_m).squaredNorm())
      nearest = &other;
  }
  return nearest;
}

// False detections come and go, so a ball is steady if it was seen in at least half of the frames
// since it appeared.
bool BallChoice::is_steady(const OtherBall& other) const {
  return 2 * other.frames >= frames_ - other.first_frame;
}

bool BallChoice::replaces(const OtherBall& other, double time_s) const {
  if (!is_steady(other)) return false;
  const auto has_moved = [&other](double distance_m) {
    return !is_near(other.seen.position_m, other.first_m, distance_m);
  };
  const bool lies_still = time_s - rest_s_ > kLiesStill_s || rest_s_ <= since_s_;
  if (other.was_beside && has_moved(kMoves_m) && lies_still) return true;
  const bool may_be_ours = other.first_s > since_s_ || has_moved(kStill_m);
  const double together_s =
      may_be_ours ? std::min(kTogether_s, ball_.seen_s() - since_s_) : kTogether_s;
  const double wait_s = other.was_beside ? together_s : 0;
  const double least_s = has_moved(kStill_m) ? kSuccessor_s : kStill_s;
  return time_s - ball_.seen_s() > std::max(wait_s, kSuccessor_s) &&
         time_s - other.first_s >= least_s;
}

const Detected* BallChoice::find_successor(double time_s, std::span<const Detected> all) {
  if (!ball_.is_known()) return nullptr;
  std::int64_t beside = 0;
  for (const OtherBall& other : others_) beside += other.was_beside ? other.frames : 0;
  if (beside <= kRareOthers && is_one_ball(all) && find_followed(time_s, all) == nullptr)
    return &all[0];
  for (const Detected& seen : all) {
    const OtherBall* other = other_at(time_s, seen);
    if (other == nullptr || !replaces(*other, time_s)) continue;
    others_.erase(others_.begin() + (other - others_.data()));
    return &seen;
  }
  return nullptr;
}

void BallChoice::note_others(double time_s, std::span<const Detected> all, const Detected* chosen) {
  std::erase_if(others_,
                [time_s](const OtherBall& other) { return time_s - other.seen_s > kForgotten_s; });
  for (const Detected& seen : all) {
    const bool is_same = chosen != nullptr &&
                         is_near(seen.position_m, chosen->position_m, FollowedBody::kSameBody_m);
    if (is_same) continue;
    OtherBall* other = other_at(time_s, seen);
    if (other == nullptr) {
      if (others_.size() >= kMostOthers) continue;
      others_.push_back({seen, seen.position_m, time_s, time_s, frames_, 0, false});
      other = &others_.back();
    }
    other->seen = seen;
    other->seen_s = time_s;
    ++other->frames;
    if (chosen != nullptr && chosen->camera == seen.camera) other->was_beside = true;
  }
}

}  // namespace autoref::league
