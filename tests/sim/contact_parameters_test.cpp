// Each number of a contact, of the ball and of the line-up does what it is named after: the default
// and a value far from it are both seen in the world.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sim/scene.hpp"

namespace autoref::sim {
namespace {

constexpr double kRebound_mps = 4.0;

// The ball's speed away from what it hit at 4 m/s, along x, as the first frames show it; less what
// the carpet takes, 3.4 m/s^2, in one or two frames.
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
  robot.dribbler.force_n = 0.0;  // the surface alone
  Scene scene(configuration, specs(1, 1, robot));
  scene.put_robot(kWest0, {0, 0});
  scene.command(kWest0).dribble = dribbles;
  scene.frames(2);
  scene.put_ball({0.2, 0.0}, {-kRebound_mps, 0.0});
  return rebound_mps(scene);
}

// Both slide for up to 4 frames.
constexpr double kCarpet_mps = 4 * 3.4 / 60;

TEST(ContactParameters, OfWallsAndRobotsAreTheSharesOfSpeedThatTheBallKeeps) {
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

// How fast two equal robots that meet at 1 m/s each part.
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

// They brake as well, at 5 m/s^2 each, for a frame at most.
TEST(ContactParameters, OfTwoRobotsIsTheShareOfTheirClosingSpeed) {
  EXPECT_NEAR(parting_mps(quiet()), 0.2 * 2.0, 0.17);
  Configuration configuration = quiet();
  configuration.contacts.robot_restitution = 0.8;
  EXPECT_NEAR(parting_mps(configuration), 0.8 * 2.0, 0.17);
}

// The ball's speed out of the goal at its first frame after the back wall.
double off_the_net_mps(const Configuration& configuration) {
  Scene scene(configuration);
  scene.put_ball({scene.field.half_length_m() + 0.1, 0.0}, {kRebound_mps, 0.0});
  return rebound_mps(scene);
}

TEST(ContactParameters, OfTheGoalsBackIsTheShareOfSpeedThatTheBallKeeps) {
  // The net takes 10 m/s^2 besides what the carpet takes: 0.22 m/s a frame.
  EXPECT_NEAR(off_the_net_mps(quiet()), 0.1 * kRebound_mps - 0.11, 0.13);
  Configuration configuration = quiet();
  configuration.contacts.net_restitution = 0.8;
  EXPECT_NEAR(off_the_net_mps(configuration), 0.8 * kRebound_mps - 0.11, 0.23);
}

// A ball that flies at the bar with its middle as high as the bar's.
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

TEST(ContactParameters, OfTheBarIsTheShareOfSpeedThatTheBallKeeps) {
  EXPECT_NEAR(off_the_bar_mps(quiet()), 0.3 * kRebound_mps, 0.05);
  Configuration configuration = quiet();
  configuration.contacts.bar_restitution = 0.9;
  EXPECT_NEAR(off_the_bar_mps(configuration), 0.9 * kRebound_mps, 0.05);
}

// A ball drops on the middle of a robot from so high that it comes down at `falls_mps`. How it has
// left: upwards, and along the robot's heading.
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

// Gravity takes 0.16 m/s of the upward speed in a frame.
TEST(ContactParameters, OfARobotsTopAreWhatTheBallKeepsAndHowFastItLeaves) {
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

// How much of its speed along a wall a ball loses that hits the wall at 3 m/s, without the carpet.
double lost_along_the_wall_mps(Configuration configuration) {
  configuration.ball.slide_mps2 = configuration.ball.roll_mps2 = 1e-6;
  Scene scene(configuration);
  scene.put_ball({-1, 2.6}, {5.0, 3.0});
  scene.frames(6);
  return 5.0 - scene.ball().velocity_mps.x();
}

// Coulomb: friction times the change across the wall, (1 + 0.3) * 3 m/s.
TEST(ContactParameters, OfFrictionIsTheShareOfAHitThatActsAlongTheSurface) {
  EXPECT_NEAR(lost_along_the_wall_mps(quiet()), 0.22 * 1.3 * 3.0, 0.03);
  Configuration configuration = quiet();
  configuration.contacts.friction = 0.1;
  EXPECT_NEAR(lost_along_the_wall_mps(configuration), 0.1 * 1.3 * 3.0, 0.03);
}

// A ball rolls at `speed_mps` against a robot's back: how fast it comes back.
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

TEST(ContactParameters, OfLeastBounceIsTheSpeedBelowWhichNothingComesBack) {
  EXPECT_LT(slow_rebound_mps(quiet(), 0.028), 0.002);
  EXPECT_GT(slow_rebound_mps(quiet(), 0.06), 0.005);
  Configuration configuration = quiet();
  configuration.contacts.least_bounce_mps = 0.2;
  EXPECT_LT(slow_rebound_mps(configuration, 0.15), 0.002);
}

}  // namespace
}  // namespace autoref::sim
