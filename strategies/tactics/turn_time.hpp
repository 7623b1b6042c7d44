// Whether a robot has the time to turn to its aim before it must part with the ball.
#pragma once

#include "soccer/geometry.hpp"
#include "strategies/tactics/style.hpp"

namespace autoref::strategies {

// How a robot comes to the ball, or holds it.
struct Hold {
  Vec2 heading{1, 0};   // of the robot at its first touch, or now if it holds the ball
  double free_rad = 0;  // how far from that heading it can kick without turning with the ball
  double spare_s = 0;   // how long it can turn with the ball before it loses it or must release it
};

// The chance, 0 to 1, that the robot kicks along `aim` in time: a logistic function of the spare
// time minus that of the turn, at ball_turn_radps after a tenth of a second to start it.
double chance_to_turn(const Style& style, const Hold& hold, const Vec2& aim);

}  // namespace autoref::strategies
