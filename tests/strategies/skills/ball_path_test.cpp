#include "strategies/skills/ball_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/strategies/staged_world.hpp"
#include "tracking/ball_tracker.hpp"

namespace autoref::strategies {
namespace {

// A kick at 3 m/s slides 0.729 m in 0.291 s, then rolls from 2.01 m/s for the remaining 1.709 s of
// 2 s.
TEST(BallPath, SlidesAndRollsAfterAKick) {
  BallPath path;
  path.follow({{-2, 1}, {0, 3}}, 0);
  EXPECT_NEAR(path.at_step(2).y() - 1, 3 * 0.2 - 3.4 * 0.2 * 0.2 / 2, 0.03);
  EXPECT_NEAR(path.end_m().y() - 1, 0.729 + 2.01 * 1.709 - 0.30 * 1.709 * 1.709 / 2, 0.15);
  EXPECT_NEAR(path.end_m().x(), -2, 1e-9);
}

TEST(BallPath, EndsWhereASlowBallStops) {
  const CarpetBall ball{{0, 0}, {1, 0}, 0.6};  // stops after 1.4 s
  BallPath path;
  path.follow(ball.at(0), 0);
  EXPECT_NEAR(path.end_m().x(), ball.longest_m(), 0.05 * ball.longest_m());
  EXPECT_EQ(path.at_step(18), path.end_m());
}

const std::vector<int> kNever;

// A ball kicked at that speed, and its path.
class FollowedKick : public testing::TestWithParam<double> {
 protected:
  // Follows the ball for 1.5 s. Returns the frames after which the condition, a function of the
  // time, does not hold.
  template <typename Condition>
  std::vector<int> wrong_frames(double latency_s, Condition is_right) {
    std::vector<int> wrong;
    for (int frame = 0; frame <= 90; ++frame) {
      const double now_s = frame * kStagedFrame_s;
      path.follow(ball.at(now_s), latency_s);
      if (!is_right(now_s)) wrong.push_back(frame);
    }
    return wrong;
  }

  CarpetBall ball{{0, 0}, {0.6, -0.8}, GetParam()};
  BallPath path;
};

TEST_P(FollowedKick, HasPredictedLaterPositions) {
  const auto is_right = [&](double now_s) {
    const Vec2 later_m = ball.at(now_s + 1).position_m;
    const double rolls_m = (later_m - ball.at(now_s).position_m).norm();
    return (path.at_step(10) - later_m).norm() < 0.05 * rolls_m;
  };
  EXPECT_EQ(wrong_frames(0, is_right), kNever);
}

TEST(BallPath, StartsWhereTheBallIsWhenCommandsTakeEffect) {
  const CarpetBall ball{{1, 1}, {-1, 0}, 4};
  BallPath path;
  path.follow(ball.at(0), 0.1);
  EXPECT_NEAR(path.now_m().x(), ball.at(0.1).position_m.x(), 0.02);
  EXPECT_NEAR(path.at_step(5).x(), ball.at(0.6).position_m.x(), 0.1);
}

// A kick at 0.507 s, between two frames, as reported by the tracker from its second frame on.
TEST(BallPath, PredictsAFastKickWithinSevenCentimetresPerSecond) {
  const CarpetBall kick{{-2, 0}, {1, 0}, 6};
  const auto at = [&](double time_s) { return kick.at(std::max(0.0, time_s - 0.507)); };
  tracking::BallTracker tracker(0);
  BallPath path;
  for (int frame = 0; frame < 90; ++frame) {
    const double now_s = frame * kStagedFrame_s;
    path.follow(*tracker.update(now_s, BallObservation{at(now_s).position_m, 0.0}, {}), 0);
    if (frame < 32) continue;
    for (const int step : {2, 5, 10}) {
      const Vec2 there_m = at(now_s + step * BallPath::kStep_s).position_m;
      ASSERT_LT((path.at_step(step) - there_m).norm(), 7_mm * step) << frame << ", step " << step;
    }
  }
}

TEST_P(FollowedKick, HasThePredictedSpeedWhenCommandsTakeEffect) {
  const auto is_right = [&](double now_s) {
    return std::abs(path.speed_mps() - ball.at(now_s + 0.05).velocity_mps.norm()) <= 0.03;
  };
  EXPECT_EQ(wrong_frames(0.05, is_right), kNever);
}

// "1500mm_per_s"
std::string name_of_speed(const testing::TestParamInfo<double>& test) {
  return std::to_string(std::lround(test.param * 1000)) + "mm_per_s";
}

INSTANTIATE_TEST_SUITE_P(KickedAt, FollowedKick, testing::Values(1.5, 4.0, 8.0), name_of_speed);

TEST(BallPath, KeepsABallAtRestWhereItIs) {
  BallPath path;
  path.follow({{0.3, -0.4}, {0, 0}}, 0.05);
  EXPECT_EQ(path.now_m(), Vec2(0.3, -0.4));
  EXPECT_EQ(path.end_m(), Vec2(0.3, -0.4));
  EXPECT_EQ(path.speed_mps(), 0);
}

void follow_for_a_second(BallPath& path, const CarpetBall& ball) {
  for (int frame = 0; frame < 60; ++frame) path.follow(ball.at(frame * kStagedFrame_s), 0);
}

TEST(BallPath, DetectsThatARollingBallIsKickedAgain) {
  const CarpetBall first{{0, 0}, {1, 0}, 3};
  const CarpetBall second{first.at(1).position_m, {0, 1}, 5};
  BallPath path;
  follow_for_a_second(path, first);
  path.follow(second.at(0), 0);
  EXPECT_LT((path.end_m() - second.at(2).position_m).norm(), 0.3);
}

// The remaining speed of a kick after `distance_m`.
double left_mps(const CarpetBall& kick, double distance_m) {
  const double slid_m = std::min(distance_m, kick.slide_m());
  const double rolled_m = distance_m - slid_m;
  const double slid2 = kick.kick_mps * kick.kick_mps - 2 * CarpetBall::kSlide_mps2 * slid_m;
  return std::sqrt(std::max(0.0, slid2 - 2 * CarpetBall::kRoll_mps2 * rolled_m));
}

TEST(KickFor, ArrivesWithTheRequestedSpeed) {
  for (const double distance_m : {0.2, 1.0, 3.0, 6.0}) {
    for (const double arrival_mps : {1.0, 2.0, 4.0}) {
      const CarpetBall kick{{0, 0}, {1, 0}, kick_for_mps(distance_m, arrival_mps)};
      EXPECT_NEAR(left_mps(kick, distance_m), arrival_mps, 0.05 * arrival_mps) << distance_m;
    }
  }
}

TEST(RollTime, IsTheTimeForThatDistance) {
  for (const double kick_mps : {2.0, 5.0, 8.0}) {
    for (const double distance_m : {0.1, 0.5, 2.0}) {
      const CarpetBall kick{{0, 0}, {1, 0}, kick_mps};
      const double time_s = KickedBall(kick_mps).roll_time_s(distance_m);
      EXPECT_NEAR(kick.at(time_s).position_m.x(), distance_m, 0.05 * distance_m) << kick_mps;
    }
  }
}

TEST(RollTime, IsTenSecondsIfTheBallNeverGetsThere) {
  const CarpetBall kick{{0, 0}, {1, 0}, 1};
  EXPECT_LT(KickedBall(1).roll_time_s(0.9 * kick.longest_m()), 5);
  EXPECT_EQ(KickedBall(1).roll_time_s(1.1 * kick.longest_m()), 10);
}

}  // namespace
}  // namespace autoref::strategies
