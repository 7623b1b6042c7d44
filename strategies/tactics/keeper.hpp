// The goalkeeper, and the part of the team's own goal that its robots leave open to a shot.
#pragma once

#include <optional>

#include "strategies/tactics/predicted_state.hpp"

namespace autoref::strategies {

// How the keeper covers the goal line: half the width of its shadow for a shot from the threat,
// where the middle of the shadow would be without team-mates, and the point at which a shooter
// aims, if it aims at the goal.
struct KeeperShadow {
  double half_width_m = 0;
  double usual_y_m = 0;
  std::optional<double> aim_y_m;
};

// The y coordinate of the point of the team's own goal line at which the keeper's shadow covers
// most of the part that the other robots leave open to a shot from predicted.threat_m(). The middle
// of a gap counts more than its ends, and the shooter's aim counts more than other points; of
// equally good points, the one nearest to the usual point is chosen. Returns nullopt if they leave
// no gap, or if the shot comes from beside the goal or from far in the other half.
std::optional<double> gap_for_keeper_m(const PredictedState& predicted, const KeeperShadow& keeper);

// The keeper's position. If the ball is going into the goal, it is in the ball's path. Otherwise it
// is on the bisector of the goal's angle as seen from the ball, the style's keeper_out_m in front
// of the goal line, shifted towards the point at which an opponent with the ball aims, if that
// point is in or near the goal.
Waypoint keeper_position(const PredictedState& predicted, const TrackedRobot& keeper);

// Commands for the keeper (the robot with that index) while it does not play the ball.
RobotCommand keep_goal(const PredictedState& predicted, int index);

// Whether the ball is where only the keeper should play it, and slow enough to be fetched.
bool is_keepers_ball(const PredictedState& predicted);

}  // namespace autoref::strategies
