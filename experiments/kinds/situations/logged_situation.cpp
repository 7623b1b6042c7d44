#include "experiments/kinds/situations/logged_situation.hpp"

#include <algorithm>
#include <cmath>

#include "logs/logged_state.hpp"

namespace autoref::experiments {
namespace {

constexpr double kRounded = 1e4;  // per metre, radian or second

double rounded_value(double value) { return std::round(value * kRounded) / kRounded; }

class LoggedNumbers {
 public:
  explicit LoggedNumbers(double spread_m) : spread_m_(spread_m) {}

  template <typename Numbers>
  void set(const Numbers& numbers, const std::vector<double>& values) const {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Range& range = numbers[i].range;
      const double value = std::clamp(rounded_value(values[i]), range.low, range.high);
      const bool is_spread = numbers[i].unit == "m" && numbers[i].key != "height_m";
      *numbers[i].place =
          is_spread && spread_m_ > 0 ? Distribution::normal(value, spread_m_) : Distribution(value);
    }
  }

 private:
  double spread_m_;
};

std::vector<DrawnRobot> drawn_robots(const game::StartingRobots& robots, const Field& field,
                                     const LoggedNumbers& numbers) {
  std::vector<DrawnRobot> drawn;
  for (const sim::RobotState& robot : robots) {
    DrawnRobot one;
    one.number = robot.number;
    numbers.set(numbers_of(one, field),
                {robot.position_m.x(), robot.position_m.y(), robot.velocity_mps.x(),
                 robot.velocity_mps.y(), robot.angular_velocity_radps});
    one.heading_deg = rounded_value(angle_of(robot.heading) * 180 / kPi);
    drawn.push_back(one);
  }
  return drawn;
}

Restart restart_of(const std::optional<Command>& command) {
  if (!command) return Restart::kNone;
  switch (command->kind) {
    case CommandKind::kPrepareKickoff:
      return Restart::kKickoff;
    case CommandKind::kPreparePenalty:
      return Restart::kPenalty;
    case CommandKind::kDirectFree:
      return Restart::kDirectFree;
    case CommandKind::kIndirectFree:
      return Restart::kIndirectFree;
    default:
      return Restart::kForceStart;
  }
}

}  // namespace

void take_from_log(const LoggedInstant& instant, const Field& field, int most_attackers,
                   int most_defenders, SituationSetup& situation) {
  const logs::LoggedState logged = logs::logged_state(instant.log, instant.at_s);
  logs::check_same_field(logged, field);
  game::StartState start =
      instant.attackers == Side::kWest ? logged.start : game::mirrored(logged.start);
  logs::renumber(start.robots[Side::kWest], most_attackers);
  logs::renumber(start.robots[Side::kEast], most_defenders);
  // Before a restart, the ball rests where it is taken.
  const referee::Beginning& beginning = start.referee;
  if (beginning.restart) start.ball = {beginning.ball_m, {0, 0}, 0, 0, true};
  const LoggedNumbers numbers(instant.spread_m);
  situation.attackers = drawn_robots(start.robots[Side::kWest], field, numbers);
  situation.defenders = drawn_robots(start.robots[Side::kEast], field, numbers);
  const sim::BallState& ball = start.ball;
  LoggedNumbers(beginning.restart ? 0 : instant.spread_m)
      .set(numbers_of(situation.ball, field),
           {ball.position_m.x(), ball.position_m.y(), ball.velocity_mps.x(), ball.velocity_mps.y(),
            ball.height_m, ball.vertical_mps});
  situation.restart = restart_of(beginning.restart);
  situation.is_attackers_restart = !beginning.restart || beginning.restart->side == Side::kWest;
  situation.is_after_stop = beginning.is_stopped;
}

}  // namespace autoref::experiments
