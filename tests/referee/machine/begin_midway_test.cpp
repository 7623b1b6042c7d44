// Games that begin in the middle of a half.
#include <gtest/gtest.h>

#include "referee/referee.hpp"

namespace autoref::referee {
namespace {

constexpr double kMidwayRate_hz = 60;

Frame frame_with_ball(int number, const Vec2& ball_m) {
  Frame frame;
  frame.number = number;
  frame.time_s = number / kMidwayRate_hz;
  frame.robots[Side::kWest] = {{0, {-2, 0}, {1, 0}}};
  frame.robots[Side::kEast] = {{0, {2, 0}, {-1, 0}}};
  frame.ball = BallObservation{ball_m, 0};
  return frame;
}

AutoRef begun_with(const MidwayStart& midway_start, const Vec2& ball_m) {
  AutoRef referee{Configuration{}};
  referee.begin(midway_start);
  referee.update(frame_with_ball(0, ball_m), {});
  return referee;
}

TEST(BegunMidway, IsInPlayWithAnUnknownTouch) {
  const AutoRef referee = begun_with({}, {0.5, 0.2});
  EXPECT_EQ(referee.state(), State::kRun);
  EXPECT_TRUE(referee.is_ball_in_play());
  ASSERT_EQ(referee.decisions().size(), 1U);
  EXPECT_EQ(referee.decisions()[0].transition, "begin_in_play");
  EXPECT_FALSE(referee.decisions()[0].last_touch.side);
}

TEST(BegunMidway, SignalsARestartAtOnceAndWaitsForTheBallToMove) {
  AutoRef referee =
      begun_with({Command{CommandKind::kDirectFree, Side::kEast}, {0.5, 0.2}}, {0.5, 0.2});
  EXPECT_EQ(referee.state(), State::kRun);
  EXPECT_FALSE(referee.is_ball_in_play());
  const RefereeSignal signal = referee.update(frame_with_ball(1, {0.5, 0.2}), {});
  EXPECT_EQ(signal.command, (Command{CommandKind::kDirectFree, Side::kEast}));
  EXPECT_EQ(signal.stage, Stage::kFirstHalf);
  for (int number = 2; number < 20; ++number)
    referee.update(frame_with_ball(number, {0.5 - 0.02 * number, 0.2}), {});
  EXPECT_TRUE(referee.is_ball_in_play());
}

TEST(BegunMidway, PlacesTheBallInAStopBeforeItsRestart) {
  AutoRef referee =
      begun_with({Command{CommandKind::kDirectFree, Side::kEast}, {0.5, 0.2}, true}, {0, 0});
  EXPECT_EQ(referee.state(), State::kWaitStop);
  const RefereeSignal signal = referee.update(frame_with_ball(1, {0, 0}), {});
  EXPECT_EQ(signal.command.kind, CommandKind::kStop);
  EXPECT_EQ(signal.next_command, (Command{CommandKind::kDirectFree, Side::kEast}));
  ASSERT_TRUE(signal.placement);
  EXPECT_EQ(signal.placement->target_m, Vec2(0.5, 0.2));
}

TEST(BegunMidway, PreparesAKickoffAtOnceUnlessItIsStopped) {
  const Command kickoff{CommandKind::kPrepareKickoff, Side::kWest};
  AutoRef at_once = begun_with({kickoff, {0, 0}}, {0, 0});
  EXPECT_EQ(at_once.update(frame_with_ball(1, {0, 0}), {}).command, kickoff);
  AutoRef stopped = begun_with({kickoff, {0, 0}, true}, {0, 0});
  EXPECT_EQ(stopped.update(frame_with_ball(1, {0, 0}), {}).command.kind, CommandKind::kStop);
}

}  // namespace
}  // namespace autoref::referee
