// The history of recent frames of play.
#include "referee/touch/frame_history.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/referee/touch/touch_frames.hpp"

namespace autoref::referee {
namespace {

Frame frame_with(int number, const std::optional<Vec2>& ball_m) {
  Frame frame;
  frame.number = number;
  frame.time_s = number * kFrame_s;
  if (ball_m) frame.ball = BallObservation{*ball_m, 0.0};
  return frame;
}

// Frames `first` to `last`, with the ball at x = number / 60, thus at 1 m/s.
void push_rolling(FrameHistory& frames, int first, int last) {
  for (int i = first; i <= last; ++i) frames.push(frame_with(i, Vec2(i * kFrame_s, 0)));
}

void push_hidden(FrameHistory& frames, int first, int last) {
  for (int i = first; i <= last; ++i) frames.push(frame_with(i, std::nullopt));
}

TEST(FrameHistory, KeepsTheLastFramesAndDropsTheOldest) {
  FrameHistory frames;
  push_rolling(frames, 1, 1000);
  EXPECT_EQ(frames.newest(), 1000);
  EXPECT_EQ(frames.detections(), 1000);
  EXPECT_EQ(frames[1000].ball.position_m, Vec2(1000 * kFrame_s, 0));
  const std::int64_t oldest = frames.first_detection(0);
  EXPECT_EQ(oldest, 1001 - FrameHistory::kKept);
  EXPECT_EQ(frames[oldest].ball.position_m, Vec2(static_cast<double>(oldest) * kFrame_s, 0));
}

// Two seconds at 100 Hz, the rate of the league's fastest cameras.
TEST(FrameHistory, CoversTwoSecondsOfAFastCamera) { EXPECT_GE(FrameHistory::kKept, 200); }

TEST(FrameHistory, AllocatesNoMemory) {
  EXPECT_GE(sizeof(FrameHistory), FrameHistory::kKept * sizeof(StoredFrame));
}

TEST(FrameHistory, SkipsAFrameThatIsNotLater) {
  FrameHistory frames;
  frames.push(frame_with(5, Vec2(1, 0)));
  frames.push(frame_with(5, Vec2(2, 0)));
  frames.push(frame_with(4, Vec2(3, 0)));
  EXPECT_EQ(frames.newest(), 1);
  EXPECT_EQ(frames[1].ball.position_m, Vec2(1, 0));
}

TEST(FrameHistory, TreatsANonFiniteBallAsUnseen) {
  FrameHistory frames;
  frames.push(frame_with(1, Vec2(1, std::nan(""))));
  EXPECT_FALSE(frames[1].has_ball);
  EXPECT_EQ(frames.detections(), 0);
}

TEST(FrameHistory, KeepsTheLastDetectionOfAHiddenBall) {
  FrameHistory frames;
  frames.push(frame_with(1, Vec2(1, 2)));
  push_hidden(frames, 2, 700);
  EXPECT_FALSE(frames[700].has_ball);
  EXPECT_EQ(frames[700].ball.position_m, Vec2(1, 2));
  EXPECT_EQ(frames[700].ball.time_s, kFrame_s);
}

TEST(FrameHistory, MeasuresTheVelocityBetweenDetections) {
  FrameHistory frames;
  push_rolling(frames, 1, 2);
  push_hidden(frames, 3, 4);
  push_rolling(frames, 5, 5);
  EXPECT_EQ(frames.detection(0).ball.time_s, 5 * kFrame_s);
  EXPECT_NEAR(frames.detection(0).ball.duration_s, 3 * kFrame_s, 1e-12);
  EXPECT_NEAR(frames.detection(0).ball.velocity_mps.x(), 1, 1e-12);
  EXPECT_EQ(frames.detection(1).ball.time_s, 2 * kFrame_s);
  EXPECT_EQ(frames.detection(2).ball.duration_s, 0);
}

TEST(FrameHistory, StartsWithTheBallAtRest) {
  FrameHistory frames;
  push_rolling(frames, 1, 20);
  frames.restart(frame_with(20, Vec2(5, 5)), Vec2(1, 0));
  EXPECT_EQ(frames.newest(), 0);
  EXPECT_EQ(frames.detections(), 1);
  EXPECT_EQ(frames[0].ball.position_m, Vec2(1, 0));
  frames.push(frame_with(21, Vec2(1, 0)));
  EXPECT_NEAR(frames[1].ball.duration_s, kFrame_s, 1e-12);
}

TEST(FrameHistory, StartsWithoutABallIfItWasNeverSeen) {
  FrameHistory frames;
  frames.restart(frame_with(20, std::nullopt), std::nullopt);
  EXPECT_EQ(frames.detections(), 0);
  push_rolling(frames, 21, 21);
  EXPECT_EQ(frames[1].ball.duration_s, 0);
}

TEST(FrameHistory, KnowsWhichRobotsAreWithinAMetreOfTheBall) {
  StoredFrame frame;
  frame.ball.position_m = Vec2(1, 0);
  EXPECT_TRUE(is_near_ball(frame, {3, Vec2(1.99, 0), Vec2(1, 0)}));
  EXPECT_FALSE(is_near_ball(frame, {3, Vec2(-0.01, 0), Vec2(1, 0)}));
}

TEST(FrameHistory, MarksTheDetectionAtWhichTheBallJumps) {
  FrameHistory frames;
  push_rolling(frames, 1, 1);
  frames.lose_sight();
  push_hidden(frames, 2, 2);
  push_rolling(frames, 3, 4);
  EXPECT_TRUE(frames[3].ball.jumps);
  EXPECT_EQ(frames[3].ball.duration_s, 0);
  EXPECT_FALSE(frames[4].ball.jumps);
  EXPECT_GT(frames[4].ball.duration_s, 0);
}

TEST(FrameHistory, FindsTheFirstDetectionSinceATime) {
  FrameHistory frames;
  push_rolling(frames, 1, 3);
  push_hidden(frames, 4, 4);
  push_rolling(frames, 5, 9);
  EXPECT_EQ(frames.first_detection(3.5 * kFrame_s), 5);
  EXPECT_EQ(frames.first_detection(9.5 * kFrame_s), 10);
  EXPECT_EQ(FrameHistory().first_detection(0), 1);
}

TEST(FrameHistory, LooksBackAtTheLastTenDetectionsOfThisPlay) {
  FrameHistory frames;
  frames.restart(frame_with(0, std::nullopt), Vec2(0, 0));
  EXPECT_EQ(frames.ball(0), nullptr);  // the ball at rest is not one of them
  push_rolling(frames, 1, 3);
  ASSERT_NE(frames.ball(2), nullptr);
  EXPECT_EQ(frames.ball(3), nullptr);
  push_rolling(frames, 4, 40);
  ASSERT_NE(frames.ball(9), nullptr);
  EXPECT_EQ(frames.ball(9)->time_s, 31 * kFrame_s);
  EXPECT_EQ(frames.ball(10), nullptr);
}

TEST(FrameHistory, FindsTheDetectionBeforeATime) {
  FrameHistory frames;
  EXPECT_EQ(frames.ball_before(0), nullptr);
  push_rolling(frames, 1, 20);
  EXPECT_EQ(frames.ball_before(15.5 * kFrame_s)->time_s, 15 * kFrame_s);
  EXPECT_EQ(frames.ball_before(1.0 * kFrame_s)->time_s, 11 * kFrame_s);  // the oldest of ten
}

TEST(FrameHistory, InterpolatesRobotsBetweenTheLastTenFrames) {
  FrameHistory frames;
  EXPECT_TRUE(frames.robots_at(0)[Side::kWest].empty());
  for (int i = 0; i <= 20; ++i) {
    Frame frame = frame_with(i, std::nullopt);
    frame.robots[Side::kWest].push_back({3, Vec2(i, 0), Vec2(1, 0)});
    i == 0 ? frames.restart(frame, std::nullopt) : frames.push(frame);
  }
  const auto x_at = [&frames](double number) {
    return frames.robots_at(number * kFrame_s)[Side::kWest].at(0).position_m.x();
  };
  EXPECT_NEAR(x_at(15.25), 15.25, 1e-9);
  EXPECT_EQ(x_at(5), 11);
  EXPECT_EQ(x_at(25), 20);
}

}  // namespace
}  // namespace autoref::referee
