// Compares a kicked ball's predicted path with the simulated one.
#include "game/play_counts/kick_away.hpp"

#include <gtest/gtest.h>

#include "sim/presets.hpp"
#include "tests/sim/scene.hpp"

namespace autoref::game {
namespace {

// A ball kicked eastwards from near the west goal line.
struct Kicked : sim::Scene {
  explicit Kicked(double kick_mps)
      : trajectory({-2.5, 0.1}, {kick_mps, 0}, 0, sim::BallParameters{}) {
    put_robot(sim::kWest0, {-2.9, -1.9});
    put_robot(sim::kEast0, {2.9, -1.9});
    put_ball({-2.5, 0.1}, {kick_mps, 0});
  }
  double travelled_m() const { return ball().position_m.x() + 2.5; }
  BallTrajectory trajectory;
};

TEST(BallTrajectory, PredictsTimeAndSpeedOfAFlatKick) {
  for (const double kick_mps : {1.5, 3.0, 6.0}) {
    for (const int frames : {6, 20, 45}) {
      Kicked kicked(kick_mps);
      kicked.frames(frames);
      EXPECT_NEAR(kicked.trajectory.time_s(kicked.travelled_m()), frames / 60.0, 0.01);
      EXPECT_NEAR(kicked.trajectory.speed_mps(kicked.travelled_m()), kicked.ball().velocity_mps.x(),
                  0.03);
    }
  }
}

TEST(BallTrajectory, EndsWhereTheBallStops) {
  Kicked kicked(1.5);
  kicked.frames(600);
  EXPECT_EQ(kicked.ball().velocity_mps.norm(), 0);
  EXPECT_NEAR(kicked.trajectory.reach_m(), kicked.travelled_m(), 0.02);
  EXPECT_NEAR(kicked.trajectory.point_m(kicked.trajectory.reach_m()).x(),
              kicked.ball().position_m.x(), 0.02);
}

// A ball that rolls with 0.22 m/s^2 + 0.045/s v: v / k - a / k^2 ln(1 + k v / a) with v = 0.66 * 2
// m/s is 3.366 m, after sliding (2^2 - 1.32^2) / 6.6 = 0.342 m.
TEST(BallTrajectory, EndsWhereABallStopsThatSlowsDownLessAtLowSpeed) {
  sim::BallParameters ball;
  sim::apply_ball_preset("rc2026", ball);
  const BallTrajectory trajectory({0, 0}, {2, 0}, 0, ball);
  EXPECT_NEAR(trajectory.reach_m(), 0.342 + 3.366, 0.002);
  EXPECT_NEAR(trajectory.speed_mps(trajectory.reach_m()), 0, 1e-3);
}

// Length of the flight 2 * 3 * 4 / 9.81 = 2.446 m; apex at 4^2 / (2 * 9.81) = 0.815 m.
TEST(BallTrajectory, StartsWithAFlightAfterAChipKick) {
  const BallTrajectory trajectory({0, 0}, {0, 3}, 4, {});
  EXPECT_NEAR(trajectory.flight_m(), 2.446, 0.001);
  EXPECT_NEAR(trajectory.height_m(1.223), 0.815, 0.001);
  EXPECT_NEAR(trajectory.time_s(1.223), 0.408, 0.001);
  EXPECT_EQ(trajectory.height_m(2.5), 0);
  EXPECT_NEAR(trajectory.speed_mps(2.447), 0.75 * 3, 0.001);
}

}  // namespace
}  // namespace autoref::game
