#include "logs/fit/contact_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "soccer/random.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

constexpr double kReboundRate_hz = 60;
constexpr double kReboundNoise_m = 0.001;
constexpr int kEpisode_frames = 90;

sim::BallParameters carpet() {
  sim::BallParameters ball;
  ball.slide_mps2 = 4.0;
  ball.roll_mps2 = 0.4;
  ball.switch_ratio = 0.65;
  return ball;
}

// A ball that rolls along x until it meets something at x = 0 at time 0, and then slides back.
struct Rebound {
  double closing_mps = 2.0;
  double restitution = 0.5;

  double at(double time_s) const {
    const sim::BallParameters ball = carpet();
    if (time_s < 0) return closing_mps * time_s - ball.roll_mps2 * time_s * time_s / 2;
    const double slid_s = std::min(time_s, sliding_s());
    const double rolled_s = std::min(time_s - slid_s, speed_then_mps() / ball.roll_mps2);
    return -restitution * closing_mps * slid_s + ball.slide_mps2 * slid_s * slid_s / 2 -
           speed_then_mps() * rolled_s + ball.roll_mps2 * rolled_s * rolled_s / 2;
  }

 private:
  // The ball keeps a third of its spin. Sliding changes speed and spin in the ratio 1 to inertia.
  double sliding_s() const {
    return (restitution + 1.0 / 3) * closing_mps * (1 - carpet().switch_ratio) /
           carpet().slide_mps2;
  }
  double speed_then_mps() const {
    return restitution * closing_mps - carpet().slide_mps2 * sliding_s();
  }
};

// One rebound after another.
class Rebounds {
 public:
  Rebounds() {
    motion_.interval_s = 1 / kReboundRate_hz;
    motion_.ball_noise_m = kReboundNoise_m;
  }

  // The ball meets something at `at_m`, `into` its surface, and moves evenly along the surface.
  void add(const Rebound& rebound, const Vec2& at_m, const Vec2& into, double along_mps) {
    const double phase = random_.uniform();
    for (int i = 0; i < kEpisode_frames; ++i) {
      const double time_s = (i + phase - kEpisode_frames / 2) / kReboundRate_hz;
      BallSight sight;
      sight.time_s = static_cast<double>(motion_.frames()) / kReboundRate_hz;
      sight.position_m = at_m + rebound.at(time_s) * into + along_mps * time_s * left_of(into) +
                         kReboundNoise_m * Vec2(random_.normal(), random_.normal());
      sight.is_seen = random_.uniform() > 0.03;
      motion_.times_s.push_back(sight.time_s);
      motion_.is_running.push_back(1);
      motion_.ball.push_back(sight);
      motion_.nearest_m.push_back(9);
      motion_.nearest_robot.push_back(0);
    }
  }

  // A robot that stands at `position_m` all the time.
  void add_robot(const Vec2& position_m, double heading_rad) {
    RobotSight sight{position_m, heading_rad, 0, true, true};
    motion_.robots.push_back({{Side::kWest, 1}, {motion_.frames(), sight}});
  }

  double random(double low, double high) { return low + (high - low) * random_.uniform(); }
  RecordedMotion& motion() { return motion_; }

 private:
  RandomStream random_{7};
  RecordedMotion motion_;
};

// Rebounds off the north wall.
RecordedMotion wall_rebounds(int count, double restitution) {
  Rebounds rebounds;
  const double wall_m = rebounds.motion().field.wall_y_m() - kBallRadius_m;
  for (int i = 0; i < count; ++i) {
    const double closing_mps = rebounds.random(1.2, 3.0);
    const double along_mps = rebounds.random(-1, 1);
    rebounds.add({closing_mps, restitution}, {0.5, wall_m}, {0, 1}, along_mps);
  }
  return rebounds.motion();
}

// Rebounds off the east side of a robot at the origin.
RecordedMotion body_rebounds(int count, double restitution, double heading_rad) {
  Rebounds rebounds;
  for (int i = 0; i < count; ++i) {
    const Vec2 out = heading_of(rebounds.random(-0.7, 0.7));
    const double closing_mps = rebounds.random(1.2, 3.0);
    rebounds.add({closing_mps, restitution}, (kRobotRadius_m + kBallRadius_m) * out, -out,
                 rebounds.random(-0.5, 0.5));
  }
  rebounds.add_robot({0, 0}, heading_rad);
  return rebounds.motion();
}

void expect_restitution(const Estimate& estimate, double truth, double tolerance) {
  ASSERT_TRUE(estimate.number);
  EXPECT_NEAR(estimate.number->value, truth, tolerance);
  EXPECT_LT(estimate.number->low, truth);
  EXPECT_GT(estimate.number->high, truth);
  EXPECT_LT(estimate.number->high - estimate.number->low, 0.2);
}

TEST(ContactFit, FindsTheWallsRestitution) {
  for (const double truth : {0.25, 0.55}) {
    ContactFit fit(carpet());
    fit.add(wall_rebounds(30, truth));
    expect_restitution(fit.wall_restitution(), truth, 0.03);
    EXPECT_GE(fit.wall_restitution().episodes, 20);
    EXPECT_EQ(fit.body_restitution().episodes, 0);
  }
}

TEST(ContactFit, FindsTheBodysRestitution) {
  for (const double truth : {0.35, 0.6}) {
    ContactFit fit(carpet());
    fit.add(body_rebounds(30, truth, kPi));
    expect_restitution(fit.body_restitution(), truth, 0.05);
    EXPECT_GE(fit.body_restitution().episodes, 20);
    EXPECT_EQ(fit.wall_restitution().episodes, 0);
  }
}

TEST(ContactFit, HasNoNumberFromAFewBounces) {
  ContactFit fit(carpet());
  fit.add(wall_rebounds(3, 0.5));
  fit.add(body_rebounds(3, 0.5, kPi));
  EXPECT_GE(fit.wall_restitution().episodes, 1);
  EXPECT_FALSE(fit.wall_restitution().number);
  EXPECT_GE(fit.body_restitution().episodes, 1);
  EXPECT_FALSE(fit.body_restitution().number);
}

// The speed that a ball loses by sliding and rolling must not count as lost in the bounce.
TEST(ContactFit, AllowsForMoreSliding) {
  ContactFit fit(carpet());
  fit.add(wall_rebounds(30, 0.5));
  sim::BallParameters slippery = carpet();
  slippery.slide_mps2 = 3.0;
  ContactFit wrong(slippery);
  wrong.add(wall_rebounds(30, 0.5));
  ASSERT_TRUE(wrong.wall_restitution().number);
  EXPECT_LT(wrong.wall_restitution().number->value, fit.wall_restitution().number->value - 0.005);
}

// Plates and dribblers damp the ball more than bodies do.
TEST(ContactFit, IgnoresBouncesOffTheFront) {
  ContactFit fit(carpet());
  fit.add(body_rebounds(30, 0.2, 0));
  EXPECT_EQ(fit.body_restitution().episodes, 0);
}

TEST(ContactFit, IgnoresBouncesBesideAnotherRobot) {
  RecordedMotion motion = body_rebounds(30, 0.5, kPi);
  motion.robots.push_back(motion.robots[0]);
  for (RobotSight& sight : motion.robots[1].sights) sight.position_m = {0.15, 0.15};
  ContactFit fit(carpet());
  fit.add(motion);
  EXPECT_LE(fit.body_restitution().episodes, 10);
}

TEST(ContactFit, IgnoresTheWallsAroundAGoal) {
  Rebounds rebounds;
  const double wall_m = rebounds.motion().field.wall_x_m() - kBallRadius_m;
  for (int i = 0; i < 30; ++i) rebounds.add({2.0, 0.5}, {wall_m, 0.1}, {1, 0}, 0);
  ContactFit fit(carpet());
  fit.add(rebounds.motion());
  EXPECT_EQ(fit.wall_restitution().episodes, 0);
}

}  // namespace
}  // namespace autoref::logs
