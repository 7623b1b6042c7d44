// The state of a log at a time.
#include "logs/logged_state.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "soccer/referee_signal.hpp"
#include "tests/league/scratch_log.hpp"
#include "tests/logs/sketched_log.hpp"
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

TEST_F(LoggedStateTest, HasWhatWasSeenBefore) {
  const Frame& at = frame_at(0.25);
  const std::vector<Frame> seen = logged_state(log_, at.time_s).start.seen_before;
  ASSERT_GE(seen.size(), 30U);
  EXPECT_NEAR(seen.front().time_s, -0.6, 0.02);
  EXPECT_NEAR(seen.back().time_s, -1 / 60.0, 1e-3);
  const std::size_t number = static_cast<std::size_t>(&at - whole_.frames.data()) - seen.size();
  for (const Side side : kSides) {
    const RobotObservation& robot = whole_.frames[number].robots[side][1];
    EXPECT_LT((seen.front().robots[side][1].position_m - robot.position_m).norm(), 0.02);
  }
}

// The score changes within the first half and within the second one.
TEST(LoggedStateOfASketch, HasTheSignalAndTheGoalsOfEarlierHalves) {
  const league::ScratchFile file(".log");
  SketchedLog sketch;
  sketch.length_s = 12;
  sketch.change_referee = [](double time_s, league::RefereePacket& packet) {
    packet.set_stage(static_cast<int>(time_s < 6 ? Stage::kFirstHalf : Stage::kSecondHalf));
    packet.mutable_yellow()->set_score(time_s < 3 ? 1 : 2);
    packet.mutable_blue()->set_score(time_s < 9 ? 0 : 1);
    packet.mutable_blue()->add_yellow_card_times(60'000'000);
    packet.set_stage_time_left(200'000'000);
  };
  write_sketch(sketch, file.path());
  const referee::MidwayStart first = logged_state(file.path(), 5).start.referee;
  EXPECT_EQ(first.signal->goals, (PerSide<int>{{2, 0}}));
  EXPECT_EQ(first.goals_in_earlier_halves, PerSide<int>{});
  const referee::MidwayStart second = logged_state(file.path(), 10).start.referee;
  EXPECT_EQ(second.signal->stage, Stage::kSecondHalf);
  EXPECT_EQ(second.signal->stage_time_left_s, 200);
  EXPECT_EQ(second.signal->goals, (PerSide<int>{{2, 1}}));
  EXPECT_EQ(second.goals_in_earlier_halves, (PerSide<int>{{2, 0}}));
  EXPECT_EQ(second.signal->yellow_left_s[Side::kEast].size(), 1U);
}

TEST(LoggedStateOfASketch, WithoutARefereeHasNoSignal) {
  const league::ScratchFile file(".log");
  write_sketch({.has_referee = false}, file.path());
  EXPECT_FALSE(logged_state(file.path(), 3).start.referee.signal);
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

class RenumberTest : public testing::Test {
 protected:
  RenumberTest() {
    start_.robots[Side::kWest] = {sim::RobotState{.number = 1},
                                  sim::RobotState{.number = 5, .position_m = {1, 0}}};
    Frame frame;
    frame.robots[Side::kWest] = {{1, {0, 0}, {1, 0}}, {3, {2, 0}, {1, 0}}, {5, {1, 0}, {1, 0}}};
    start_.seen_before = {frame};
    start_.ghost.emplace();
    start_.ghost->frames = {{0, start_.robots[Side::kWest], {}}};
  }

  std::vector<int> numbers() const { return numbers_of(start_.robots[Side::kWest]); }
  template <typename Robots>
  static std::vector<int> numbers_of(const Robots& robots) {
    std::vector<int> numbers;
    for (const auto& robot : robots) numbers.push_back(robot.number);
    return numbers;
  }

  game::StartState start_;
};

TEST_F(RenumberTest, KeepsNumbersThatTheTeamHas) {
  renumber(start_, Side::kWest, 6);
  EXPECT_EQ(numbers(), (std::vector{1, 5}));
}

TEST_F(RenumberTest, GivesSmallNumbersInTheSameOrder) {
  renumber(start_, Side::kWest, 4);
  EXPECT_EQ(numbers(), (std::vector{0, 1}));
  EXPECT_EQ(start_.robots[Side::kWest][1].position_m, Vec2(1, 0));
  EXPECT_THROW(renumber(start_, Side::kWest, 1), std::invalid_argument);
}

TEST_F(RenumberTest, GivesTheKeeperTheNumberOfKeepers) {
  start_.referee.signal.emplace();
  start_.referee.signal->keepers[Side::kWest] = 5;
  renumber(start_, Side::kWest, 6);
  EXPECT_EQ(numbers(), (std::vector{0, 1}));
  EXPECT_EQ(start_.robots[Side::kWest][0].position_m, Vec2(1, 0));
}

TEST_F(RenumberTest, ExchangesTheKeepersNumberWithThatOfAnotherRobot) {
  start_.robots[Side::kWest][0].number = 0;
  start_.referee.signal.emplace();
  start_.referee.signal->keepers[Side::kWest] = 5;
  renumber(start_, Side::kWest, 6);
  EXPECT_EQ(numbers(), (std::vector{0, 5}));
  EXPECT_EQ(start_.robots[Side::kWest][0].position_m, Vec2(1, 0));
}

TEST_F(RenumberTest, AlsoChangesWhatWasSeenBeforeAndTheGhost) {
  start_.referee.signal.emplace();
  start_.referee.signal->keepers[Side::kWest] = 5;
  renumber(start_, Side::kWest, 4);
  const SeenRobots& seen = start_.seen_before.front().robots[Side::kWest];
  EXPECT_EQ(numbers_of(seen), (std::vector{0, 1}));
  EXPECT_EQ(seen[0].position_m, Vec2(1, 0));
  EXPECT_EQ(numbers_of(start_.ghost->frames.front().robots), (std::vector{0, 1}));
}

}  // namespace
}  // namespace autoref::logs
