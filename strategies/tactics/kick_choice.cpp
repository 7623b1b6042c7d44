#include "strategies/tactics/kick_choice.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"
#include "strategies/skills/openings.hpp"
#include "strategies/tactics/pass_field.hpp"

namespace autoref::strategies {
namespace {

constexpr int kClearSteps = 3;  // directions to each side of straight ahead

double nearest_m(const TrackedRobots& robots, const Vec2& point_m) {
  double nearest2 = 100;
  for (const TrackedRobot& robot : robots)
    nearest2 = std::min(nearest2, (robot.position_m - point_m).squaredNorm());
  return std::sqrt(nearest2);
}

Choice pass_for(const Outlook& outlook, int mate, Choice::Kind kind) {
  const TrackedRobot& receiver = outlook.robot(mate);
  Choice pass;
  pass.kind = kind;
  pass.receiver = receiver.number;
  pass.strike.target_m = receiver.position_m + receiver.velocity_mps * outlook.style().pass_lead_s;
  pass.strike.tolerance_rad = outlook.style().pass_tolerance_rad;
  return pass;
}

// What a pass that safe is worth; `share` of the chance is left once it has come.
double worth_of_pass(const Outlook& outlook, const Choice& pass, double chance, const Vec2& from_m,
                     double safety, double share) {
  const Style& style = outlook.style();
  const double half_m = outlook.field().half_length_m();
  const double lost = (1 - style.pass_risk) * (0.3 - 0.15 * from_m.x() / half_m);
  const double there = worth_of(outlook, chance, pass.strike.target_m, from_m);
  const double gain = (pass.strike.target_m.x() - from_m.x()) / half_m;
  const double liked = style.patience + style.ahead * std::max(0.0, gain);
  return share * safety * there + safety * liked - (1 - safety) * lost;
}

// As pass_safety, for a ball that flies over whoever is well between kick and landing.
double chip_safety(const Outlook& outlook, const Vec2& from_m, const Vec2& landing_m,
                   const Vec2& to_m) {
  const Vec2 way = direction_of(landing_m - from_m, Vec2(1, 0));
  TrackedRobots low;
  for (const TrackedRobot& robot : outlook.now().opponents) {
    const double along_m = (robot.position_m - from_m).dot(way);
    const bool is_flown_over =
        along_m > outlook.style().flown_over_m &&
        (robot.position_m - landing_m).dot(way) < -outlook.style().flown_over_m;
    if (!is_flown_over) low.push_back(robot);
  }
  return pass_safety(from_m, to_m, outlook.style().chip_along_mps, low);
}

}  // namespace

Choice shot_from(const Outlook& outlook, int number, const Vec2& from_m) {
  const TeamView& now = outlook.now();
  Choice shot;
  shot.kind = Choice::Kind::kShot;
  shot.strike.kick_mps = outlook.allowed_kick_mps(outlook.style().shot_mps);
  const Opening opening = widest_opening(outlook.field(), from_m, now.opponents, now.own,
                                         {shot.strike.kick_mps, number});
  const double distance_m = (opening.target_m - from_m).norm();
  shot.strike.target_m = opening.target_m;
  shot.strike.tolerance_rad =
      std::clamp(outlook.style().shot_share * opening.half_width_m / distance_m, 0.04, 0.3);
  shot.worth = opening.chance - (1 - opening.chance) * outlook.style().miss_cost;
  return shot;
}

Choice pass_to(const Outlook& outlook, int mate, double chance, const Vec2& from_m) {
  Choice pass = pass_for(outlook, mate, Choice::Kind::kPass);
  const double distance_m = (pass.strike.target_m - from_m).norm();
  if (distance_m < outlook.style().nearest_pass_m || !outlook.may_touch_at(pass.strike.target_m))
    return pass;
  pass.strike.kick_mps =
      outlook.allowed_kick_mps(kick_for_mps(distance_m, outlook.style().pass_arrival_mps));
  const double safety =
      pass_safety(from_m, pass.strike.target_m, pass.strike.kick_mps, outlook.now().opponents);
  pass.worth = worth_of_pass(outlook, pass, chance, from_m, safety, outlook.style().after_pass);
  return pass;
}

Choice chip_to(const Outlook& outlook, int mate, double chance, const Vec2& from_m) {
  Choice chip = pass_for(outlook, mate, Choice::Kind::kChip);
  const Vec2 offset = chip.strike.target_m - from_m;
  const double distance_m = offset.norm();
  const double flight_m = distance_m - outlook.style().chip_hops_m;
  const double kick_mps = std::sqrt(kGravity_mps2 * std::max(0.0, flight_m));  // at 45 degrees
  if (flight_m < outlook.style().shortest_chip_m || kick_mps > outlook.chip_limit_mps())
    return chip;
  if (!outlook.may_touch_at(chip.strike.target_m)) return chip;
  chip.strike.chip = true;
  chip.strike.first_touch = false;
  chip.strike.kick_mps = kick_mps;
  const Vec2 landing_m = from_m + offset * (flight_m / distance_m);
  const double safety = chip_safety(outlook, from_m, landing_m, chip.strike.target_m);
  chip.worth = worth_of_pass(outlook, chip, chance, from_m, safety, outlook.style().after_chip);
  return chip;
}

Choice carry_from(const Outlook& outlook, const Vec2& from_m) {
  Choice carry;
  carry.kind = Choice::Kind::kCarry;
  carry.worth =
      outlook.style().carry * outlook.style().carry_worth * (1 - pressure_at(outlook, from_m));
  carry.strike.target_m = outlook.field().goal_centre_m(Side::kEast);
  carry.strike.kick_mps = 0;
  return carry;
}

Choice clear_from(const Outlook& outlook, const Vec2& from_m, const Vec2& heading) {
  const Field& field = outlook.field();
  Choice clear;
  clear.worth = outlook.style().clear_worth;
  const bool is_back = from_m.x() < -field.half_length_m() / 3;
  clear.strike.kick_mps = is_back ? outlook.style().clear_mps : outlook.style().push_mps;
  clear.strike.tolerance_rad = outlook.style().clear_tolerance_rad;
  const Vec2 ahead = direction_of(field.goal_centre_m(Side::kEast) - from_m, Vec2(1, 0));
  double best = -1e9;
  for (int i = -kClearSteps; i <= kClearSteps; ++i) {
    const double turn_rad = outlook.style().widest_clear_rad * i / kClearSteps;
    const Vec2 way = to_world(heading_of(turn_rad), ahead);
    const Vec2 target_m = from_m + way * outlook.style().clear_m;
    const double safety =
        pass_safety(from_m, target_m, clear.strike.kick_mps, outlook.now().opponents);
    const double score = safety - outlook.style().clear_turn_cost * std::abs(turn_rad) -
                         outlook.style().clear_heading_cost * (1 - way.dot(heading)) -
                         (is_on_field(field, target_m * 1.1) ? 0 : 1.0);
    if (score <= best) continue;
    best = score;
    clear.strike.target_m = target_m;
  }
  return clear;
}

double pressure_at(const Outlook& outlook, const Vec2& ball_m) {
  const double room_m = nearest_m(outlook.now().opponents, ball_m);
  return std::clamp((outlook.style().free_room_m - room_m) /
                        (outlook.style().free_room_m - outlook.style().no_room_m),
                    0.0, 1.0);
}

}  // namespace autoref::strategies
