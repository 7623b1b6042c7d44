#include "referee/touch/hypothesis_tracker.hpp"

#include <algorithm>
#include <cmath>

#include "referee/touch/touch_hypothesis.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

// If the deviances of rolling and sliding differ by more than this, only the likelier of the two is
// kept.
constexpr double kRollsSurely = 20;
// Hypotheses with this much more deviance than the best one are pruned, because they cannot catch
// up. This is twice the deviance of a velocity change with no robot nearby.
constexpr double kTooUnlikely = 60;
constexpr double kLeastSliding_mps2 = 3.0;  // friction on the slickest carpet
constexpr double kBeforeKnown_s = 50_ms;    // the speed after a touch is not known earlier than
                                            // this
constexpr std::int64_t kLongestGap = 64;    // frames; after 1 s unseen, tracking starts over

}  // namespace

SideMinima HypothesisTracker::track(std::int64_t first, const SideMinima& before) {
  now_ = former_ = first;
  begin(before);
  for (std::int64_t i = first + 1; i <= basis_.frame_history.newest(); ++i) {
    if (!basis_.frame_history[i].has_ball) continue;
    former_ = now_;
    now_ = i;
    go_on();
  }
  return best_minima();
}

// Restarts tracking at this detection, with the per-side minima so far.
void HypothesisTracker::begin(const SideMinima& minima) {
  hypotheses_.clear();
  hypotheses_.emplace_back();
  TouchHypothesis& hypothesis = hypotheses_.back();
  hypothesis.motion.start(now().ball.position_m, basis_.parameters.motion);
  hypothesis.start = hypothesis.before = now_;
  hypothesis.detections = 1;
  hypothesis.untouched = hypothesis.minima = minima;
}

void HypothesisTracker::go_on() {
  if (now_ - former_ > kLongestGap) {
    begin(best_minima());
    return;
  }
  add_rolling();
  add_touch();
  follow();
  forget_unlikely();
}

// Branches the likeliest sliding hypothesis into one in which the ball begins to roll. If it has
// slid for as long as possible, it begins to roll without branching.
void HypothesisTracker::add_rolling() {
  const auto roll = [this](TouchHypothesis& hypothesis) {
    hypothesis.motion.begin_to_roll(basis_.parameters.motion);
    hypothesis.motion_deviance += basis_.parameters.roll_deviance;
  };
  for (TouchHypothesis& hypothesis : hypotheses_) {
    if (!hypothesis.motion.rolls() && !slides_still(hypothesis)) roll(hypothesis);
  }
  const TouchHypothesis* slides = cheapest_sliding();
  if (slides == nullptr) return;
  TouchHypothesis rolls = *slides;
  roll(rolls);
  hypotheses_.push_back(rolls);
}

const TouchHypothesis* HypothesisTracker::cheapest_sliding() const {
  const TouchHypothesis* cheapest = nullptr;
  for (const TouchHypothesis& hypothesis : hypotheses_) {
    if (hypothesis.motion.rolls() || hypothesis.detections < 2) continue;
    if (cheapest == nullptr || hypothesis.deviance() < cheapest->deviance()) cheapest = &hypothesis;
  }
  return cheapest;
}

// A solid sphere rolls once sliding has removed 2/7 (here 0.3) of the difference between its speed
// and its spin; the spin is at most that of a ball rolling before the touch.
bool HypothesisTracker::slides_still(const TouchHypothesis& hypothesis) const {
  const double former_mps = hypothesis.before_mps.norm();
  const double at_first_mps = 1.5 * hypothesis.motion.velocity_mps().norm();
  const double longest_s = 0.3 * (former_mps + at_first_mps) / kLeastSliding_mps2 + kBeforeKnown_s;
  return now().time_s - basis_.frame_history[hypothesis.start].time_s <= longest_s;
}

const TouchHypothesis& HypothesisTracker::cheapest() const {
  return *std::min_element(hypotheses_.begin(), hypotheses_.end(),
                           [](const TouchHypothesis& a, const TouchHypothesis& b) {
                             return a.deviance() < b.deviance();
                           });
}

// Gates the detection with the likeliest hypothesis. If it is outside the gate, or if a robot or
// goal was near enough, branches off a soft and a hard touch since the previous detection. The new
// hypotheses start from the per-side minima of all existing ones, and thus merge them.
void HypothesisTracker::add_touch() {
  const BallMotionParameters& parameters = basis_.parameters.motion;
  const BallMotionFilter& motion = cheapest().motion;
  BallMotionFilter onwards = motion;
  onwards.predict(since_former_s(), parameters);
  const Vec2 onwards_m = onwards.position_after(0);
  const double variance_m2 = onwards.position_variance_after(0) + square(parameters.detection_m);
  const bool turns = (now().ball.position_m - onwards_m).squaredNorm() >
                     square(basis_.parameters.surely) * variance_m2;
  if (!turns && !now().ball.jumps && !may_be_touched(basis_, former_, now_, onwards_m)) return;
  TouchHypothesis hypothesis = hypothesis_of_touch(motion, onwards_m);
  hypothesis.is_soft = true;
  hypotheses_.push_back(hypothesis);
  hypothesis.is_soft = false;
  hypotheses_.push_back(hypothesis);
}

TouchHypothesis HypothesisTracker::hypothesis_of_touch(const BallMotionFilter& motion,
                                                       const Vec2& onwards_m) const {
  TouchHypothesis hypothesis;
  hypothesis.motion = motion;
  hypothesis.start = now_;
  hypothesis.before = former_;
  hypothesis.before_mps = motion.velocity_mps();
  hypothesis.goal_deviance = goal_deviance_of(basis_, former_, now_, onwards_m);
  hypothesis.jumps = now().ball.jumps;
  hypothesis.minima = hypothesis.untouched = best_minima();
  hypothesis.deviance_until_touch = hypothesis.minima.least() + basis_.parameters.touch_deviance;
  const double lowest_m =
      std::min(now().ball.height_m, basis_.frame_history[former_].ball.height_m);
  if (lowest_m <= kRobotHeight_m) find_touch_sources(hypothesis, basis_);
  return hypothesis;
}

void HypothesisTracker::follow() {
  if (now().ball.jumps) {
    follow_jump();
    return;
  }
  for (TouchHypothesis& hypothesis : hypotheses_) {
    follow(hypothesis);
    // Hypotheses with the same start share the same touch, whether the ball slid or rolled
    // afterwards, so that touch is weighed only once.
    const auto twin = std::find_if(
        hypotheses_.begin(), hypotheses_.end(),
        [&hypothesis](const TouchHypothesis& other) { return other.start == hypothesis.start; });
    if (&*twin == &hypothesis) {
      weigh_sources(hypothesis, now_, basis_);
    } else {
      hypothesis.minima = twin->minima;
    }
  }
}

// A jump ends all hypotheses except the newest, which starts at the jump.
void HypothesisTracker::follow_jump() {
  hypotheses_.erase(hypotheses_.begin(), hypotheses_.end() - 1);
  TouchHypothesis& hypothesis = hypotheses_.back();
  hypothesis.motion.jump(now().ball.position_m, basis_.parameters.motion);
  ++hypothesis.detections;
  weigh_sources(hypothesis, now_, basis_);
}

void HypothesisTracker::follow(TouchHypothesis& hypothesis) const {
  const TouchHypothesisParameters& p = basis_.parameters;
  const bool is_new = hypothesis.start == now_;
  if (!is_new && now_ - former_ > 1) {
    // A ball that vision does not see cannot pass through robots either.
    const Walk unseen =
        walk(hypothesis.motion, basis_.frame_history, former_, now_, p.intersection);
    hypothesis.motion_deviance += std::min(unseen.through_deviance, p.unlikely_deviance);
  }
  hypothesis.motion.predict(since_former_s(), p.motion);
  if (is_new) hypothesis.motion.touch(since_former_s(), hypothesis.is_soft, p.motion);
  hypothesis.motion_deviance += hypothesis.motion.correct(now().ball.position_m, p.motion);
  ++hypothesis.detections;
}

SideMinima HypothesisTracker::best_minima() const {
  SideMinima best;
  for (const TouchHypothesis& hypothesis : hypotheses_) {
    for (const Toucher toucher : {kNobody, kWest, kEast}) {
      best.offer(toucher, hypothesis.minima.deviance[toucher] + hypothesis.motion_deviance,
                 hypothesis.minima.touch[toucher]);
    }
  }
  return best;
}

void HypothesisTracker::forget_unlikely() {
  Deviances deviances;
  for (const TouchHypothesis& hypothesis : hypotheses_) deviances.push_back(hypothesis.deviance());
  double most = *std::min_element(deviances.begin(), deviances.end()) + kTooUnlikely;
  strike_twins(deviances);
  if (deviances.size() > kMostHypotheses) {
    Deviances sorted = deviances;
    std::nth_element(sorted.begin(), sorted.begin() + kMostHypotheses - 1, sorted.end());
    most = std::min(most, sorted[kMostHypotheses - 1]);
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < deviances.size(); ++i) {
    if (deviances[i] > most || kept == kMostHypotheses) continue;
    if (kept != i) hypotheses_[kept] = hypotheses_[i];
    ++kept;
  }
  hypotheses_.resize(kept);
}

// Merges hypotheses that begin with the same touch: only the likelier one is kept once the ball
// rolls in both of them, or once their deviances differ clearly.
void HypothesisTracker::strike_twins(Deviances& deviances) const {
  for (std::size_t i = 0; i < deviances.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const TouchHypothesis& a = hypotheses_[i];
      const TouchHypothesis& b = hypotheses_[j];
      if (a.start != b.start || a.is_soft != b.is_soft) continue;
      const bool both_roll = a.motion.rolls() && b.motion.rolls();
      if (!both_roll && std::abs(deviances[i] - deviances[j]) < kRollsSurely) continue;
      deviances[deviances[i] < deviances[j] ? j : i] = kNever;
    }
  }
}

}  // namespace autoref::referee
