#include "live/controller/controller_differences.hpp"

#include <gtest/gtest.h>

namespace autoref::live {
namespace {

class ControllerDifferencesTest : public testing::Test {
 protected:
  ControllerDifferencesTest() { command(CommandKind::kForceStart, Side::kWest, 0); }

  void call_throw_in_for_blue(double time_s) {
    referee::Decision decision;
    decision.time_s = time_s;
    decision.from = referee::State::kRun;
    decision.to = referee::State::kCalled;
    decision.finding.event = referee::Event::kThrowIn;
    decision.finding.restart = {CommandKind::kDirectFree, Side::kEast};
    decision.finding.ball_to_m = {1, 2};
    differences_.on_decision(decision);
  }

  void command(CommandKind kind, Side side, double time_s, const Vec2& position_m = {1, 2}) {
    RefereeSignal signal;
    signal.stage = Stage::kFirstHalf;
    signal.command = {kind, side};
    signal.command_counter = ++counter_;
    if (kind == CommandKind::kStop) signal.placement = Placement{position_m};
    differences_.add({}, signal, time_s);
  }

  // A stop and a free kick.
  void free_kick(Side side, const Vec2& position_m = {1, 2}) {
    command(CommandKind::kStop, Side::kWest, 11, position_m);
    command(CommandKind::kDirectFree, side, 15);
  }

  ControllerDifferences differences_;
  std::uint32_t counter_ = 0;
};

TEST_F(ControllerDifferencesTest, AreNoneIfTheRestartIsTheSame) {
  call_throw_in_for_blue(10);
  free_kick(Side::kEast);
  EXPECT_EQ(differences_.restarts(), 1);
  EXPECT_TRUE(differences_.differences().empty());
}

TEST_F(ControllerDifferencesTest, ContainAnotherRestart) {
  call_throw_in_for_blue(10);
  free_kick(Side::kWest);
  ASSERT_EQ(differences_.differences().size(), 1U);
  EXPECT_EQ(differences_.differences()[0].time_s, 10);
  EXPECT_EQ(differences_.differences()[0].text,
            "DIRECT_FREE_YELLOW after throw_in; AutoRef: DIRECT_FREE_BLUE");
}

TEST_F(ControllerDifferencesTest, ContainAnotherPosition) {
  call_throw_in_for_blue(10);
  free_kick(Side::kEast, {1, 1.8});
  ASSERT_EQ(differences_.differences().size(), 1U);
  EXPECT_EQ(differences_.differences()[0].text,
            "DIRECT_FREE_BLUE after throw_in at (1.00, 1.80) m; AutoRef: at (1.00, 2.00) m");
}

TEST_F(ControllerDifferencesTest, ContainARestartWithoutACall) {
  free_kick(Side::kWest);
  ASSERT_EQ(differences_.differences().size(), 1U);
  EXPECT_EQ(differences_.differences()[0].text,
            "DIRECT_FREE_YELLOW after no event, which AutoRef did not call");
}

TEST(ControllerDifferences, AreNoneForARestartThatWasPendingAtFirst) {
  ControllerDifferences differences;
  RefereeSignal signal;
  signal.stage = Stage::kFirstHalf;
  for (const CommandKind kind :
       {CommandKind::kBallPlacement, CommandKind::kStop, CommandKind::kDirectFree}) {
    signal.command = {kind, Side::kWest};
    ++signal.command_counter;
    differences.add({}, signal, signal.command_counter);
  }
  EXPECT_EQ(differences.restarts(), 0);
}

}  // namespace
}  // namespace autoref::live
