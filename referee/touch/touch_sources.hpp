// What caused the touch that a hypothesis begins with: a robot, a goal's post or wall, or nothing.
//
// The path before the touch must lead to the robot's hull, and the path after it must come from
// there (hull_intersections.hpp). The path before is known when the hypothesis begins; the path
// after is estimated from the detections that follow.
#pragma once

#include <cstdint>

#include "referee/touch/touch_hypothesis.hpp"

namespace autoref::referee {

// Whether a robot or a goal may have been on the ball's path from the frame `former` to the frame
// `now`; `onwards_m` is the predicted position of an untouched ball.
bool may_be_touched(const HypothesisContext& basis, std::int64_t former, std::int64_t now,
                    const Vec2& onwards_m);

// Deviance of a bounce off a goal's post or wall between these frames, given the path before;
// kNever if no goal is near.
double goal_deviance_of(const HypothesisContext& basis, std::int64_t former, std::int64_t now,
                        const Vec2& onwards_m);

// Lists the robots that may have touched the ball between the frames `before` and `start` of the
// hypothesis. The hypothesis must still contain the motion before the touch.
void find_touch_sources(TouchHypothesis& hypothesis, const HypothesisContext& basis);

// Updates the per-side minima of the hypothesis with its detections until the frame `now`. They are
// final after eight detections.
void weigh_sources(TouchHypothesis& hypothesis, std::int64_t now, const HypothesisContext& basis);

}  // namespace autoref::referee
