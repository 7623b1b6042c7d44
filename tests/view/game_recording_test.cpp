#include "view/game_recording.hpp"

#include <gtest/gtest.h>

namespace autoref::view {
namespace {

using namespace std::string_literals;

Frame frame_at(double time_s) {
  Frame frame;
  frame.time_s = time_s;
  return frame;
}

RefereeSignal stopped() {
  RefereeSignal signal;
  signal.command = {CommandKind::kStop};
  return signal;
}

TEST(GameRecording, WritesTimesRobotsAndBallAsDocumented) {
  GameRecording recording;
  Frame frame = frame_at(0.5);
  frame.robots[Side::kEast].push_back({3, {0.001, -0.002}, {0, 1}});
  frame.ball = BallObservation{{0.256, 0}, 0.1, {}};
  recording.add(frame);
  EXPECT_EQ(recording.bytes(),
            "\x88\x13\0\0"s                            // 5000 ticks of 0.1 ms
            "\x80\x01\x00\x80\xfe\xff\x80\x84\x03"s    // 1 mm, -2 mm, 90 degrees
            "\x80\x00\x01\x80\x00\x00\x80\x64\x00"s);  // 256 mm, 0 mm, 100 mm high
}

TEST(GameRecording, HandlesRobotsThatArriveLateOrLeave) {
  GameRecording recording;
  recording.add(frame_at(0));
  Frame frame = frame_at(0.1);
  frame.robots[Side::kWest].push_back({7, {0, 0}, {1, 0}});
  recording.add(frame);
  recording.add(frame_at(0.2));
  ASSERT_EQ(recording.robots().size(), 1U);
  EXPECT_EQ(recording.robots().front(), (RobotId{Side::kWest, 7}));
  // Times; then nothing, 0, nothing in each column; the ball is never seen.
  EXPECT_EQ(recording.bytes().size(), 3U * 4 + 3 * (1 + 3 + 3) + 3 * 3);
}

TEST(GameRecording, StoresAnUnknownHeightAsNothing) {
  GameRecording recording;
  Frame frame = frame_at(0);
  frame.ball = BallObservation{{0, 0}, std::nullopt, {}};
  recording.add(frame);
  EXPECT_EQ(recording.bytes().substr(4), "\x80\0\0\x80\0\0\0"s);
}

TEST(GameRecording, KeepsASignalOnlyIfItChanges) {
  GameRecording recording;
  RefereeSignal signal = stopped();
  for (int i = 0; i < 10; ++i) recording.add(0.1 * i, signal);
  signal.goals[Side::kEast] = 1;
  recording.add(1, signal);
  ASSERT_EQ(recording.signals().size(), 2U);
  EXPECT_EQ(recording.signals()[1].time_s, 1);
}

TEST(GameRecording, KeepsTheClocksWholeSeconds) {
  GameRecording recording;
  RefereeSignal signal = stopped();
  for (int i = 0; i <= 20; ++i) {
    signal.stage_time_left_s = 600 - 0.1 * i;
    recording.add(0.1 * i, signal);
  }
  ASSERT_EQ(recording.clock().size(), 3U);
  EXPECT_EQ(recording.clock()[1].left_s, 599);
  EXPECT_NEAR(recording.clock()[1].time_s, 1.0, 1e-9);
}

TEST(GameRecording, TakenInPartsRepeatsNoSignal) {
  GameRecording recording;
  recording.add(Frame{});
  recording.add(0, stopped());
  const GameRecording first = recording.take_recording();
  EXPECT_EQ(first.frames(), 1U);
  EXPECT_EQ(first.signals().size(), 1U);
  recording.add(1, stopped());
  recording.add(1, RefereeSignal{});
  const GameRecording second = recording.take_recording();
  EXPECT_EQ(second.frames(), 0U);
  EXPECT_EQ(second.signals().size(), 1U);
}

TEST(GameRecording, LeavesOutDecisionsBeyondItsLimit) {
  GameRecording recording;
  RecordedDecision decision;
  decision.event = "goal";
  for (std::size_t i = 0; i < GameRecording::kMostDecisions; ++i) recording.add(decision);
  EXPECT_FALSE(recording.is_full());
  recording.add(decision);
  EXPECT_TRUE(recording.is_full());
  EXPECT_EQ(recording.decisions().size(), GameRecording::kMostDecisions);
}

TEST(GameRecording, LeavesOutChainsAndShotsBeyondItsLimits) {
  GameRecording chains;
  for (std::size_t i = 0; i < GameRecording::kMostChains; ++i) chains.add(RecordedChain{});
  EXPECT_FALSE(chains.is_full());
  chains.add(RecordedChain{});
  EXPECT_TRUE(chains.is_full());
  EXPECT_EQ(chains.chains().size(), GameRecording::kMostChains);
  GameRecording shots;
  for (std::size_t i = 0; i <= GameRecording::kMostShots; ++i) shots.add(RecordedShot{});
  EXPECT_TRUE(shots.is_full());
  EXPECT_EQ(shots.shots().size(), GameRecording::kMostShots);
}

TEST(GameRecording, TakesChainsAndShotsWithTheRecording) {
  GameRecording recording;
  recording.add(RecordedChain{});
  recording.add(RecordedShot{});
  const GameRecording taken = recording.take_recording();
  EXPECT_EQ(taken.chains().size(), 1U);
  EXPECT_EQ(taken.shots().size(), 1U);
  EXPECT_TRUE(recording.chains().empty());
  EXPECT_TRUE(recording.shots().empty());
}

TEST(GameRecording, MakesTimesMonotonic) {
  GameRecording recording;
  recording.add(5, stopped());
  recording.add(-1e300, RefereeSignal{});
  EXPECT_EQ(recording.signals().back().time_s, 5);
}

}  // namespace
}  // namespace autoref::view
