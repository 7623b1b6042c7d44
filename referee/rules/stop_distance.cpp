#include "referee/rules/stop_distance.hpp"

#include <fmt/format.h>

#include "referee/geometry/hull.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

constexpr double kBallAtItsPlaceFor_s = 2_s;
constexpr double kAtOnce_s = 0;

bool is_judged(const Memory& memory, const Moment& moment) {
  return memory.signal.command.kind == CommandKind::kStop && moment.tracks.ball &&
         memory.ball_in_place_since_s &&
         has_passed(*memory.ball_in_place_since_s, kBallAtItsPlaceFor_s, moment.time_s());
}

// To the ball's centre, as at restarts.
double distance_to_ball_m(const TrackedRobot& robot, const Vec2& ball_m) {
  return distance_to_hull(ball_m, robot.position_m, robot.heading);
}

}  // namespace

std::optional<Finding> find_stop_distance(Memory& memory, const Moment& moment) {
  if (!moment.frame.ball) return std::nullopt;  // nobody knows where it is
  const Configuration& c = moment.configuration;
  const bool holds = is_judged(memory, moment);
  const double limit_m = c.rules.opponents_to_ball_m - robot_to_ball_doubt_m(c.noise);
  const auto excess_m = [&](Side /*side*/, const TrackedRobot& robot) {
    return holds ? limit_m - distance_to_ball_m(robot, moment.tracks.ball->position_m) : 0.0;
  };
  const std::optional<Lingerer> nearest =
      take_worst(memory.watch.stop_distance, moment, kAtOnce_s, excess_m);
  if (!nearest) return std::nullopt;
  Finding finding = note_of(Event::kStopDistance, RuleId::kStopDistance, c.rules, nearest->id,
                            nearest->position_m);
  finding.value = limit_m - nearest->excess;
  finding.evidence = fmt::format(
      "{} is {:.0f} mm from the ball, which has been at its place for "
      "{:.1f} s.",
      text_of(nearest->id), 1e3 * finding.value, moment.time_s() - *memory.ball_in_place_since_s);
  return finding;
}

}  // namespace autoref::referee
