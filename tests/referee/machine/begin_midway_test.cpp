// Games that begin in the middle of a half.
#include <gtest/gtest.h>

#include <utility>

#include "referee/referee.hpp"
#include "soccer/rules/rule_book.hpp"

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

// The second half of a game of the 2026 rules, with a card, a foul and a timeout.
RefereeSignal signal_before() {
  RefereeSignal signal;
  signal.stage = Stage::kSecondHalf;
  signal.stage_time_left_s = 100;
  signal.goals = {{3, 1}};
  signal.yellow_cards = {{0, 2}};
  signal.yellow_left_s[Side::kEast] = {30};
  signal.fouls = {{0, 4}};
  signal.timeouts_left = {{4, 3}};
  signal.timeout_left_s = {{300, 250}};
  signal.blue_on_positive_half = false;
  return signal;
}

AutoRef continued(const MidwayStart& midway_start, int halves = 2) {
  Configuration configuration;
  configuration.rules = *find_rule_book("2026-b");
  configuration.half_s = 300;
  configuration.halves = halves;
  configuration.robots = {{6, 6}};
  AutoRef referee{configuration};
  referee.begin(midway_start);
  referee.update(frame_with_ball(0, {0.5, 0.2}), {});
  return referee;
}

TEST(BegunMidway, KeepsWhatTheSignalBeforeSays) {
  MidwayStart midway_start;
  midway_start.signal = signal_before();
  midway_start.goals_in_earlier_halves = {{2, 0}};
  AutoRef referee = continued(midway_start);
  const RefereeSignal signal = referee.update(frame_with_ball(1, {0.5, 0.2}), {});
  EXPECT_EQ(signal.stage, Stage::kSecondHalf);
  EXPECT_NEAR(signal.stage_time_left_s, 100 - 1 / kMidwayRate_hz, 1e-9);
  EXPECT_EQ(signal.goals, (PerSide<int>{{3, 1}}));
  EXPECT_EQ(signal.yellow_cards, (PerSide<int>{{0, 2}}));
  ASSERT_EQ(signal.yellow_left_s[Side::kEast].size(), 1U);
  EXPECT_NEAR(signal.yellow_left_s[Side::kEast][0], 30 - 1 / kMidwayRate_hz, 1e-9);
  EXPECT_EQ(signal.fouls, (PerSide<int>{{0, 4}}));
  EXPECT_EQ(signal.robots_allowed, (PerSide<int>{{6, 5}}));
  EXPECT_EQ(signal.timeouts_left, (PerSide<int>{{4, 3}}));
  EXPECT_EQ(signal.timeout_left_s, (PerSide<double>{{300, 250}}));
  EXPECT_FALSE(signal.blue_on_positive_half);
  const auto goals = referee.goals_by_half();
  ASSERT_EQ(goals.size(), 2U);
  EXPECT_EQ(goals[0], (PerSide<int>{{2, 0}}));
  EXPECT_EQ(goals[1], (PerSide<int>{{1, 1}}));
}

TEST(BegunMidway, EndsItsHalfWhenTheTimeLeftIsOver) {
  MidwayStart midway_start;
  midway_start.signal = signal_before();
  midway_start.signal->stage_time_left_s = 0.5;
  AutoRef referee = continued(midway_start);
  int number = 1;
  for (; !referee.is_over() && number < 100; ++number)
    referee.update(frame_with_ball(number, {0.5, 0.2}), {});
  EXPECT_NEAR((number - 1) / kMidwayRate_hz, 0.5, 0.02);
}

TEST(BegunMidway, LimitsTheTimeLeftToTheLengthOfAHalf) {
  MidwayStart midway_start;
  midway_start.signal = signal_before();
  midway_start.signal->stage_time_left_s = 9999;
  AutoRef referee = continued(midway_start);
  const RefereeSignal signal = referee.update(frame_with_ball(1, {0.5, 0.2}), {});
  EXPECT_NEAR(signal.stage_time_left_s, 300 - 1 / kMidwayRate_hz, 1e-9);
}

TEST(BegunMidway, EndsItsHalfAtOnceIfItsTimeIsOver) {
  MidwayStart midway_start;
  midway_start.signal = signal_before();
  midway_start.signal->stage_time_left_s = -5;
  EXPECT_TRUE(continued(midway_start).is_over());
}

TEST(BegunMidway, LimitsCardsToTheirLength) {
  MidwayStart midway_start;
  midway_start.signal = signal_before();
  midway_start.signal->yellow_left_s[Side::kEast] = {30, 4000};
  AutoRef referee = continued(midway_start);
  const RefereeSignal signal = referee.update(frame_with_ball(1, {0.5, 0.2}), {});
  EXPECT_NEAR(signal.yellow_left_s[Side::kEast].back(), 120 - 1 / kMidwayRate_hz, 1e-9);
}

// The rules of the paper have no cards, so nobody would end one.
TEST(BegunMidway, IgnoresCardsIfItsRulesHaveNone) {
  MidwayStart midway_start;
  midway_start.signal = signal_before();
  Configuration configuration;
  configuration.robots = {{6, 6}};
  AutoRef referee{configuration};
  referee.begin(midway_start);
  referee.update(frame_with_ball(0, {0.5, 0.2}), {});
  const RefereeSignal signal = referee.update(frame_with_ball(1, {0.5, 0.2}), {});
  EXPECT_EQ(signal.robots_allowed, (PerSide<int>{{6, 6}}));
  EXPECT_TRUE(signal.yellow_left_s[Side::kEast].empty());
}

// Two timeouts per team; the timeouts left from the game do not count. Extra time follows the only
// half, so it is the second entry of the goals by half.
TEST(BegunMidway, InTheBreakBeforeExtraTimeHasAllItsTimeouts) {
  MidwayStart midway_start{Command{CommandKind::kPrepareKickoff, Side::kEast}, {0, 0}, true};
  midway_start.signal = signal_before();
  midway_start.signal->stage = Stage::kExtraTimeBreak;
  midway_start.signal->timeouts_left = {{0, 0}};
  Configuration configuration;
  configuration.rules = *find_rule_book("2026-b");
  configuration.halves = 1;
  configuration.knockout = true;
  AutoRef referee{configuration};
  referee.begin(midway_start);
  referee.update(frame_with_ball(0, {0, 0}), {});
  const RefereeSignal signal = referee.update(frame_with_ball(1, {0, 0}), {});
  EXPECT_EQ(signal.timeouts_left, (PerSide<int>{{2, 2}}));
  EXPECT_EQ(referee.goals_by_half().size(), 2U);
}

// A card that is already paid for does not come again.
TEST(BegunMidway, ShowsNoCardForEarlierFouls) {
  MidwayStart midway_start;
  midway_start.signal = signal_before();
  midway_start.signal->fouls = {{7, 6}};
  AutoRef referee = continued(midway_start);
  for (int number = 1; number < 30; ++number)
    referee.update(frame_with_ball(number, {0.5, 0.2}), {});
  EXPECT_EQ(referee.decisions().size(), 0U);
  EXPECT_EQ(referee.state(), State::kRun);
}

TEST(BegunMidway, InABreakBeginsTheNextHalfWithItsKickoff) {
  MidwayStart midway_start{Command{CommandKind::kPrepareKickoff, Side::kEast}, {0, 0}, true};
  midway_start.signal = signal_before();
  midway_start.signal->stage = Stage::kHalfTime;
  midway_start.signal->blue_on_positive_half = true;
  AutoRef referee = continued(midway_start);
  const RefereeSignal signal = referee.update(frame_with_ball(1, {0, 0}), {});
  EXPECT_EQ(signal.stage, Stage::kSecondHalfPre);
  EXPECT_EQ(signal.stage_time_left_s, 0);
  EXPECT_FALSE(signal.blue_on_positive_half);
}

TEST(BegunMidway, NeedsAGameWithThatHalf) {
  MidwayStart midway_start;
  midway_start.signal = signal_before();
  EXPECT_THROW(continued(midway_start, 1), std::invalid_argument);
  for (const Stage stage : {Stage::kExtraFirstHalf, Stage::kShootout, Stage::kPostGame}) {
    midway_start.signal->stage = stage;
    EXPECT_THROW(continued(midway_start), std::invalid_argument) << name_of(stage);
  }
}

}  // namespace
}  // namespace autoref::referee
