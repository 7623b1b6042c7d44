// Bodies that move without Box2D while they can meet nothing move as Box2D would have moved them.
#include <gtest/gtest.h>

#include "tests/sim/chance.hpp"
#include "tests/sim/scene.hpp"

namespace autoref::sim {
namespace {

// With steps of equal length for all bodies.
Configuration moved_by(bool free_motion) {
  Configuration configuration = quiet();
  configuration.contact_free_substeps = 16;
  configuration.free_motion = free_motion;
  return configuration;
}

RobotState any_robot_state(int number, RandomStream& random) {
  RobotState robot;
  robot.number = number;
  robot.position_m = {between(random, -4.0, 4.0), between(random, -2.5, 2.5)};
  robot.heading = heading_of(between(random, -kPi, kPi));
  const double speed_mps = between(random, 0.0, 2.0);
  robot.velocity_mps = heading_of(between(random, -kPi, kPi)) * speed_mps;
  robot.angular_velocity_radps = between(random, -5.0, 5.0);
  return robot;
}

// Two worlds that differ in nothing but who moves the free bodies.
class Twins {
 public:
  explicit Twins(int robots)
      : free(moved_by(true), specs(robots, robots)),
        whole(moved_by(false), specs(robots, robots)) {}

  void put(RobotId id, const RobotState& robot) {
    free.world.put_robot(id, robot);
    whole.world.put_robot(id, robot);
  }
  void put_ball(const BallState& ball) {
    free.world.put_ball(ball);
    whole.world.put_ball(ball);
  }
  void command(RobotId id, const RobotCommand& command) {
    free.command(id) = command;
    whole.command(id) = command;
  }
  void frame() {
    free.frame();
    whole.frame();
  }
  // Gives the second world the first one's state.
  void align() {
    for (const Side side : kSides) {
      for (const RobotState& robot : free.world.state().robots[side]) {
        whole.world.put_robot({side, robot.number}, robot);
      }
    }
    whole.world.put_ball(free.ball());
    free.world.put_ball(free.ball());
  }
  double greatest_difference_m() const {
    double most_m = (free.ball().position_m - whole.ball().position_m).norm();
    for (const Side side : kSides) {
      const auto& robots = free.world.state().robots[side];
      for (std::size_t i = 0; i < robots.size(); ++i) {
        const RobotState& other = whole.world.state().robots[side][i];
        most_m = std::max(most_m, (robots[i].position_m - other.position_m).norm());
        most_m = std::max(most_m, kRobotRadius_m * (robots[i].heading - other.heading).norm());
      }
    }
    return most_m;
  }

  Scene free;
  Scene whole;
};

TEST(FreeMotion, OfARobotAndABallIsThatOfBox2d) {
  RandomStream random(5);
  for (int trial = 0; trial < 20; ++trial) {
    Twins twins(1);
    twins.put(kWest0, any_robot_state(0, random));
    RobotState away;
    away.position_m = {-4.3, 2.8};
    twins.put(kEast0, away);
    BallState ball;
    ball.position_m = {between(random, 0.0, 4.0), 2.8};
    ball.velocity_mps = {-1.0, 0.0};
    twins.put_ball(ball);
    RobotCommand command;
    command.velocity_mps = {between(random, -2.0, 2.0), between(random, -2.0, 2.0)};
    command.angular_velocity_radps = between(random, -10.0, 10.0);
    twins.command(kWest0, command);
    for (int i = 0; i < 30; ++i) twins.frame();
    ASSERT_LT(twins.greatest_difference_m(), 0.01_mm) << trial;
  }
}

// Frame after frame from the same state, in crowds that touch and collide all the time. A ball
// pinched between robots may end elsewhere, since Box2D solves its contacts in another order.
TEST(FreeMotion, OfTheOthersChangesNoContact) {
  RandomStream random(6);
  int contacts = 0;
  int shifted = 0;
  for (int trial = 0; trial < 40; ++trial) {
    Twins twins(4);
    for (const Side side : kSides) {
      for (int i = 0; i < 4; ++i) {
        RobotState robot = any_robot_state(i, random);
        robot.position_m = {0.25 * i, side == Side::kWest ? -0.15 : 0.15};
        twins.put({side, i}, robot);
      }
    }
    BallState ball;
    ball.velocity_mps = {between(random, -3.0, 3.0), between(random, -3.0, 3.0)};
    twins.put_ball(ball);
    for (int frame = 0; frame < 60; ++frame) {
      for (const Side side : kSides) {
        for (int i = 0; i < 4; ++i) {
          RobotCommand command;
          command.velocity_mps = {between(random, -2.0, 2.0), between(random, -2.0, 2.0)};
          command.kick_mps = i == 0 ? 4.0 : 0.0;
          twins.command({side, i}, command);
        }
      }
      twins.align();
      twins.frame();
      const auto touches = twins.free.world.touches();
      contacts += static_cast<int>(touches.size() + twins.free.world.collisions().size());
      ASSERT_EQ(touches.size(), twins.whole.world.touches().size()) << trial << ' ' << frame;
      ASSERT_EQ(twins.free.world.collisions().size(), twins.whole.world.collisions().size());
      shifted += twins.greatest_difference_m() > 0.05_mm ? 1 : 0;
      ASSERT_LT(twins.greatest_difference_m(), 5_mm) << trial << ' ' << frame;
    }
  }
  EXPECT_GT(contacts, 200);
  EXPECT_LE(shifted * 100, contacts);
}

}  // namespace
}  // namespace autoref::sim
