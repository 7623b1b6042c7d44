#include "runner/view/game_tape.hpp"

#include <gtest/gtest.h>

namespace autoref::runner {
namespace {

using namespace std::string_literals;

Frame picture_at(double time_s) {
  Frame picture;
  picture.time_s = time_s;
  return picture;
}

RefereeSignal stopped() {
  RefereeSignal signal;
  signal.command = {CommandKind::kStop};
  return signal;
}

TEST(GameTape, WritesTimesRobotsAndBallAsDocumented) {
  GameTape tape;
  Frame picture = picture_at(0.5);
  picture.robots[Side::kEast].push_back({3, {0.001, -0.002}, {0, 1}});
  picture.ball = BallObservation{{0.256, 0}, 0.1, {}};
  tape.add(picture);
  EXPECT_EQ(tape.bytes(),
            "\x88\x13\0\0"s                            // 5000 ticks of 0.1 ms
            "\x80\x01\x00\x80\xfe\xff\x80\x84\x03"s    // 1 mm, -2 mm, 90 degrees
            "\x80\x00\x01\x80\x00\x00\x80\x64\x00"s);  // 256 mm, 0 mm, 100 mm high
}

TEST(GameTape, KnowsRobotsThatComeLateOrLeave) {
  GameTape tape;
  tape.add(picture_at(0));
  Frame picture = picture_at(0.1);
  picture.robots[Side::kWest].push_back({7, {0, 0}, {1, 0}});
  tape.add(picture);
  tape.add(picture_at(0.2));
  ASSERT_EQ(tape.robots().size(), 1U);
  EXPECT_EQ(tape.robots().front(), (RobotId{Side::kWest, 7}));
  // Times; then of each column nothing, 0, nothing; the ball is never seen.
  EXPECT_EQ(tape.bytes().size(), 3U * 4 + 3 * (1 + 3 + 3) + 3 * 3);
}

TEST(GameTape, WritesAnUnknownHeightAsNothing) {
  GameTape tape;
  Frame picture = picture_at(0);
  picture.ball = BallObservation{{0, 0}, std::nullopt, {}};
  tape.add(picture);
  EXPECT_EQ(tape.bytes().substr(4), "\x80\0\0\x80\0\0\0"s);
}

TEST(GameTape, KeepsASignalOnlyWhereItChanges) {
  GameTape tape;
  RefereeSignal signal = stopped();
  for (int i = 0; i < 10; ++i) tape.add(0.1 * i, signal);
  signal.goals[Side::kEast] = 1;
  tape.add(1, signal);
  ASSERT_EQ(tape.signals().size(), 2U);
  EXPECT_EQ(tape.signals()[1].time_s, 1);
}

TEST(GameTape, KeepsTheClocksWholeSeconds) {
  GameTape tape;
  RefereeSignal signal = stopped();
  for (int i = 0; i <= 20; ++i) {
    signal.stage_time_left_s = 600 - 0.1 * i;
    tape.add(0.1 * i, signal);
  }
  ASSERT_EQ(tape.clock().size(), 3U);
  EXPECT_EQ(tape.clock()[1].left_s, 599);
  EXPECT_NEAR(tape.clock()[1].time_s, 1.0, 1e-9);
}

TEST(GameTape, RaisesTimesThatFall) {
  GameTape tape;
  tape.add(5, stopped());
  tape.add(-1e300, RefereeSignal{});
  EXPECT_EQ(tape.signals().back().time_s, 5);
}

}  // namespace
}  // namespace autoref::runner
