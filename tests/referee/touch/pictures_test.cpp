// The last pictures of play.
#include "referee/touch/pictures.hpp"

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

TEST(Pictures, KeepTheLast) {
  Pictures pictures;
  for (int i = 0; i < 1000; ++i) pictures.push(frame_with(i, Vec2(i, 0)));
  EXPECT_EQ(pictures.newest(), 999);
  EXPECT_EQ(pictures[999].ball_m, Vec2(999, 0));
  const std::int64_t oldest = pictures.first_sighting(0);
  EXPECT_EQ(oldest, 1000 - Pictures::kKept);
  EXPECT_EQ(pictures[oldest].ball_m, Vec2(static_cast<double>(oldest), 0));
}

// Two seconds of the league's fastest cameras, 100 Hz.
TEST(Pictures, AreEnoughForTwoSeconds) { EXPECT_GE(Pictures::kKept, 200); }

TEST(Pictures, SkipAFrameThatIsNotLater) {
  Pictures pictures;
  pictures.push(frame_with(5, Vec2(1, 0)));
  pictures.push(frame_with(5, Vec2(2, 0)));
  pictures.push(frame_with(4, Vec2(3, 0)));
  EXPECT_EQ(pictures.newest(), 0);
  EXPECT_EQ(pictures[0].ball_m, Vec2(1, 0));
}

TEST(Pictures, KeepAHiddenBallWhereItWasSeen) {
  Pictures pictures;
  pictures.push(frame_with(0, Vec2(1, 2)));
  pictures.push(frame_with(1, std::nullopt));
  EXPECT_FALSE(pictures[1].has_ball);
  EXPECT_EQ(pictures[1].ball_m, Vec2(1, 2));
}

TEST(Pictures, KeepRobotsWithinAMetreOfTheBall) {
  Pictures pictures;
  Frame frame = frame_with(0, Vec2(1, 0));
  frame.robots[Side::kWest].push_back({3, Vec2(1.9, 0), Vec2(1, 0)});
  frame.robots[Side::kEast].push_back({4, Vec2(-0.1, 0), Vec2(1, 0)});
  pictures.push(frame);
  ASSERT_EQ(pictures[0].robots.size(), 1U);
  EXPECT_EQ(pictures[0].robots[0].id, (RobotId{Side::kWest, 3}));
}

TEST(Pictures, MarkTheSightingAtWhichTheBallJumps) {
  Pictures pictures;
  pictures.push(frame_with(0, Vec2(0, 0)));
  pictures.lose_sight();
  pictures.push(frame_with(1, std::nullopt));
  pictures.push(frame_with(2, Vec2(1, 0)));
  pictures.push(frame_with(3, Vec2(1, 0)));
  EXPECT_FALSE(pictures[1].jumps);
  EXPECT_TRUE(pictures[2].jumps);
  EXPECT_FALSE(pictures[3].jumps);
}

TEST(Pictures, FindTheFirstSightingSinceATime) {
  Pictures pictures;
  for (int i = 0; i < 10; ++i) {
    const bool is_seen = i != 4;
    pictures.push(frame_with(i, is_seen ? std::optional(Vec2(0, 0)) : std::nullopt));
  }
  EXPECT_EQ(pictures.first_sighting(3.5 * kFrame_s), 5);
  EXPECT_EQ(pictures.first_sighting(9.5 * kFrame_s), 10);
  EXPECT_EQ(Pictures().first_sighting(0), 0);
}

}  // namespace
}  // namespace autoref::referee
