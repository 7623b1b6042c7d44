// The last frames of play.
#include "referee/touch/frame_history.hpp"

#include <gtest/gtest.h>

namespace autoref::referee {
namespace {

constexpr double kFrame_s = 1.0 / 60;

Frame frame_with(int number, const std::optional<Vec2>& ball_m) {
  Frame frame;
  frame.number = number;
  frame.time_s = number * kFrame_s;
  if (ball_m) frame.ball = BallObservation{*ball_m, 0.0};
  return frame;
}

TEST(FrameHistory, KeepTheLast) {
  FrameHistory frame_history;
  for (int i = 0; i < 1000; ++i) frame_history.push(frame_with(i, Vec2(i, 0)));
  EXPECT_EQ(frame_history.newest(), 999);
  EXPECT_EQ(frame_history[999].ball_m, Vec2(999, 0));
  const std::int64_t oldest = frame_history.first_detection(0);
  EXPECT_EQ(oldest, 1000 - FrameHistory::kKept);
  EXPECT_EQ(frame_history[oldest].ball_m, Vec2(static_cast<double>(oldest), 0));
}

// Two seconds of the league's fastest cameras, 100 Hz.
TEST(FrameHistory, AreEnoughForTwoSeconds) { EXPECT_GE(FrameHistory::kKept, 200); }

TEST(FrameHistory, SkipAFrameThatIsNotLater) {
  FrameHistory frame_history;
  frame_history.push(frame_with(5, Vec2(1, 0)));
  frame_history.push(frame_with(5, Vec2(2, 0)));
  frame_history.push(frame_with(4, Vec2(3, 0)));
  EXPECT_EQ(frame_history.newest(), 0);
  EXPECT_EQ(frame_history[0].ball_m, Vec2(1, 0));
}

TEST(FrameHistory, KeepAHiddenBallWhereItWasSeen) {
  FrameHistory frame_history;
  frame_history.push(frame_with(0, Vec2(1, 2)));
  frame_history.push(frame_with(1, std::nullopt));
  EXPECT_FALSE(frame_history[1].has_ball);
  EXPECT_EQ(frame_history[1].ball_m, Vec2(1, 2));
}

TEST(FrameHistory, KeepRobotsWithinAMetreOfTheBall) {
  FrameHistory frame_history;
  Frame frame = frame_with(0, Vec2(1, 0));
  frame.robots[Side::kWest].push_back({3, Vec2(1.9, 0), Vec2(1, 0)});
  frame.robots[Side::kEast].push_back({4, Vec2(-0.1, 0), Vec2(1, 0)});
  frame_history.push(frame);
  ASSERT_EQ(frame_history[0].robots.size(), 1U);
  EXPECT_EQ(frame_history[0].robots[0].id, (RobotId{Side::kWest, 3}));
}

TEST(FrameHistory, MarkTheDetectionAtWhichTheBallJumps) {
  FrameHistory frame_history;
  frame_history.push(frame_with(0, Vec2(0, 0)));
  frame_history.lose_sight();
  frame_history.push(frame_with(1, std::nullopt));
  frame_history.push(frame_with(2, Vec2(1, 0)));
  frame_history.push(frame_with(3, Vec2(1, 0)));
  EXPECT_FALSE(frame_history[1].jumps);
  EXPECT_TRUE(frame_history[2].jumps);
  EXPECT_FALSE(frame_history[3].jumps);
}

TEST(FrameHistory, FindTheFirstDetectionSinceATime) {
  FrameHistory frame_history;
  for (int i = 0; i < 10; ++i) {
    const bool is_seen = i != 4;
    frame_history.push(frame_with(i, is_seen ? std::optional(Vec2(0, 0)) : std::nullopt));
  }
  EXPECT_EQ(frame_history.first_detection(3.5 * kFrame_s), 5);
  EXPECT_EQ(frame_history.first_detection(9.5 * kFrame_s), 10);
  EXPECT_EQ(FrameHistory().first_detection(0), 0);
}

}  // namespace
}  // namespace autoref::referee
