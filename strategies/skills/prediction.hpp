// Simple prediction of robots and ball, to compensate for the view's latency.
#pragma once

#include "soccer/team_view.hpp"

namespace autoref::strategies {

// The ball's position `ahead_s` from now, at a constant deceleration between the carpet's sliding
// and rolling values.
Vec2 ball_after(const TrackedBall& ball, double ahead_s);

// `view` extrapolated by its latency, to when commands given now take effect.
void look_ahead(const TeamView& view, TeamView& ahead);

// Rough estimate of the time in seconds that a robot needs to reach a point, from rest to rest, at
// the teams' usual speeds.
double travel_time_s(const TrackedRobot& robot, const Vec2& point_m);

struct Interception {
  Vec2 point_m{0, 0};
  double time_s = 0;  // until the robot arrives
};

// Where `robot` can first meet the rolling ball; if it cannot catch up, the ball's position in 2 s.
Interception intercept(const TrackedRobot& robot, const TrackedBall& ball);

}  // namespace autoref::strategies
