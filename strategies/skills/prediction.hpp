// Where things will be: what a team plans with instead of the delayed frame.
#pragma once

#include "soccer/team_view.hpp"

namespace autoref::strategies {

// The ball's position `ahead_s` from now, rolling on straight and slowing down evenly; a mean
// between the carpet's sliding and rolling deceleration.
Vec2 ball_after(const TrackedBall& ball, double ahead_s);

// `view` as it will be when commands given now take effect: all moved on by its latency.
void look_ahead(const TeamView& view, TeamView& ahead);

// Seconds a robot needs to a point, from rest to rest at team speeds; a rough estimate.
double travel_time_s(const TrackedRobot& robot, const Vec2& point_m);

struct Interception {
  Vec2 point_m{0, 0};
  double time_s = 0;  // until the robot is there
};

// Where `robot` can first meet the rolling ball; where it cannot catch up, the ball's position in 2
// s.
Interception intercept(const TrackedRobot& robot, const TrackedBall& ball);

}  // namespace autoref::strategies
