#include "referee/rules/attacker_near_area.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "referee/restarts.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

// The unit vector from `point_m` to the nearest point of the defence area of `side`.
Vec2 direction_to_area(const Field& field, Side side, const Vec2& point_m) {
  const DefenceArea& area = field.defence_area;
  const double half_m = area.straight_m / 2;
  const bool round = area.shape == DefenceArea::Shape::kQuarterCircles;
  // Quarter circles are as far away as their centres on the goal line, but for their radius.
  const double depth_m = round ? 0.0 : area.depth_m;
  const double inwards = -goal_sign(side);
  const double from_line_m = (point_m.x() - field.goal_centre_m(side).x()) * inwards;
  const Vec2 nearest_m(
      field.goal_centre_m(side).x() + inwards * std::clamp(from_line_m, 0.0, depth_m),
      std::clamp(point_m.y(), -half_m, half_m));
  return direction_of(nearest_m - point_m, Vec2(-inwards, 0));
}

// How far the hull reaches from the robot's centre in the unit direction `way`.
double reach_of_hull_m(const Vec2& heading, const Vec2& way) {
  const Vec2 local = to_local(way, heading);
  if (local.x() * kRobotRadius_m < kFrontDistance_m) return kRobotRadius_m;
  return local.x() * kFrontDistance_m + std::abs(local.y()) * kHalfPlate_m;
}

double hull_to_area_m(const Field& field, Side side, const RobotObservation& robot) {
  return distance_to_defence_area(field, side, robot.position_m) -
         reach_of_hull_m(robot.heading, direction_to_area(field, side, robot.position_m));
}

struct Offence {
  RobotId robot;
  Vec2 position_m{0, 0};
  double distance_m = 0;
};

// The robot of `side` nearest to the opponents' area, if it is too near.
std::optional<Offence> offence_of(Side side, const Moment& moment) {
  const Configuration& c = moment.configuration;
  std::optional<Offence> worst;
  double nearest_m = c.rules.attacker_to_area_m;
  for (const RobotObservation& robot : moment.frame.robots[side]) {
    const double distance_m = hull_to_area_m(c.field, opponent_of(side), robot);
    if (!(distance_m < nearest_m)) continue;
    nearest_m = distance_m;
    worst = Offence{{side, robot.number}, robot.position_m, distance_m};
  }
  return worst;
}

}  // namespace

std::optional<Finding> find_attacker_near_area(Memory& memory, const Moment& moment) {
  if (!memory.play.entered_now || !memory.play.kicker) return std::nullopt;
  std::optional<Offence> offence = offence_of(*memory.play.kicker, moment);
  if (!offence) offence = offence_of(opponent_of(*memory.play.kicker), moment);
  if (!offence) return std::nullopt;
  const Configuration& c = moment.configuration;
  const Side kicker = opponent_of(offence->robot.side);
  Finding finding;
  finding.event = Event::kAttackerNearArea;
  finding.rule = "paper 4.2, robot-related rules";
  finding.value = offence->distance_m;
  finding.threshold = c.rules.attacker_to_area_m;
  finding.unit = "m";
  finding.robots.push_back(offence->robot);
  finding.position_m = offence->position_m;
  finding.restart = {CommandKind::kIndirectFree, kicker};
  finding.ball_to_m = free_kick_place(c.field, c.rules, kicker, offence->position_m);
  finding.evidence = fmt::format(
      "When the ball entered play, the hull of {} {} was {:.0f} mm from the opponents' area.",
      name_of(offence->robot.side), offence->robot.number, 1e3 * offence->distance_m);
  return finding;
}

}  // namespace autoref::referee
