// What can be done with a ball: the options of who has it, each with what it is worth.
#pragma once

#include <cstdint>

#include "strategies/skills/strike.hpp"
#include "strategies/tactics/predicted_state.hpp"

namespace autoref::strategies {

// An option. Worths compare options of one moment: about the chance, 0 to 1, that a goal comes of
// it, less what is lost where it fails.
struct Choice {
  enum class Kind : std::uint8_t { kShot, kPass, kChip, kCarry, kClear };
  Kind kind = Kind::kClear;
  Strike strike;
  double worth = -1;
  int receiver = -1;  // number of the robot a pass is for
};

// A shot at the widest opening of the goal, by the robot of that number.
Choice shot_from(const PredictedState& predicted, int number, const Vec2& from_m);

// A pass along the ground, or chipped over who stands between, to the mate of that index; `chance`
// is that of a shot from where the mate is. Worth -1 where it is too near, too far for a chip, or
// in an area where field players may not touch the ball.
Choice pass_to(const PredictedState& predicted, int mate, double chance, const Vec2& from_m);
Choice chip_to(const PredictedState& predicted, int mate, double chance, const Vec2& from_m);

// Keeping the ball at the foot.
Choice carry_from(const PredictedState& predicted, const Vec2& from_m);

// A push to where there is most room without turning far from `heading`; never back.
Choice clear_from(const PredictedState& predicted, const Vec2& from_m, const Vec2& heading);

// How little time there is, 0 to 1: how near an opponent is to a ball at that place.
double pressure_at(const PredictedState& predicted, const Vec2& ball_m);

}  // namespace autoref::strategies
