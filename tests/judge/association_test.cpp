// Compares a referee's calls with the ground truth, using lists made by hand.
#include <gtest/gtest.h>

#include <algorithm>

#include "judge/association.hpp"

namespace autoref::judge::ground_truth {
namespace {

TrueEvent event(std::string_view name, double time_s, std::optional<Side> offender,
                Standing standing = Standing::kTrue) {
  TrueEvent event;
  event.name = name;
  event.time_s = time_s;
  event.offender = offender;
  event.standing = standing;
  return event;
}

JudgedCall call(std::string_view name, double time_s, std::optional<Side> offender) {
  return {name, time_s, offender, std::nullopt, Vec2(1, 0), true, false};
}

std::vector<experiments::CallOutcome> outcomes(const TrueEvents& true_events,
                                               const std::vector<JudgedCall>& calls) {
  std::vector<experiments::CallOutcome> outcomes;
  for (const experiments::CallVerdict& verdict : associate(true_events, calls))
    outcomes.push_back(verdict.outcome);
  return outcomes;
}

constexpr Side kWest = Side::kWest;
constexpr Side kEast = Side::kEast;

TEST(Association, FindsACallRightByNameSideAndTime) {
  TrueEvent goal = event("goal", 10.0, kWest);
  goal.position_m = Vec2(1, 0.1);
  const std::vector<experiments::CallVerdict> verdicts =
      associate({goal}, {call("goal", 10.1, kWest)});
  ASSERT_EQ(verdicts.size(), 1U);
  EXPECT_EQ(verdicts[0].outcome, experiments::CallOutcome::kRight);
  EXPECT_NEAR(verdicts[0].delay_s, 0.1, 1e-9);
  EXPECT_NEAR(verdicts[0].error_m.value(), 0.1, 1e-9);
}

TEST(Association, FindsAnEventMissedAndTheCallWrongIfTheSideIsWrong) {
  EXPECT_EQ(
      outcomes({event("bot_crash_unique", 10.0, kWest)}, {call("bot_crash_unique", 10.1, kEast)}),
      (std::vector<experiments::CallOutcome>{experiments::CallOutcome::kMissed,
                                             experiments::CallOutcome::kWrong}));
}

TEST(Association, FindsACallTooLateOrTooEarlyWrong) {
  for (const double time_s : {9.7, 11.1}) {
    EXPECT_EQ(outcomes({event("bot_crash_unique", 10.0, kWest)},
                       {call("bot_crash_unique", time_s, kWest)})
                  .size(),
              2U);
  }
}

TEST(Association, MatchesAnEventWithOnlyOneCall) {
  const std::vector<experiments::CallVerdict> verdicts =
      associate({event("bot_crash_unique", 10.0, kWest)},
                {call("bot_crash_unique", 10.0, kWest), call("bot_crash_unique", 10.2, kWest)});
  ASSERT_EQ(verdicts.size(), 2U);
  EXPECT_EQ(verdicts[0].outcome, experiments::CallOutcome::kRight);
  EXPECT_EQ(verdicts[1].outcome, experiments::CallOutcome::kWrong);
  EXPECT_TRUE(verdicts[1].is_second);
}

TEST(Association, CountsAPreventedEventOnlyIfItWasCalled) {
  const TrueEvents prevented = {event("throw_in", 10.0, kWest, Standing::kPrevented)};
  EXPECT_TRUE(outcomes(prevented, {}).empty());
  const std::vector<experiments::CallVerdict> verdicts =
      associate(prevented, {call("throw_in", 10.0, kWest)});
  ASSERT_EQ(verdicts.size(), 1U);
  EXPECT_EQ(verdicts[0].outcome, experiments::CallOutcome::kRight);
  EXPECT_TRUE(verdicts[0].is_early);
}

TEST(Association, FindsACallOfANearMissWrongButBorderline) {
  const std::vector<experiments::CallVerdict> verdicts =
      associate({event("bot_crash_unique", 10.0, kWest, Standing::kNearMiss)},
                {call("bot_crash_unique", 10.0, kWest)});
  ASSERT_EQ(verdicts.size(), 1U);
  EXPECT_EQ(verdicts[0].outcome, experiments::CallOutcome::kWrong);
  EXPECT_TRUE(verdicts[0].is_borderline);
}

TEST(Association, FindsAnEventOvertakenByAnotherRightCall) {
  const TrueEvents both = {event("bot_crash_unique", 10.0, kWest), event("goal", 10.0, kEast)};
  EXPECT_EQ(outcomes(both, {call("goal", 10.0, kEast)}),
            (std::vector<experiments::CallOutcome>{experiments::CallOutcome::kRight,
                                                   experiments::CallOutcome::kOvertaken}));
  EXPECT_EQ(outcomes(both, {call("throw_in", 10.0, kEast)}),
            (std::vector<experiments::CallOutcome>{experiments::CallOutcome::kWrong,
                                                   experiments::CallOutcome::kMissed,
                                                   experiments::CallOutcome::kMissed}));
}

TEST(Association, FindsACallWithUnknownTouchRightAndTheThrowInMissed) {
  const std::vector<experiments::CallVerdict> verdicts =
      associate({event("throw_in", 10.0, kWest)}, {call("touch_line_unknown", 10.0, std::nullopt)});
  ASSERT_EQ(verdicts.size(), 2U);
  EXPECT_EQ(verdicts[0].outcome, experiments::CallOutcome::kRight);
  EXPECT_EQ(verdicts[0].name, "touch_line_unknown");
  EXPECT_EQ(verdicts[1].outcome, experiments::CallOutcome::kMissed);
}

TEST(Association, EvaluatesTheCardForEveryThirdFoul) {
  referee::Decision card;
  card.time_s = 10.0;
  card.finding.event = referee::Event::kMultipleFouls;
  card.finding.offender = kWest;
  const std::optional<JudgedCall> shown = call_of(card);
  ASSERT_TRUE(shown);
  const std::vector<experiments::CallVerdict> verdicts =
      associate({event("multiple_fouls", 10.0, kWest)}, {*shown});
  ASSERT_EQ(verdicts.size(), 1U);
  EXPECT_EQ(verdicts[0].outcome, experiments::CallOutcome::kRight);
}

// Play continues after a call that does not stop it, so the referee can still call another event
// that happened at the same time.
TEST(Association, DoesNotFindAnEventOvertakenByACallThatLetsPlayContinue) {
  referee::Decision fast;
  fast.time_s = 10.0;
  fast.from = fast.to = referee::State::kRun;
  fast.finding.event = referee::Event::kBotKickedBallTooFast;
  fast.finding.offender = kWest;
  const TrueEvents both = {event("bot_kicked_ball_too_fast", 10.0, kWest),
                           event("bot_crash_unique", 10.0, kEast)};
  EXPECT_EQ(outcomes(both, {*call_of(fast)}),
            (std::vector<experiments::CallOutcome>{experiments::CallOutcome::kRight,
                                                   experiments::CallOutcome::kMissed}));
}

// A kick out of the kicker's own half is an exit over the goal line, too.
TEST(Association, FindsAnExitWithUnknownTouchRightForAnAimlessKick) {
  const std::vector<experiments::CallOutcome> found = outcomes(
      {event("aimless_kick", 10.0, kWest)}, {call("goal_line_unknown", 10.1, std::nullopt)});
  EXPECT_EQ(std::count(found.begin(), found.end(), experiments::CallOutcome::kRight), 1);
  EXPECT_EQ(std::count(found.begin(), found.end(), experiments::CallOutcome::kWrong), 0);
}

// Both sides touched the ball at once, so either restart is right.
TEST(Association, FindsEitherRestartRightAfterASharedTouch) {
  TrueEvent exit = event("goal_kick", 10.0, std::nullopt);
  exit.or_name = "corner_kick";
  for (const char* restart : {"goal_kick", "corner_kick", "throw_in"}) {
    const std::vector<experiments::CallOutcome> found =
        outcomes({exit}, {call(restart, 10.0, kEast)});
    EXPECT_EQ(found.front() == experiments::CallOutcome::kRight,
              std::string_view(restart) != "throw_in")
        << restart;
  }
}

}  // namespace
}  // namespace autoref::judge::ground_truth
