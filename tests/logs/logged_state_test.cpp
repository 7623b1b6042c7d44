// The state of a log at a time.
#include "logs/logged_state.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "soccer/referee_signal.hpp"
#include "tests/support/short_log.hpp"

namespace autoref::logs {
namespace {

// The frames of a log, and the signals with their times.
struct WholeLog final : league::LogVisitor {
  void on_frame(const Frame& frame) override { frames.push_back(frame); }
  std::vector<Frame> frames;
};

class LoggedStateTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    log_ = write_short_log(*folder_, "2026-b");
    league::read_log(log_, whole_);
  }
  static void TearDownTestSuite() { folder_.reset(); }

  // The frame at a share of the log's length.
  static const Frame& frame_at(double share) {
    return whole_
        .frames[static_cast<std::size_t>(share * static_cast<double>(whole_.frames.size()))];
  }

  static std::unique_ptr<TemporaryFolder> folder_;
  static std::string log_;
  static WholeLog whole_;
};

std::unique_ptr<TemporaryFolder> LoggedStateTest::folder_;
std::string LoggedStateTest::log_;
WholeLog LoggedStateTest::whole_;

// The teams change ends at half-time, so the second half is turned.
void expect_near(const Frame& frame, const game::StartState& start, bool is_turned) {
  for (const Side side : kSides) {
    ASSERT_EQ(start.robots[side].size(), frame.robots[side].size());
    for (std::size_t i = 0; i < frame.robots[side].size(); ++i) {
      const RobotObservation& seen = frame.robots[side][i];
      const sim::RobotState& robot = start.robots[side][i];
      EXPECT_EQ(robot.number, seen.number);
      EXPECT_LT((robot.position_m - published(seen.position_m, !is_turned)).norm(), 0.02);
      EXPECT_GT(robot.heading.dot(published(seen.heading, !is_turned)), 0.99);
    }
  }
  ASSERT_TRUE(frame.ball);
  EXPECT_LT((start.ball.position_m - published(frame.ball->position_m, !is_turned)).norm(), 0.02);
}

TEST_F(LoggedStateTest, HasTheRobotsAndTheBallOfTheLog) {
  const Frame& frame = frame_at(0.25);
  expect_near(frame, logged_state(log_, frame.time_s).start, false);
}

TEST_F(LoggedStateTest, HasYellowInTheWestAfterHalfTime) {
  const Frame& frame = frame_at(0.95);
  expect_near(frame, logged_state(log_, frame.time_s).start, true);
}

TEST_F(LoggedStateTest, HasTheVelocitiesOfTheTracks) {
  double largest_mps = 0;
  for (const double share : {0.2, 0.23, 0.26, 0.29}) {
    const auto number = static_cast<std::size_t>(share * static_cast<double>(whole_.frames.size()));
    const Frame& before = whole_.frames[number - 6];
    const Frame& frame = whole_.frames[number];
    const game::StartState start = logged_state(log_, frame.time_s).start;
    for (std::size_t i = 0; i < start.robots[Side::kWest].size(); ++i) {
      const Vec2 moved_m =
          frame.robots[Side::kWest][i].position_m - before.robots[Side::kWest][i].position_m;
      const Vec2 mean_mps = moved_m / (frame.time_s - before.time_s);
      const Vec2& velocity_mps = start.robots[Side::kWest][i].velocity_mps;
      EXPECT_LT((velocity_mps - mean_mps).norm(), 0.6);
      largest_mps = std::max(largest_mps, velocity_mps.norm());
    }
  }
  EXPECT_GT(largest_mps, 0.3);
}

// The kick-off of a game of AutoRef's begins with a stop.
TEST_F(LoggedStateTest, HasTheNextRestartDuringAStop) {
  const referee::MidwayStart midway_start = logged_state(log_, 0.5).start.referee;
  EXPECT_TRUE(midway_start.is_stopped);
  ASSERT_TRUE(midway_start.restart);
  EXPECT_EQ(midway_start.restart->kind, CommandKind::kPrepareKickoff);
  EXPECT_EQ(midway_start.ball_m, Vec2(0, 0));
}

std::string error_at(const std::string& log, double at_s) {
  try {
    logged_state(log, at_s);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "read";
}

TEST_F(LoggedStateTest, IsAnErrorBeyondTheLogOrWithoutALog) {
  EXPECT_NE(error_at(log_, 9999).find("which covers 0.000 to"), std::string::npos);
  EXPECT_NE(error_at(log_, 9999).find("9999 s is outside the log"), std::string::npos);
  EXPECT_NE(error_at(log_ + ".no", 1).find(".no"), std::string::npos);
}

TEST(Renumber, KeepsNumbersThatTheTeamHas) {
  game::StartingRobots robots = {sim::RobotState{.number = 1},
                                 sim::RobotState{.number = 5, .position_m = {1, 0}}};
  renumber(robots, 6);
  EXPECT_EQ(robots[1].number, 5);
  renumber(robots, 4);
  EXPECT_EQ(robots[0].number, 0);
  EXPECT_EQ(robots[1].number, 1);
  EXPECT_THROW(renumber(robots, 1), std::invalid_argument);
}

}  // namespace
}  // namespace autoref::logs
