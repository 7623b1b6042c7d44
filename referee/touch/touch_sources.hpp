// Who sent the ball on a way of a hypothesis: a robot, a goal's post or wall, or nobody.
//
// A robot must have been where the way before leads and where the way after comes from
// (hull_intersections.hpp). The way before is known when the hypothesis begins; the way after shows
// in the detections that follow.
#pragma once

#include <cstdint>

#include "referee/touch/touch_hypothesis.hpp"

namespace autoref::referee {

// Whether a robot or a goal may have been at the ball's way from the frame `former` to the
// frame `now`; `onwards_m` is where it would be had nobody touched it.
bool may_be_touched(const HypothesisContext& basis, std::int64_t former, std::int64_t now,
                    const Vec2& onwards_m);

// What a touch by a goal's post or wall between these frames costs by the way before; kNever
// where there was none.
double goal_nll_of(const HypothesisContext& basis, std::int64_t former, std::int64_t now,
                   const Vec2& onwards_m);

// The robots that may have touched the ball between the frames `before` and `start` of the
// hypothesis, whose way still is the one before.
void find_touch_sources(TouchHypothesis& hypothesis, const HypothesisContext& basis);

// Weighs who sent the ball on the hypothesis's way, with its detections until the frame `now`. Once
// eight tell where it comes from, the explanations stay.
void weigh_sources(TouchHypothesis& hypothesis, std::int64_t now, const HypothesisContext& basis);

}  // namespace autoref::referee
