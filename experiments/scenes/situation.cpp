#include "experiments/scenes/situation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "game/settings/setting_value.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::experiments {
namespace {

constexpr int kMostRedraws = 100;
constexpr Range kDrawnSpeed_mps{-20, 20};
constexpr Range kDrawnTurn_radps{-100, 100};

// Touching bodies may overlap by this much because of a log's noise. The simulation separates them.
constexpr double kTouch_m = 10_mm;

template <typename Place, typename Robot>
std::array<DrawnNumber<Place>, 5> numbers_in(Robot& robot, const Field& field) {
  const double x_m = field.wall_x_m() - kRobotRadius_m;
  const double y_m = field.wall_y_m() - kRobotRadius_m;
  return {{{"x_m", &robot.x_m, {-x_m, x_m}, "m"},
           {"y_m", &robot.y_m, {-y_m, y_m}, "m"},
           {"vx_mps", &robot.vx_mps, kDrawnSpeed_mps, "m/s"},
           {"vy_mps", &robot.vy_mps, kDrawnSpeed_mps, "m/s"},
           {"turn_radps", &robot.turn_radps, kDrawnTurn_radps, "rad/s"}}};
}

template <typename Place, typename Ball>
std::array<DrawnNumber<Place>, 6> numbers_in_ball(Ball& ball, const Field& field) {
  const double x_m = field.wall_x_m() - kBallRadius_m;
  const double y_m = field.wall_y_m() - kBallRadius_m;
  return {{{"x_m", &ball.x_m, {-x_m, x_m}, "m"},
           {"y_m", &ball.y_m, {-y_m, y_m}, "m"},
           {"vx_mps", &ball.vx_mps, kDrawnSpeed_mps, "m/s"},
           {"vy_mps", &ball.vy_mps, kDrawnSpeed_mps, "m/s"},
           {"height_m", &ball.height_m, {0, 10}, "m"},
           {"vz_mps", &ball.vz_mps, kDrawnSpeed_mps, "m/s"}}};
}

// FNV-1a, followed by a bit mixer.
std::uint64_t hash_of(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char letter : text) {
    hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3ULL;
  }
  return mix_bits(hash);
}

// Draws the values for one attempt at a start state.
class Draw {
 public:
  Draw(std::uint64_t seed, const std::string& name, int scene, int attempt)
      : key_(mix_bits(mix_bits(mix_bits(seed) + hash_of(name)) +
                      static_cast<std::uint64_t>(scene) * kMostRedraws +
                      static_cast<std::uint64_t>(attempt))) {}

  double number(const Distribution& from, const Range& range, const std::string& path) const {
    RandomStream random(key_ ^ hash_of(path));
    return drawn(from, range, random);
  }

 private:
  std::uint64_t key_;
};

template <typename Numbers>
auto drawn_values(const Numbers& numbers, const Draw& draw, const std::string& branch) {
  std::array<double, std::tuple_size_v<Numbers>> values{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    values[i] = draw.number(*numbers[i].place, numbers[i].range,
                            fmt::format("{}.{}", branch, numbers[i].key));
  }
  return values;
}

sim::BallState drawn_ball(const DrawnBall& ball, const Field& field, const Draw& draw) {
  const auto [x, y, vx, vy, height, vz] = drawn_values(numbers_of(ball, field), draw, "ball");
  return {{x, y}, {vx, vy}, height, vz, true};
}

sim::RobotState drawn_robot(const DrawnRobot& robot, const std::string& branch, const Vec2& ball_m,
                            const Field& field, const Draw& draw) {
  const std::string path = fmt::format("{}.{}", branch, robot.number);
  const auto [x, y, vx, vy, turn] = drawn_values(numbers_of(robot, field), draw, path);
  const Vec2 position_m(x, y);
  Vec2 heading = direction_of(ball_m - position_m, Vec2(1, 0));
  if (robot.heading_deg) {
    heading = heading_of(draw.number(*robot.heading_deg, kHeading_deg, path + ".heading_deg") *
                         kPi / 180);
  }
  return {robot.number, position_m, heading, {vx, vy}, turn};
}

// The command that announces the restart; the attackers are in the west.
std::optional<Command> command_of(const SituationSetup& situation) {
  const Side side = situation.is_attackers_restart ? Side::kWest : Side::kEast;
  switch (situation.restart) {
    case Restart::kKickoff:
      return Command{CommandKind::kPrepareKickoff, side};
    case Restart::kDirectFree:
      return Command{CommandKind::kDirectFree, side};
    case Restart::kIndirectFree:
      return Command{CommandKind::kIndirectFree, side};
    case Restart::kPenalty:
      return Command{CommandKind::kPreparePenalty, side};
    case Restart::kForceStart:
      return Command{CommandKind::kForceStart, Side::kWest};
    case Restart::kNone:
      break;
  }
  return std::nullopt;
}

game::StartState drawn_once(const SituationSetup& situation, const Field& field, const Draw& draw) {
  game::StartState state;
  state.ball = drawn_ball(situation.ball, field, draw);
  const Vec2& ball_m = state.ball.position_m;
  for (const DrawnRobot& robot : situation.attackers)
    state.robots[Side::kWest].push_back(drawn_robot(robot, "attackers", ball_m, field, draw));
  for (const DrawnRobot& robot : situation.defenders)
    state.robots[Side::kEast].push_back(drawn_robot(robot, "defenders", ball_m, field, draw));
  state.referee = {command_of(situation), ball_m, situation.is_after_stop};
  return state;
}

struct PlacedBody {
  RobotId id;
  const sim::RobotState* robot;
};

std::string name_of_body(const RobotId& id) {
  return fmt::format("{}.{}", id.side == Side::kWest ? "attackers" : "defenders", id.number);
}

bool holds_ball_inside(const sim::RobotState& robot, const sim::BallState& ball) {
  return ball.height_m < kRobotHeight_m &&
         distance_to_hull(ball.position_m, robot.position_m, robot.heading) <
             kBallRadius_m - kTouch_m;
}

// Why the state cannot be played; empty if it can.
std::string obstacle_in(const game::StartState& state, const Field& field) {
  if (state.referee.restart && !is_on_field(field, state.ball.position_m))
    return "the ball of the restart is outside the field";
  std::vector<PlacedBody> all;
  for (const Side side : kSides) {
    for (const sim::RobotState& robot : state.robots[side])
      all.push_back({{side, robot.number}, &robot});
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (holds_ball_inside(*all[i].robot, state.ball))
      return fmt::format("{} and the ball overlap", name_of_body(all[i].id));
    for (std::size_t j = 0; j < i; ++j) {
      const Vec2 between_m = all[i].robot->position_m - all[j].robot->position_m;
      if (between_m.norm() < 2 * kRobotRadius_m - kTouch_m)
        return fmt::format("{} and {} overlap", name_of_body(all[j].id), name_of_body(all[i].id));
    }
  }
  return {};
}

}  // namespace

std::array<DrawnNumber<Distribution>, 5> numbers_of(DrawnRobot& robot, const Field& field) {
  return numbers_in<Distribution>(robot, field);
}
std::array<DrawnNumber<Distribution>, 6> numbers_of(DrawnBall& ball, const Field& field) {
  return numbers_in_ball<Distribution>(ball, field);
}
std::array<DrawnNumber<const Distribution>, 5> numbers_of(const DrawnRobot& robot,
                                                          const Field& field) {
  return numbers_in<const Distribution>(robot, field);
}
std::array<DrawnNumber<const Distribution>, 6> numbers_of(const DrawnBall& ball,
                                                          const Field& field) {
  return numbers_in_ball<const Distribution>(ball, field);
}

game::StartState drawn_state(const SituationSetup& situation, const std::string& name,
                             const Field& field, std::uint64_t seed, int scene) {
  std::string obstacle;
  for (int attempt = 0; attempt < kMostRedraws; ++attempt) {
    game::StartState state = drawn_once(situation, field, Draw(seed, name, scene, attempt));
    obstacle = obstacle_in(state, field);
    if (obstacle.empty()) return state;
  }
  throw game::SettingError(fmt::format("situations.{}", name),
                           fmt::format(": {} draws of scene {} failed; in the last one {}",
                                       kMostRedraws, scene, obstacle));
}

}  // namespace autoref::experiments
