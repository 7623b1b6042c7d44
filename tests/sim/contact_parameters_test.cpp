// Each parameter of contacts, ball and line-up has its documented effect, both at its default and
// at a value far from the default.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sim/scene.hpp"

namespace autoref::sim {
namespace {

constexpr double kRebound_mps = 4.0;

// The ball's rebound speed along x after an impact at 4 m/s, from the first frames after it:
// reduced by the carpet's friction, 3.4 m/s^2 for one or two frames.
double rebound_mps(Scene& scene) {
  double speed_mps = scene.ball().velocity_mps.x();
  const double towards = std::copysign(1.0, speed_mps);
  for (int f = 0; f < 30 && speed_mps * towards > 0.0; ++f) {
    scene.frame();
    speed_mps = scene.ball().velocity_mps.x();
  }
  return -speed_mps * towards;
}

double off_the_wall_mps(const Configuration& configuration) {
  Scene scene(configuration);
  scene.put_ball({3.5, 1.5}, {kRebound_mps, 0.0});
  return rebound_mps(scene);
}

double off_a_body_mps(const Configuration& configuration) {
  Scene scene(configuration);
  scene.put_robot(kWest0, {0, 0}, {-1, 0});
  scene.put_ball({0.2, 0.0}, {-kRebound_mps, 0.0});
  return rebound_mps(scene);
}

double off_a_plate_mps(const Configuration& configuration, bool dribbles) {
  RobotSpec robot = quiet_robot();
  robot.dribbler.force_n = 0.0;  // only the surface
  Scene scene(configuration, specs(1, 1, robot));
  scene.put_robot(kWest0, {0, 0});
  scene.command(kWest0).dribble = dribbles;
  scene.frames(2);
  scene.put_ball({0.2, 0.0}, {-kRebound_mps, 0.0});
  return rebound_mps(scene);
}

// Tolerance: the carpet slows the ball for up to 4 frames.
constexpr double kCarpet_mps = 4 * 3.4 / 60;

TEST(ContactParameters, OfWallsAndRobotsSetTheSpeedTheBallKeeps) {
  EXPECT_NEAR(off_the_wall_mps(quiet()), 0.3 * kRebound_mps, kCarpet_mps);
  EXPECT_NEAR(off_a_body_mps(quiet()), 0.55 * kRebound_mps, kCarpet_mps);
  EXPECT_NEAR(off_a_plate_mps(quiet(), false), 0.4 * kRebound_mps, kCarpet_mps);
  EXPECT_NEAR(off_a_plate_mps(quiet(), true), 0.2 * kRebound_mps, kCarpet_mps);
}

TEST(ContactParameters, OfWallsAndRobotsCanBeSet) {
  Configuration configuration = quiet();
  configuration.contacts.wall_restitution = 0.9;
  configuration.contacts.body_restitution = 0.1;
  configuration.contacts.plate_restitution = 0.8;
  configuration.contacts.dribbling_restitution = 0.6;
  EXPECT_NEAR(off_the_wall_mps(configuration), 0.9 * kRebound_mps, kCarpet_mps);
  EXPECT_NEAR(off_a_body_mps(configuration), 0.1 * kRebound_mps, kCarpet_mps);
  EXPECT_NEAR(off_a_plate_mps(configuration, false), 0.8 * kRebound_mps, kCarpet_mps);
  EXPECT_NEAR(off_a_plate_mps(configuration, true), 0.6 * kRebound_mps, kCarpet_mps);
}

// The separation speed of each of two equal robots that collide at 1 m/s each.
double parting_mps(const Configuration& configuration) {
  Scene scene(configuration);
  scene.put_robot(kWest0, {-0.1, 1}, {1, 0}, {1, 0});
  scene.put_robot(kEast0, {0.1, 1}, {-1, 0}, {-1, 0});
  double fastest_mps = 0.0;
  for (int f = 0; f < 4; ++f) {
    scene.frame();
    fastest_mps = std::max(
        fastest_mps, scene.robot(kEast0).velocity_mps.x() - scene.robot(kWest0).velocity_mps.x());
  }
  return fastest_mps;
}

// They also brake, at 5 m/s^2 each, for at most one frame.
TEST(ContactParameters, OfTwoRobotsSetsTheirSeparationSpeed) {
  EXPECT_NEAR(parting_mps(quiet()), 0.2 * 2.0, 0.17);
  Configuration configuration = quiet();
  configuration.contacts.robot_restitution = 0.8;
  EXPECT_NEAR(parting_mps(configuration), 0.8 * 2.0, 0.17);
}

// The ball's speed out of the goal in the first frame after hitting the back wall.
double off_the_net_mps(const Configuration& configuration) {
  Scene scene(configuration);
  scene.put_ball({scene.field.half_length_m() + 0.1, 0.0}, {kRebound_mps, 0.0});
  return rebound_mps(scene);
}

TEST(ContactParameters, OfTheGoalsBackSetsTheSpeedTheBallKeeps) {
  // The net takes 10 m/s^2 in addition to the carpet's deceleration: 0.22 m/s per frame.
  EXPECT_NEAR(off_the_net_mps(quiet()), 0.1 * kRebound_mps - 0.11, 0.13);
  Configuration configuration = quiet();
  configuration.contacts.net_restitution = 0.8;
  EXPECT_NEAR(off_the_net_mps(configuration), 0.8 * kRebound_mps - 0.11, 0.23);
}

// A ball flying at the bar with its centre at the height of the bar's.
double off_the_bar_mps(const Configuration& configuration) {
  Scene scene(configuration);
  BallState ball;
  ball.position_m = {scene.field.half_length_m() - 0.06, 0.0};
  ball.velocity_mps = {kRebound_mps, 0.0};
  ball.height_m = 0.1385;
  ball.is_rolling = false;
  scene.world.put_ball(ball);
  return rebound_mps(scene);
}

TEST(ContactParameters, OfTheBarSetsTheSpeedTheBallKeeps) {
  EXPECT_NEAR(off_the_bar_mps(quiet()), 0.3 * kRebound_mps, 0.05);
  Configuration configuration = quiet();
  configuration.contacts.bar_restitution = 0.9;
  EXPECT_NEAR(off_the_bar_mps(configuration), 0.9 * kRebound_mps, 0.05);
}

// Drops a ball on the centre of a robot, landing at `falls_mps`. Returns its speed afterwards:
// upwards, and along the robot's heading.
Vec2 off_a_robots_top_mps(const Configuration& configuration, double falls_mps) {
  Scene scene(configuration);
  scene.put_robot(kWest0, {0, 0});
  BallState ball;
  ball.position_m = {0, 0};
  ball.height_m = kRobotHeight_m + 0.001;
  ball.vertical_mps = -falls_mps;
  ball.is_rolling = false;
  scene.world.put_ball(ball);
  scene.frame();
  return {scene.ball().velocity_mps.x(), scene.ball().vertical_mps};
}

// Gravity reduces the upward speed by 0.16 m/s in a frame.
TEST(ContactParameters, OfARobotsTopSetTheRestitutionAndTheLeavingSpeed) {
  EXPECT_NEAR(off_a_robots_top_mps(quiet(), 3.0).y(), 0.5 * 3.0, 0.17);
  EXPECT_NEAR(off_a_robots_top_mps(quiet(), 0.1).y(), 0.5, 0.17);
  EXPECT_NEAR(off_a_robots_top_mps(quiet(), 0.1).x(), 0.5, 0.01);
  Configuration configuration = quiet();
  configuration.contacts.top_restitution = 0.9;
  configuration.contacts.top_leaving_mps = 2.0;
  EXPECT_NEAR(off_a_robots_top_mps(configuration, 3.0).y(), 0.9 * 3.0, 0.17);
  EXPECT_NEAR(off_a_robots_top_mps(configuration, 0.1).y(), 2.0, 0.17);
  EXPECT_NEAR(off_a_robots_top_mps(configuration, 0.1).x(), 2.0, 0.01);
}

// The tangential speed lost by a ball that hits a wall at 3 m/s, without the carpet's friction.
double lost_along_the_wall_mps(Configuration configuration) {
  configuration.ball.slide_mps2 = configuration.ball.roll_mps2 = 1e-6;
  Scene scene(configuration);
  scene.put_ball({-1, 2.6}, {5.0, 3.0});
  scene.frames(6);
  return 5.0 - scene.ball().velocity_mps.x();
}

// Coulomb friction: the coefficient times the normal velocity change, (1 + 0.3) * 3 m/s.
TEST(ContactParameters, OfFrictionSetsTheTangentialImpulse) {
  EXPECT_NEAR(lost_along_the_wall_mps(quiet()), 0.22 * 1.3 * 3.0, 0.03);
  Configuration configuration = quiet();
  configuration.contacts.friction = 0.1;
  EXPECT_NEAR(lost_along_the_wall_mps(configuration), 0.1 * 1.3 * 3.0, 0.03);
}

// The rebound speed of a ball that rolls at `speed_mps` against a robot's back.
double slow_rebound_mps(const Configuration& configuration, double speed_mps) {
  Scene scene(configuration);
  scene.put_robot(kWest0, {0, 0}, {-1, 0});
  scene.put_ball({0.113, 0.0}, {-speed_mps, 0.0}, true);
  double fastest_mps = 0.0;
  for (int f = 0; f < 12; ++f) {
    scene.frame();
    fastest_mps = std::max(fastest_mps, scene.ball().velocity_mps.x());
  }
  return fastest_mps;
}

TEST(ContactParameters, OfLeastBounceSetsTheMinimumSpeedOfABounce) {
  EXPECT_LT(slow_rebound_mps(quiet(), 0.028), 0.002);
  EXPECT_GT(slow_rebound_mps(quiet(), 0.06), 0.005);
  Configuration configuration = quiet();
  configuration.contacts.least_bounce_mps = 0.2;
  EXPECT_LT(slow_rebound_mps(configuration, 0.15), 0.002);
}

}  // namespace
}  // namespace autoref::sim
