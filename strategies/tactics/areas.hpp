// Keeping robots clear of the defence areas and out of the goals. The style's around_boxes and
// area_braking_mps2 switch these on.
#pragma once

#include <optional>

#include "strategies/tactics/predicted_state.hpp"

namespace autoref::strategies {

// The point for which to steer on the way to `target_m`: a corner of a box-shaped area if the
// straight path leads through it; the shortest way out if the robot must leave the opponents' area;
// otherwise the target.
Vec2 around_boxes(const PredictedState& predicted, const TrackedRobot& robot, const Vec2& target_m);

// The point to drive to out of the opponents' goal; nullopt elsewhere.
std::optional<Vec2> exit_from_goal(const PredictedState& predicted, const TrackedRobot& robot);

// The part of `velocity_mps` that lets a point, at `room_m` from the area of `side` beyond the
// distance to keep, stop in time with the style's area_braking_mps2.
Vec2 slowed_before_area(const PredictedState& predicted, Side side, const Vec2& point_m,
                        double room_m, const Vec2& velocity_mps);

// Reduces the command's velocity towards areas that the robot with that index, a field player, must
// keep out of while the ball is in play, and towards the opponents' goal, so that it can stop
// before them.
void stay_out_of_areas(const PredictedState& predicted, int index, RobotCommand& command);

}  // namespace autoref::strategies
