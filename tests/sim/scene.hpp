// Small worlds for tests: noiseless motors and kickers, robots out of the way.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sim/world.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::sim {

inline Configuration quiet() {
  Configuration configuration;
  configuration.latency_s = 0.0;
  return configuration;
}

inline RobotSpec quiet_robot() {
  RobotSpec robot;
  robot.body.speed_noise = 0.0;
  robot.kicker.speed_noise = 0.0;
  robot.kicker.direction_noise_deg = 0.0;
  return robot;
}

// Specs with this many robots per side, all like `robot`.
inline PerSide<TeamSpec> specs(std::size_t west, std::size_t east,
                               const RobotSpec& robot = quiet_robot()) {
  return {{TeamSpec{TeamSpec::Robots(west, robot)}, TeamSpec{TeamSpec::Robots(east, robot)}}};
}

inline constexpr RobotId kWest0{Side::kWest, 0};
inline constexpr RobotId kEast0{Side::kEast, 0};

// One robot per side by default.
struct Scene {
  explicit Scene(const Configuration& configuration = quiet(),
                 const PerSide<TeamSpec>& teams = specs(1, 1), std::uint64_t seed = 1)
      : world(field, configuration, teams, seed) {}

  void put_robot(RobotId id, const Vec2& position_m, const Vec2& heading = {1, 0},
                 const Vec2& velocity_mps = {0, 0}) {
    world.put_robot(id, {id.number, position_m, heading, velocity_mps, 0.0});
  }
  void put_ball(const Vec2& position_m, const Vec2& velocity_mps = {0, 0}, bool rolls = false) {
    BallState ball;
    ball.position_m = position_m;
    ball.velocity_mps = velocity_mps;
    ball.is_rolling = rolls;
    world.put_ball(ball);
  }
  // Puts the ball at the centre of a resting robot's plate.
  void put_ball_at_plate(RobotId id, double gap_m = 0.0) {
    const RobotState& at = robot(id);
    put_ball(at.position_m + at.heading * (kFrontDistance_m + kBallRadius_m + gap_m), {0, 0}, true);
  }
  RobotCommand& command(RobotId id) {
    return commands[id.side][static_cast<std::size_t>(id.number)];
  }

  const BallState& ball() const { return world.state().ball; }
  const RobotState& robot(RobotId id) const {
    return world.state().robots[id.side][static_cast<std::size_t>(id.number)];
  }
  void frame() { world.step(commands, placement); }
  void frames(int count) {
    for (int i = 0; i < count; ++i) frame();
  }
  // The smallest value of a quantity after each of the next frames.
  template <typename Quantity>
  double least_over(int count, Quantity quantity) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < count; ++i) {
      frame();
      least = std::min<double>(least, quantity());
    }
    return least;
  }
  // The greatest value.
  template <typename Quantity>
  double most_over(int count, Quantity quantity) {
    return -least_over(count, [&] { return -quantity(); });
  }
  // The mean value.
  template <typename Quantity>
  double mean_over(int count, Quantity quantity) {
    double sum = 0;
    for (int i = 0; i < count; ++i) {
      frame();
      sum += quantity();
    }
    return sum / count;
  }
  // The touches in the next frames; each must have the number of its frame.
  std::vector<Touch> touches_over(int count) {
    std::vector<Touch> touches;
    for (int i = 0; i < count; ++i) {
      frame();
      for (const Touch& touch : world.touches()) {
        EXPECT_EQ(touch.frame, world.state().frame);
        touches.push_back(touch);
      }
    }
    return touches;
  }

  Field field;
  World world;
  PerSide<TeamCommands> commands{};
  std::optional<Placement> placement;
};

// A number as a test's name: "minus_45".
inline std::string name_of_number(const testing::TestParamInfo<int>& test) {
  return (test.param < 0 ? "minus_" : "") + std::to_string(std::abs(test.param));
}

}  // namespace autoref::sim
