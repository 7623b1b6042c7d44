#include "strategies/tactics/kick_choice.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"
#include "strategies/skills/openings.hpp"
#include "strategies/tactics/pass_field.hpp"

namespace autoref::strategies {
namespace {

constexpr double kMissCost = 0.04;  // of a shot that does not score
constexpr double kNearestPass_m = 0.5;
constexpr double kLead_s = 0.25;     // a moving receiver is passed ahead of
constexpr double kAfterPass = 0.7;   // of a chance is left when the pass has come
constexpr double kAfterChip = 0.45;  // a ball that hops is hard to take
constexpr double kPassTolerance_rad = 0.05;
constexpr double kHops_m = 1.0;          // from a chip's landing until the ball rolls
constexpr double kShortestChip_m = 0.8;  // from the kick to its landing
constexpr double kFlown_m = 0.35;    // before this and after the landing less this, it is too low
constexpr double kFreeRoom_m = 0.6;  // from opponent to ball: no pressure
constexpr double kNoRoom_m = 0.2;    // and full pressure
constexpr double kCarryWorth = 0.3;  // of a ball with room around it, times the style's liking
constexpr double kClearWorth = 0.04;
constexpr double kClear_mps = 2.3;  // from the own third
constexpr double kPush_mps = 1.5;   // elsewhere; it rolls on for 1.9 m
constexpr double kClear_m = 1.8;
constexpr double kClearTolerance_rad = 0.25;
constexpr int kClearSteps = 3;  // directions to each side of straight ahead
constexpr double kWidestClear_rad = 80_deg;

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
  pass.strike.target_m = receiver.position_m + receiver.velocity_mps * kLead_s;
  pass.strike.tolerance_rad = kPassTolerance_rad;
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
double chip_safety(const Vec2& from_m, const Vec2& landing_m, const Vec2& to_m,
                   const TrackedRobots& opponents) {
  const Vec2 way = direction_of(landing_m - from_m, Vec2(1, 0));
  TrackedRobots low;
  for (const TrackedRobot& robot : opponents) {
    const double along_m = (robot.position_m - from_m).dot(way);
    const bool is_flown_over =
        along_m > kFlown_m && (robot.position_m - landing_m).dot(way) < -kFlown_m;
    if (!is_flown_over) low.push_back(robot);
  }
  constexpr double kAlong_mps = 3.0;  // about its speed over ground
  return pass_safety(from_m, to_m, kAlong_mps, low);
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
  shot.strike.tolerance_rad = std::clamp(0.6 * opening.half_width_m / distance_m, 0.04, 0.3);
  shot.worth = opening.chance - (1 - opening.chance) * kMissCost;
  return shot;
}

Choice pass_to(const Outlook& outlook, int mate, double chance, const Vec2& from_m) {
  Choice pass = pass_for(outlook, mate, Choice::Kind::kPass);
  const double distance_m = (pass.strike.target_m - from_m).norm();
  if (distance_m < kNearestPass_m || !outlook.may_touch_at(pass.strike.target_m)) return pass;
  pass.strike.kick_mps =
      outlook.allowed_kick_mps(kick_for_mps(distance_m, outlook.style().pass_arrival_mps));
  const double safety =
      pass_safety(from_m, pass.strike.target_m, pass.strike.kick_mps, outlook.now().opponents);
  pass.worth = worth_of_pass(outlook, pass, chance, from_m, safety, kAfterPass);
  return pass;
}

Choice chip_to(const Outlook& outlook, int mate, double chance, const Vec2& from_m) {
  Choice chip = pass_for(outlook, mate, Choice::Kind::kChip);
  const Vec2 offset = chip.strike.target_m - from_m;
  const double distance_m = offset.norm();
  const double flight_m = distance_m - kHops_m;
  const double kick_mps = std::sqrt(kGravity_mps2 * std::max(0.0, flight_m));  // at 45 degrees
  if (flight_m < kShortestChip_m || kick_mps > outlook.chip_limit_mps()) return chip;
  if (!outlook.may_touch_at(chip.strike.target_m)) return chip;
  chip.strike.chip = true;
  chip.strike.first_touch = false;
  chip.strike.kick_mps = kick_mps;
  const Vec2 landing_m = from_m + offset * (flight_m / distance_m);
  const double safety =
      chip_safety(from_m, landing_m, chip.strike.target_m, outlook.now().opponents);
  chip.worth = worth_of_pass(outlook, chip, chance, from_m, safety, kAfterChip);
  return chip;
}

Choice carry_from(const Outlook& outlook, const Vec2& from_m) {
  Choice carry;
  carry.kind = Choice::Kind::kCarry;
  carry.worth = outlook.style().carry * kCarryWorth * (1 - pressure_at(outlook, from_m));
  carry.strike.target_m = outlook.field().goal_centre_m(Side::kEast);
  carry.strike.kick_mps = 0;
  return carry;
}

Choice clear_from(const Outlook& outlook, const Vec2& from_m, const Vec2& heading) {
  const Field& field = outlook.field();
  Choice clear;
  clear.worth = kClearWorth;
  const bool is_back = from_m.x() < -field.half_length_m() / 3;
  clear.strike.kick_mps = is_back ? kClear_mps : kPush_mps;
  clear.strike.tolerance_rad = kClearTolerance_rad;
  const Vec2 ahead = direction_of(field.goal_centre_m(Side::kEast) - from_m, Vec2(1, 0));
  double best = -1e9;
  for (int i = -kClearSteps; i <= kClearSteps; ++i) {
    const double turn_rad = kWidestClear_rad * i / kClearSteps;
    const Vec2 way = to_world(heading_of(turn_rad), ahead);
    const Vec2 target_m = from_m + way * kClear_m;
    const double safety =
        pass_safety(from_m, target_m, clear.strike.kick_mps, outlook.now().opponents);
    const double score = safety - 0.3 * std::abs(turn_rad) - 0.5 * (1 - way.dot(heading)) -
                         (is_on_field(field, target_m * 1.1) ? 0 : 1.0);
    if (score <= best) continue;
    best = score;
    clear.strike.target_m = target_m;
  }
  return clear;
}

double pressure_at(const Outlook& outlook, const Vec2& ball_m) {
  const double room_m = nearest_m(outlook.now().opponents, ball_m);
  return std::clamp((kFreeRoom_m - room_m) / (kFreeRoom_m - kNoRoom_m), 0.0, 1.0);
}

}  // namespace autoref::strategies
