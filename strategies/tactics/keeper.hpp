// The goalkeeper, and the part of the team's own goal that the team's robots leave open to a shot.
#pragma once

#include <optional>

#include "strategies/tactics/predicted_state.hpp"

namespace autoref::strategies {

// How the keeper covers the goal line. Contains half the width of the keeper's shadow for a shot
// from the threat, where the middle of the shadow would be without team-mates, and the point at
// which a shooter aims, if it aims at the goal.
struct KeeperShadow {
  double half_width_m = 0;
  double usual_y_m = 0;
  std::optional<double> aim_y_m;
};

// The y coordinate of the point of the team's own goal line at which the keeper's shadow covers
// most of the part that the other robots leave open to a shot from predicted.threat_m(). The middle
// of a gap counts more than its ends, and the point at which the shooter aims counts more than
// other points. Of equally good points, the one nearest to the usual point is chosen. Returns
// nullopt if the other robots leave no gap, or if the shot comes from beside the goal or from far
// in the other half.
std::optional<double> gap_for_keeper_m(const PredictedState& predicted, const KeeperShadow& keeper);

// The keeper's position. If the ball is going into the goal, this position is in the ball's path.
// Otherwise it is on the bisector of the goal's angle as seen from the ball, at a distance of
// keeper_out_m (style) in front of the goal line. If an opponent with the ball aims at a point in
// or near the goal, the position is shifted towards that point.
Waypoint keeper_position(const PredictedState& predicted, const TrackedRobot& keeper);

// Commands for the keeper (the robot with that index) while it does not play the ball.
RobotCommand keep_goal(const PredictedState& predicted, int index);

// Whether the ball is at a position where only the keeper should play it, and slow enough for the
// keeper to fetch it.
bool is_keepers_ball(const PredictedState& predicted);

}  // namespace autoref::strategies
