// The options of the robot with the ball, each with its value, and the probability that the robot
// has enough time to turn to its aim.
#pragma once

#include <cstdint>

#include "soccer/geometry.hpp"
#include "strategies/skills/strike.hpp"
#include "strategies/tactics/predicted_state.hpp"
#include "strategies/tactics/style.hpp"

namespace autoref::strategies {

// How a robot reaches or holds the ball.
struct Hold {
  Vec2 heading{1, 0};   // the robot's heading at its first touch, or now if it holds the ball
  double free_rad = 0;  // how far from that heading it can kick without turning with the ball
  // How long it can turn with the ball before it loses the ball or must release it.
  double spare_s = 0;
};

// The chance, 0 to 1, that the robot kicks along `aim` in time: a logistic function of the spare
// time minus the duration of the turn. The turn takes a tenth of a second to start and then
// continues at ball_turn_radps.
double chance_to_turn(const Style& style, const Hold& hold, const Vec2& aim);

// An option. Its value serves to compare it with other options in the same frame. It is roughly the
// chance of a goal, 0 to 1, minus the expected loss if the option fails.
struct Choice {
  enum class Kind : std::uint8_t { kShot, kPass, kChip, kCarry, kClear };
  Kind kind = Kind::kClear;
  Strike strike;
  double worth = -1;
  int receiver = -1;  // number of the robot that receives the pass
};

// A shot at the widest opening of the goal, by the robot with that number.
Choice shot_from(const PredictedState& predicted, int number, const Vec2& from_m);

// A pass along the ground, or chipped over robots in between, to the team-mate with that index.
// `chance` is the chance of a shot from the team-mate's position. The value is -1 if the team-mate
// is too near, too far for a chip, or in an area where field players must not touch the ball.
Choice pass_to(const PredictedState& predicted, int mate, double chance, const Vec2& from_m);
Choice chip_to(const PredictedState& predicted, int mate, double chance, const Vec2& from_m);

// The option of carrying the ball.
Choice carry_from(const PredictedState& predicted, const Vec2& from_m);

// The option of dribbling towards the goal at a restart instead of kicking.
Choice dribble_from(const PredictedState& predicted, const Vec2& from_m);

// A kick into the most open space without turning far from `heading`; never backwards.
Choice clear_from(const PredictedState& predicted, const Vec2& from_m, const Vec2& heading);

// Pressure on a ball at that position, 0 to 1: the nearer an opponent, the higher.
double pressure_at(const PredictedState& predicted, const Vec2& ball_m);

}  // namespace autoref::strategies
