#include "strategies/tactics/kick_choice.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"
#include "strategies/skills/openings.hpp"
#include "strategies/tactics/pass_field.hpp"

namespace autoref::strategies {
namespace {

constexpr double kStartsTurning_s = 0.1;
constexpr double kLittleTurn_rad = 0.1;  // a smaller turn needs less time to start

constexpr int kClearSteps = 3;  // directions to each side of straight ahead

double nearest_m(const TrackedRobots& robots, const Vec2& point_m) {
  double nearest2 = 100;
  for (const TrackedRobot& robot : robots)
    nearest2 = std::min(nearest2, (robot.position_m - point_m).squaredNorm());
  return std::sqrt(nearest2);
}

Choice pass_for(const PredictedState& predicted, int mate, Choice::Kind kind) {
  const TrackedRobot& receiver = predicted.robot(mate);
  Choice pass;
  pass.kind = kind;
  pass.receiver = receiver.number;
  pass.strike.target_m =
      receiver.position_m + receiver.velocity_mps * predicted.style().pass_lead_s;
  pass.strike.tolerance_rad = predicted.style().pass_tolerance_rad;
  return pass;
}

// The expected value of a pass that arrives with probability `safety` and is otherwise lost.
// `share` is the fraction of the scoring chance that remains after the pass.
double worth_of_pass(const PredictedState& predicted, const Choice& pass, double chance,
                     const Vec2& from_m, double safety, double share) {
  const Style& style = predicted.style();
  const double half_m = predicted.field().half_length_m();
  const double lost = (1 - style.pass_risk) * (0.3 - 0.15 * from_m.x() / half_m);
  if (safety <= 0) return -lost;
  const double there = worth_of(predicted, chance, pass.strike.target_m, from_m);
  const double gain = (pass.strike.target_m.x() - from_m.x()) / half_m;
  const double liked = style.patience + style.ahead * std::max(0.0, gain);
  return share * safety * there + safety * liked - (1 - safety) * lost;
}

// The same as pass_safety(), but for a ball that flies over robots, except shortly after the kick
// and before the landing.
double chip_safety(const PredictedState& predicted, const Vec2& from_m, const Vec2& landing_m,
                   const Vec2& to_m) {
  const Vec2 direction = direction_of(landing_m - from_m, Vec2(1, 0));
  TrackedRobots low;
  for (const TrackedRobot& robot : predicted.now().opponents) {
    const double along_m = (robot.position_m - from_m).dot(direction);
    const bool is_flown_over =
        along_m > predicted.style().flown_over_m &&
        (robot.position_m - landing_m).dot(direction) < -predicted.style().flown_over_m;
    if (!is_flown_over) low.push_back(robot);
  }
  return pass_safety(from_m, to_m, predicted.style().chip_along_mps, low);
}

}  // namespace

double chance_to_turn(const Style& style, const Hold& hold, const Vec2& aim) {
  const double turn_rad = std::max(0.0, std::abs(angle_between(hold.heading, aim)) - hold.free_rad);
  const double start_s = kStartsTurning_s * std::min(1.0, turn_rad / kLittleTurn_rad);
  const double turn_s = turn_rad / style.ball_turn_radps + start_s;
  return 1 / (1 + exponential((turn_s - hold.spare_s) / style.late_spread_s));
}

Choice shot_from(const PredictedState& predicted, int number, const Vec2& from_m) {
  const TeamView& now = predicted.now();
  Choice shot;
  shot.kind = Choice::Kind::kShot;
  shot.strike.kick_mps = predicted.allowed_kick_mps(predicted.style().shot_mps);
  const Opening opening =
      widest_opening(predicted.field(), from_m, now.opponents, now.own,
                     {shot.strike.kick_mps, number, predicted.context().kicks.direction_rad});
  const double distance_m = (opening.target_m - from_m).norm();
  shot.strike.target_m = opening.target_m;
  shot.strike.tolerance_rad =
      std::clamp(predicted.style().shot_share * opening.half_width_m / distance_m, 0.04, 0.3);
  shot.worth = opening.chance - (1 - opening.chance) * predicted.style().miss_cost;
  return shot;
}

Choice pass_to(const PredictedState& predicted, int mate, double chance, const Vec2& from_m) {
  Choice pass = pass_for(predicted, mate, Choice::Kind::kPass);
  const double distance_m = (pass.strike.target_m - from_m).norm();
  if (distance_m < predicted.style().nearest_pass_m ||
      !predicted.may_touch_at(pass.strike.target_m))
    return pass;
  pass.strike.kick_mps =
      predicted.allowed_kick_mps(kick_for_mps(distance_m, predicted.style().pass_arrival_mps));
  const double safety =
      pass_safety(from_m, pass.strike.target_m, pass.strike.kick_mps, predicted.now().opponents);
  pass.worth = worth_of_pass(predicted, pass, chance, from_m, safety, predicted.style().after_pass);
  return pass;
}

Choice chip_to(const PredictedState& predicted, int mate, double chance, const Vec2& from_m) {
  Choice chip = pass_for(predicted, mate, Choice::Kind::kChip);
  const Vec2 offset = chip.strike.target_m - from_m;
  const double distance_m = offset.norm();
  const double flight_m = distance_m - predicted.style().chip_hops_m;
  // The ballistic range of a 45-degree chip at speed v is v^2 / g.
  const double kick_mps = std::sqrt(kGravity_mps2 * std::max(0.0, flight_m));
  if (flight_m < predicted.style().shortest_chip_m || kick_mps > predicted.chip_limit_mps())
    return chip;
  if (!predicted.may_touch_at(chip.strike.target_m)) return chip;
  chip.strike.chip = true;
  chip.strike.first_touch = false;
  chip.strike.kick_mps = kick_mps;
  const Vec2 landing_m = from_m + offset * (flight_m / distance_m);
  const double safety = chip_safety(predicted, from_m, landing_m, chip.strike.target_m);
  chip.worth = worth_of_pass(predicted, chip, chance, from_m, safety, predicted.style().after_chip);
  return chip;
}

Choice carry_from(const PredictedState& predicted, const Vec2& from_m) {
  Choice carry;
  carry.kind = Choice::Kind::kCarry;
  carry.worth = predicted.style().carry * predicted.style().carry_worth *
                (1 - pressure_at(predicted, from_m));
  if (predicted.rules().has(RuleId::kBotDribbledBallTooFar))
    carry.worth *= predicted.style().limited_carry;
  carry.strike.target_m = predicted.field().goal_centre_m(Side::kEast);
  carry.strike.kick_mps = 0;
  return carry;
}

Choice dribble_from(const PredictedState& predicted, const Vec2& from_m) {
  Choice dribble = carry_from(predicted, from_m);
  dribble.worth = predicted.style().dribbled_restart;
  dribble.strike.dribble = true;
  return dribble;
}

Choice clear_from(const PredictedState& predicted, const Vec2& from_m, const Vec2& heading) {
  const Field& field = predicted.field();
  Choice clear;
  clear.worth = predicted.style().clear_worth;
  const bool is_back = from_m.x() < -field.half_length_m() / 3;
  clear.strike.kick_mps = is_back ? predicted.style().clear_mps : predicted.style().push_mps;
  clear.strike.tolerance_rad = predicted.style().clear_tolerance_rad;
  const Vec2 ahead = direction_of(field.goal_centre_m(Side::kEast) - from_m, Vec2(1, 0));
  double best = -1e9;
  for (int i = -kClearSteps; i <= kClearSteps; ++i) {
    const double turn_rad = predicted.style().widest_clear_rad * i / kClearSteps;
    const Vec2 direction = to_world(heading_of(turn_rad), ahead);
    const Vec2 target_m = from_m + direction * predicted.style().clear_m;
    const double safety =
        pass_safety(from_m, target_m, clear.strike.kick_mps, predicted.now().opponents);
    const double score = safety - predicted.style().clear_turn_cost * std::abs(turn_rad) -
                         predicted.style().clear_heading_cost * (1 - direction.dot(heading)) -
                         (is_on_field(field, target_m * 1.1) ? 0 : 1.0);
    if (score <= best) continue;
    best = score;
    clear.strike.target_m = target_m;
  }
  return clear;
}

double pressure_at(const PredictedState& predicted, const Vec2& ball_m) {
  const double room_m = nearest_m(predicted.now().opponents, ball_m);
  return std::clamp((predicted.style().free_room_m - room_m) /
                        (predicted.style().free_room_m - predicted.style().no_room_m),
                    0.0, 1.0);
}

}  // namespace autoref::strategies
