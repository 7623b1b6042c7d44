// Keeping robots clear of the defence areas and out of the goals. Enabled by the style's
// around_boxes and area_braking_mps2.
#pragma once

#include <optional>

#include "strategies/tactics/predicted_state.hpp"

namespace autoref::strategies {

// The point to steer for on the way to `target_m`. If the straight path leads through a box-shaped
// area, the point is a corner of the area. If the robot must leave the opponents' area, the point
// is on the shortest way out. Otherwise the point is the target.
Vec2 around_boxes(const PredictedState& predicted, const TrackedRobot& robot, const Vec2& target_m);

// The point to drive to in order to leave the opponents' goal; nullopt if the robot is elsewhere.
std::optional<Vec2> exit_from_goal(const PredictedState& predicted, const TrackedRobot& robot);

// The part of `velocity_mps` at which a point can still stop in time with the style's
// area_braking_mps2. `room_m` is the point's distance from the area of `side`, minus the distance
// to keep from it.
Vec2 slowed_before_area(const PredictedState& predicted, Side side, const Vec2& point_m,
                        double room_m, const Vec2& velocity_mps);

// Reduces the commanded velocity of the field player with that index towards the opponents' goal
// and the areas that it must keep out of while the ball is in play, so that it can stop in front of
// them.
void stay_out_of_areas(const PredictedState& predicted, int index, RobotCommand& command);

}  // namespace autoref::strategies
