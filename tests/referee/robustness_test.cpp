// How the referee handles frames with missing or invalid content.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <vector>

#include "tests/referee/support/scripted_game.hpp"

namespace autoref::referee {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(Robustness, AGameWithoutRobotsAndBallEnds) {
  Configuration configuration;
  configuration.half_s = 30;
  ScriptedGame game(configuration);
  game.frame.ball.reset();
  game.run_until("game_over", 200);
  EXPECT_TRUE(game.referee.is_over());
  EXPECT_EQ(game.signal.goals, (PerSide<int>{}));
}

TEST(Robustness, AFrameWithoutABallKeepsTheLastBall) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.put_ball({1, 0});
  game.step();
  game.frame.ball.reset();
  game.run(3);
  EXPECT_EQ(game.referee.state(), State::kRun);
  EXPECT_TRUE(game.referee.is_ball_in_play());
}

TEST(Robustness, AFrameWithARepeatedTimestampIsHarmless) {
  AutoRef referee{Configuration{}};
  Frame frame;
  referee.update(frame, {});
  frame.ball = BallObservation{Vec2(0, 0), std::nullopt};
  referee.update(frame, {});
  EXPECT_FALSE(referee.tracks().ball);
  frame.number = 1;
  frame.time_s = 1.0 / 60;
  referee.update(frame, {});
  ASSERT_TRUE(referee.tracks().ball);
  EXPECT_EQ(referee.tracks().ball->position_m, Vec2(0, 0));
}

TEST(Robustness, TracksAreMadeFromWhatTheRefereeSees) {
  Referee referee{Configuration{}};
  Frame frame;
  frame.ball = BallObservation{Vec2(kNan, 0), std::nullopt};
  EXPECT_FALSE(referee.see(frame).frame.ball);
  referee.judge({}, {});
  frame.ball->position_m = {1, 0};
  frame.time_s = 0.9;
  ASSERT_TRUE(referee.see(frame).frame.ball);
  EXPECT_FALSE(referee.see(frame).tracks_begin_afresh);
}

TEST(Robustness, TracksBeginAfreshAfterAGap) {
  Referee referee{Configuration{}};
  AutoRef autoref{Configuration{}};
  Frame frame;
  frame.ball = BallObservation{Vec2(0, 0), std::nullopt};
  const auto show = [&](double time_s) {
    frame.time_s = time_s;
    autoref.update(frame, {});
    const bool is_afresh = referee.see(frame).tracks_begin_afresh;
    referee.judge(autoref.tracks(), {});
    return is_afresh;
  };
  EXPECT_FALSE(show(0));
  EXPECT_FALSE(show(1));
  frame.ball.reset();
  EXPECT_FALSE(show(1.5));
  EXPECT_TRUE(autoref.tracks().ball);
  EXPECT_TRUE(show(2.6));
  EXPECT_FALSE(autoref.tracks().ball);
  EXPECT_FALSE(show(2.7));
}

TEST(Robustness, ABallThatComesBackOutsideIsOut) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.put_ball({1, 2.0});
  game.step();
  game.frame.ball.reset();
  game.run(0.5);
  game.frame.ball = BallObservation{Vec2(1.1, 2.2), 0.0};
  game.step();
  EXPECT_EQ(game.decisions.back().transition, "touch_line_unknown");
}

TEST(Robustness, NonFiniteNumbersCountAsUnseen) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.put_ball({kNan, kNan});
  game.robot(Side::kWest, 1).position_m = {kNan, 0};
  game.run(3);
  EXPECT_EQ(game.referee.state(), State::kRun);
  game.put_ball({1, 2.2});
  game.step();
  EXPECT_EQ(game.referee.state(), State::kWaitStop);
}

TEST(Robustness, ARobotWithoutAPositionDoesNotHideItsTeamMates) {
  for (const Side side : kSides) {
    ScriptedGame game;
    game.line_up().kick_off();
    game.frame.robots[side].front().position_m = {kNan, 0};
    game.put_ball({1, 2.2});
    game.run_until("touch_line_unknown");
    Vec2& moving_m = game.frame.robots[side].back().position_m;
    for (int i = 0; i < 180; ++i) {
      moving_m.x() += 0.001;
      game.step();
    }
    EXPECT_EQ(game.referee.state(), State::kWaitStop) << name_of(side);
  }
}

TEST(Robustness, AGoalOfABallOfUnknownHeightCounts) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.put_ball({3.0, 0});
  game.step();
  game.frame.ball = BallObservation{Vec2(3.1, 0), kNan};
  game.step();
  EXPECT_EQ(game.decisions.back().finding.event, Event::kGoal);
}

TEST(Robustness, ARobotThatDisappearsDoesNotDelayPlay) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.put_ball({1, 2.2});
  const double stopped_s = game.run_until("touch_line_unknown").time_s;
  game.frame.robots[Side::kEast].pop_back();
  EXPECT_NEAR(game.run_until("start").time_s, stopped_s + 1, 1e-9);
}

TEST(Robustness, AGoalInTheLastFrameOfAHalfCounts) {
  Configuration configuration;
  configuration.half_s = 4;
  ScriptedGame game(configuration);
  game.line_up().kick_off();
  const double over_s = game.now_s() + 4;
  game.put_ball({2.5, 0});
  while (game.now_s() < over_s - 1.5 / 60) game.step();
  game.put_ball({3.1, 0});
  game.step();
  EXPECT_EQ(game.signal.goals[Side::kWest], 1);
  EXPECT_EQ(game.signal.command.kind, CommandKind::kHalt);
  EXPECT_EQ(game.signal.stage, Stage::kHalfTime);
}

TEST(Robustness, EveryCommandIsCountedAndTimed) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.kick_from(Side::kWest, 1, {2.5, 0}, {6, 0});
  game.run_until("start");
  const auto has_command = [](const Decision& one) { return one.command.has_value(); };
  EXPECT_EQ(game.signal.command_counter,
            std::count_if(game.decisions.begin(), game.decisions.end(), has_command));
  EXPECT_EQ(game.signal.command_time_s, game.now_s());
}

TEST(Robustness, OneEventIsCalledOnce) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.kick_from(Side::kWest, 1, {1, 1.8}, {0, 4});
  game.placement_works = false;
  game.run(3);
  EXPECT_EQ(game.count("throw_in"), 1);
}

TEST(Robustness, ABallStillOutsideWhenPlayResumesIsOutAgain) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.kick_from(Side::kWest, 1, {1, 1.8}, {0, 4});
  game.placement_works = false;
  game.run_until("start_late");
  game.step();
  EXPECT_EQ(game.referee.state(), State::kWaitStop);
}

Configuration with_half_s(double half_s) {
  Configuration configuration;
  configuration.half_s = half_s;
  return configuration;
}

Configuration with_halves(int halves) {
  Configuration configuration;
  configuration.halves = halves;
  return configuration;
}

TEST(Configured, RefusesAnImpossibleLengthOfHalvesAndBreaks) {
  EXPECT_THROW(AutoRef{with_half_s(0)}, std::invalid_argument);
  EXPECT_THROW(AutoRef{with_half_s(-1)}, std::invalid_argument);
  EXPECT_THROW(AutoRef{with_half_s(kNan)}, std::invalid_argument);
  Configuration configuration;
  configuration.break_s = -1;
  EXPECT_THROW(AutoRef{configuration}, std::invalid_argument);
}

TEST(Configured, RefusesAnImpossibleNumberOfHalves) {
  EXPECT_THROW(AutoRef{with_halves(0)}, std::invalid_argument);
  EXPECT_THROW(AutoRef{with_halves(-1)}, std::invalid_argument);
  EXPECT_THROW(AutoRef{with_halves(3)}, std::invalid_argument);
}

// The sides of the prepared kick-offs, in order.
std::vector<Side> kickers_of(const std::vector<Decision>& decisions) {
  std::vector<Side> kickers;
  for (const Decision& decision : decisions) {
    if (decision.command && decision.command->kind == CommandKind::kPrepareKickoff) {
      kickers.push_back(decision.command->side);
    }
  }
  return kickers;
}

TEST(Configured, HalvesAlternateTheKickOff) {
  Configuration configuration;
  configuration.half_s = 2;
  configuration.knockout = true;
  configuration.rules.extra_half_s = 2;
  configuration.first_kickoff = Side::kEast;
  ScriptedGame game(configuration);
  game.line_up().run_until("shootout", 100);
  EXPECT_EQ(kickers_of(game.decisions),
            (std::vector<Side>{Side::kEast, Side::kWest, Side::kEast, Side::kWest}));
}

TEST(Configured, RuleBookNumbersAreThoseOfThePaperAndTheLaws) {
  const RuleBook rules;
  EXPECT_EQ(rules.stillness_m, 0.015);
  EXPECT_EQ(rules.attacker_to_area_m, 0.2);
  EXPECT_EQ(rules.in_play_m, 0.05);
  EXPECT_EQ(rules.stuck_distance_m, 0.25);
  EXPECT_EQ(rules.stuck_time_s, 10);
  EXPECT_EQ(rules.restart_timeout_s, 10);
  EXPECT_EQ(rules.ready_timeout_s, 15);
}

TEST(BallInPlay, IsOnlyAfter50Millimetres) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.put_ball({0.049, 0});
  game.step();
  EXPECT_FALSE(game.referee.is_ball_in_play());
  game.put_ball({0.051, 0});
  game.step();
  EXPECT_TRUE(game.referee.is_ball_in_play());
}

TEST(StuckBall, IsNotCalledIfTheBallMoves250MillimetresInTenSeconds) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.put_ball({0.3, 0.3});
  game.ball_mps = {0.026, 0};
  game.run(25);
  EXPECT_EQ(game.count("stuck_ball"), 0);
  game.ball_mps = {0.024, 0};
  game.run(25);
  EXPECT_EQ(game.count("stuck_ball"), 1);
}

}  // namespace
}  // namespace autoref::referee
