// While play is stopped, every robot must keep 500 mm away from the ball (Laws 9). This is judged
// once the ball has been at its position for a while (RuleBook::stop_distance_grace_s), because
// robots cannot know where it will be placed. Each robot is called once per stop.
#include <fmt/format.h>

#include "referee/geometry/hull.hpp"
#include "referee/rules/rule.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

constexpr double kAtOnce_s = 0;

bool is_judged(const RefereeState& state, const RefereeInput& input) {
  return state.signal.command.kind == CommandKind::kStop && input.tracks.ball &&
         state.ball_in_position_since_s &&
         has_passed(*state.ball_in_position_since_s,
                    input.configuration.rules.stop_distance_grace_s, input.time_s());
}

// The distance to the ball's centre, as at restarts.
double distance_to_ball_m(const TrackedRobot& robot, const Vec2& ball_m) {
  return distance_to_hull(ball_m, robot.position_m, robot.heading);
}

std::optional<Finding> find_stop_distance(RefereeState& state, const RefereeInput& input) {
  if (!input.frame.ball) return std::nullopt;  // the ball's position is unknown
  const Configuration& c = input.configuration;
  const bool holds = is_judged(state, input);
  const double limit_m = c.rules.opponents_to_ball_m - robot_to_ball_uncertainty_m(c.noise);
  const auto excess_m = [&](Side /*side*/, const TrackedRobot& robot) {
    return holds ? limit_m - distance_to_ball_m(robot, input.tracks.ball->position_m) : 0.0;
  };
  const std::optional<GraceViolation> nearest =
      take_worst(state.watch.stop_distance, input, kAtOnce_s, excess_m);
  if (!nearest) return std::nullopt;
  Finding finding = note_of(Event::kStopDistance, RuleId::kStopDistance, c.rules, nearest->id,
                            nearest->position_m);
  finding.value = limit_m - nearest->excess;
  finding.evidence = fmt::format(
      "{} is {} from the ball, which has been at its position for "
      "{:.1f} s.",
      text_of(nearest->id), mm_text(finding.value),
      input.time_s() - *state.ball_in_position_since_s);
  return finding;
}

}  // namespace

constinit const Rule kStopDistanceRule{{State::kWaitStop}, find_stop_distance};

}  // namespace autoref::referee
