// Longer steps, which are taken while no contact is possible, never skip a collision, a command or
// a kicker's dead time.
#include "sim/contact_prediction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "soccer/trigonometry.hpp"
#include "tests/sim/chance.hpp"
#include "tests/sim/scene.hpp"

namespace autoref::sim {
namespace {

constexpr double kLongStep_s = 1.0 / 120;

Vec2 any_velocity(RandomStream& random, double most_mps) {
  const double angle_rad = between(random, 0, 2 * kPi);
  return heading_of(angle_rad) * between(random, 0, most_mps);
}

// Two robots and a ball close together, somewhere on the field or near its walls.
class Crowd {
 public:
  explicit Crowd(RandomStream& random)
      : bodies(field, ContactParameters{}, BallParameters{}.mass_kg,
               std::vector<double>(2, RobotParameters{}.mass_kg)) {
    const double x = between(random, -field.wall_x_m(), field.wall_x_m());
    const double y = between(random, -field.wall_y_m(), field.wall_y_m());
    for (int i = 0; i < 2; ++i) bodies.place_robot(i, any_robot(random, {x, y}));
    const Vec2 ball_m = near(random, {x, y});
    bodies.place_ball(ball_m, any_velocity(random, 8.0));
  }

  bool is_possible() const {
    for (int i = 0; i < 2; ++i) {
      const Vec2 to_ball_m = bodies.ball().position_m - bodies.robot(i).position_m;
      if (is_in_wall(bodies.robot(i).position_m, kRobotRadius_m)) return false;
      if (to_ball_m.norm() < kRobotRadius_m + kBallRadius_m) return false;
    }
    return !is_in_wall(bodies.ball().position_m, kBallRadius_m) &&
           (bodies.robot(0).position_m - bodies.robot(1).position_m).norm() > 2 * kRobotRadius_m;
  }

  Field field;
  Box2dBridge bodies;

 private:
  static Vec2 near(RandomStream& random, const Vec2& position_m) {
    const double x = between(random, -0.25, 0.25);
    const double y = between(random, -0.25, 0.25);
    return position_m + Vec2(x, y);
  }

  static BodyState any_robot(RandomStream& random, const Vec2& position_m) {
    BodyState robot;
    robot.position_m = near(random, position_m);
    robot.velocity_mps = any_velocity(random, 3.0);
    return robot;
  }

  bool is_in_wall(const Vec2& at_m, double radius_m) const {
    const double x = std::abs(at_m.x()) + radius_m;
    const double y = std::abs(at_m.y());
    const double goal_y_m = field.half_goal_m() + field.goal_wall_thickness_m;
    return x > field.wall_x_m() || y + radius_m > field.wall_y_m() ||
           (x > field.half_length_m() && y - radius_m < goal_y_m);
  }
};

// The greatest velocity changes while the crowd moves without any drive.
struct Changes {
  double ball_mps = 0;
  double robot_mps = 0;
};

Changes changes_within_a_long_step(Crowd& crowd) {
  const BodyState ball = crowd.bodies.ball();
  const BodyState one = crowd.bodies.robot(0);
  const BodyState other = crowd.bodies.robot(1);
  for (int k = 0; k < 2; ++k) crowd.bodies.step(kLongStep_s / 2);
  return {(crowd.bodies.ball().velocity_mps - ball.velocity_mps).norm(),
          std::max((crowd.bodies.robot(0).velocity_mps - one.velocity_mps).norm(),
                   (crowd.bodies.robot(1).velocity_mps - other.velocity_mps).norm())};
}

TEST(ContactPrediction, MissesOnlyGentleCollisionsBetweenRobots) {
  RandomStream random(11);
  int contact_prediction = 0;
  int collisions = 0;
  for (int i = 0; i < 40000; ++i) {
    Crowd crowd(random);
    if (!crowd.is_possible()) continue;
    const bool is_contact_free = !ContactPrediction(crowd.field, specs(1, 1), kLongStep_s)
                                      .encounters(crowd.bodies, 2, false)
                                      .need_short_steps;
    const Changes changes = changes_within_a_long_step(crowd);
    contact_prediction += is_contact_free ? 1 : 0;
    collisions += changes.ball_mps > 0.01 || changes.robot_mps > 0.5 ? 1 : 0;
    if (!is_contact_free) continue;
    ASSERT_LT(changes.ball_mps, 1e-6) << i;
    ASSERT_LT(changes.robot_mps, 0.5) << i;  // less than their closing speed
  }
  EXPECT_GT(contact_prediction, 1000);
  EXPECT_GT(collisions, 1000);
}

Configuration with(int substeps, int contact_free_substeps) {
  Configuration configuration = quiet();
  configuration.substeps = substeps;
  configuration.contact_free_substeps = contact_free_substeps;
  return configuration;
}

// A robot drives past a rolling ball, both far from everything else.
Scene far_apart(const Configuration& configuration) {
  Scene scene(configuration);
  scene.put_robot(kWest0, {-2, 1});
  scene.put_robot(kEast0, {2, 1});
  scene.put_ball({0, -1}, {1, 0}, true);
  scene.command(kWest0).velocity_mps = {1, 0};
  return scene;
}

// A ball flies at a robot's front.
Scene about_to_meet(const Configuration& configuration) {
  Scene scene(configuration);
  scene.put_robot(kEast0, {0.2, 0}, {-1, 0});
  scene.put_ball({0.05, 0}, {6, 0});
  return scene;
}

TEST(FarFromEverything, TheWorldTakesTheLongerSteps) {
  Scene adaptive = far_apart(with(4, 2));
  Scene coarse = far_apart(with(2, 2));
  adaptive.frames(30);
  coarse.frames(30);
  EXPECT_EQ(adaptive.robot(kWest0).position_m, coarse.robot(kWest0).position_m);
  EXPECT_EQ(adaptive.ball().position_m, coarse.ball().position_m);
}

TEST(NearAContact, TheWorldTakesTheShortSteps) {
  Scene adaptive = about_to_meet(with(4, 2));
  Scene fine = about_to_meet(with(4, 4));
  adaptive.frames(1);
  fine.frames(1);
  ASSERT_LT(fine.ball().velocity_mps.x(), 0.0);
  EXPECT_EQ(adaptive.ball().position_m, fine.ball().position_m);
  EXPECT_EQ(adaptive.ball().velocity_mps, fine.ball().velocity_mps);
}

// A Box2D step covers 0.2 m at most: 12 m/s with steps of 1/60 s.
TEST(AFastBall, IsNotSlowedDownByLongerSteps) {
  Scene scene(with(4, 1));
  scene.put_robot(kWest0, {-2, 1});
  scene.put_robot(kEast0, {2, 1});
  scene.put_ball({-2, -1}, {20, 0});
  scene.frame();
  EXPECT_NEAR(scene.ball().velocity_mps.x(), 20 - 3.4 / 60, 1e-3);
}

class CommandDelay : public testing::TestWithParam<int> {};  // sub-steps

// The speed of a robot a frame after its first command, which takes effect that many sub-steps
// late.
double speed_after_delay_mps(int delay_substeps, int contact_free_substeps) {
  Configuration late = with(4, contact_free_substeps);
  late.latency_s = delay_substeps / 240.0;
  Scene scene = far_apart(late);
  scene.frame();
  return scene.robot(kWest0).velocity_mps.x();
}

TEST_P(CommandDelay, IsTheSameWithLongerSteps) {
  const double driven_s = (4 - GetParam()) / 240.0;  // at 3 m/s^2
  EXPECT_NEAR(speed_after_delay_mps(GetParam(), 4), 3.0 * driven_s, 1e-4);
  EXPECT_NEAR(speed_after_delay_mps(GetParam(), 2), 3.0 * driven_s, 1e-4);
  EXPECT_NEAR(speed_after_delay_mps(GetParam(), 1), 3.0 * driven_s, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Substeps, CommandDelay, testing::Values(0, 1, 2, 3));

// Moves the ball away for `frames` after a kick, then back into the dribbler zone. Returns whether
// the next kick occurs.
bool is_kicked_again_after(int frames, int contact_free_substeps) {
  Scene scene(with(4, contact_free_substeps));
  scene.put_robot(kWest0, {-2, 1});
  scene.put_robot(kEast0, {2, 1});
  scene.put_ball_at_plate(kWest0, 0.005);
  scene.command(kWest0).kick_mps = 2.0;
  scene.frame();
  for (int f = 1; f < frames; ++f) {
    scene.put_ball({0, -1});
    scene.frame();
  }
  scene.put_ball_at_plate(kWest0, 0.005);
  scene.frame();
  return scene.ball().velocity_mps.norm() > 1.5;
}

class KickersDeadTime : public testing::TestWithParam<int> {};  // sub-steps without contacts

// 100 ms are six frames.
TEST_P(KickersDeadTime, IsTheSameWithLongerSteps) {
  EXPECT_FALSE(is_kicked_again_after(5, GetParam()));
  EXPECT_TRUE(is_kicked_again_after(6, GetParam()));
}

INSTANTIATE_TEST_SUITE_P(ContactFreeSubsteps, KickersDeadTime, testing::Values(4, 2, 1),
                         testing::PrintToStringParamName());

// The speed of two robots after colliding at `closing_mps`.
double predicted_parting_mps(double closing_mps, int contact_free_substeps) {
  RobotSpec weak = quiet_robot();
  weak.body.acceleration_mps2 = 1e-6;
  weak.body.braking_mps2 = 1e-6;
  Scene scene(with(4, contact_free_substeps), specs(1, 1, weak));
  scene.put_robot(kWest0, {-0.1, 0}, {1, 0}, {closing_mps / 2, 0});
  scene.put_robot(kEast0, {0.1, 0}, {-1, 0}, {-closing_mps / 2, 0});
  scene.put_ball({0, -1.5});
  scene.frames(30);
  return scene.robot(kEast0).velocity_mps.x() - scene.robot(kWest0).velocity_mps.x();
}

class RobotsThatMeetGently : public testing::TestWithParam<int> {};  // closing speed in mm/s

TEST_P(RobotsThatMeetGently, SeparateTheSameAfterLongerSteps) {
  const double closing_mps = GetParam() / 1000.0;
  const double fine_mps = predicted_parting_mps(closing_mps, 4);
  EXPECT_NEAR(predicted_parting_mps(closing_mps, 2), fine_mps, 1e-3);
  EXPECT_NEAR(fine_mps, 0.2 * closing_mps, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(AtMillimetresPerSecond, RobotsThatMeetGently,
                         testing::Values(100, 200, 300, 400, 490),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace autoref::sim
