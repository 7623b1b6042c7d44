#include "referee/rules/placement_interference.hpp"

#include <fmt/format.h>

#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

struct BallsWay {
  Vec2 ball_m{0, 0};
  Vec2 target_m{0, 0};
  Side kept_away = Side::kWest;  // who does not take the restart
};

// None while the ball is not on its way to a restart of one side.
std::optional<BallsWay> balls_way(const Memory& memory, const Moment& moment) {
  const RefereeSignal& signal = memory.signal;
  if (!moment.tracks.ball || !signal.placement || !signal.next_command ||
      !is_for_one_side(signal.next_command->kind)) {
    return std::nullopt;
  }
  const Vec2& ball_m = moment.tracks.ball->position_m;
  const Vec2& target_m = signal.placement->target_m;
  if ((target_m - ball_m).norm() <= moment.configuration.rules.ball_in_place_m) return std::nullopt;
  return BallsWay{ball_m, target_m, opponent_of(signal.next_command->side)};
}

double gap_to_way_m(const TrackedRobot& robot, const BallsWay& way) {
  const Vec2 nearest_m = nearest_on_segment(robot.position_m, way.ball_m, way.target_m);
  return distance_to_hull(nearest_m, robot.position_m, robot.heading);
}

}  // namespace

std::optional<Finding> find_placement_interference(Memory& memory, const Moment& moment) {
  if (!moment.frame.ball) return std::nullopt;  // nobody knows where it is
  const Configuration& c = moment.configuration;
  const std::optional<BallsWay> way = balls_way(memory, moment);
  const double limit_m = c.rules.placement_clearance_m;
  const auto excess_m = [&](Side side, const TrackedRobot& robot) {
    return way && side == way->kept_away ? limit_m - gap_to_way_m(robot, *way) : 0.0;
  };
  const std::optional<Lingerer> nearest =
      take_worst(memory.watch.placement_interference, moment, c.rules.placement_grace_s, excess_m);
  if (!nearest) return std::nullopt;
  Finding finding = note_of(Event::kPlacementInterference, RuleId::kPlacementInterference, c.rules,
                            nearest->id, nearest->position_m);
  finding.value = limit_m - nearest->excess;
  finding.evidence = fmt::format(
      "{} is {:.0f} mm from the line between the ball and its place, after {:.1f} s near it.",
      text_of(nearest->id), 1e3 * finding.value, c.rules.placement_grace_s);
  return finding;
}

}  // namespace autoref::referee
