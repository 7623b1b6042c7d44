// The goalkeeper, and the part of the team's own goal that its robots leave open to a shot.
#pragma once

#include <optional>

#include "strategies/tactics/predicted_state.hpp"

namespace autoref::strategies {

// How the keeper covers the goal line: half the width of its shadow, for a shot from the threat,
// where its middle would be without team-mates, and the point at which a shooter aims, if it aims
// at the goal.
struct KeeperShadow {
  double half_width_m = 0;
  double usual_y_m = 0;
  std::optional<double> aim_y_m;
};

// The point of the team's own goal line, by its y coordinate, at which the keeper's shadow covers
// most of what the other robots leave open to a shot from predicted.threat_m(). The middle of a gap
// counts more than its ends, the shooter's aim more than other points, and of equal points the one
// nearest to the usual one. Returns nullopt if they
// leave nothing open, or if the shot comes from beside the goal or from far in the other half.
std::optional<double> gap_for_keeper_m(const PredictedState& predicted, const KeeperShadow& keeper);

// The keeper's position: in the path of a ball that is going into the goal; otherwise on the
// bisector of the goal's angle seen from the ball, the style's keeper_out_m ahead of the goal line,
// shifted towards the point at which an opponent with the ball aims, if that point is in or near
// the goal.
Waypoint keeper_position(const PredictedState& predicted, const TrackedRobot& keeper);

// Commands for the keeper (the robot with that index) while it does not play the ball.
RobotCommand keep_goal(const PredictedState& predicted, int index);

// Whether the ball is where only the keeper should play it, and slow enough to be fetched.
bool is_keepers_ball(const PredictedState& predicted);

}  // namespace autoref::strategies
