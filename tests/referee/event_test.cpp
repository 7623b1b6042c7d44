#include "referee/event.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "referee/state.hpp"

namespace autoref::referee {
namespace {

template <typename... Values>
constexpr bool are_numbered_from_0(Values... values) {
  int next = 0;
  return ((static_cast<int>(values) == next++) && ...);
}

// Numbers are listed here as well as in events.def, because state hashes must stay comparable for
// years.
static_assert(are_numbered_from_0(
    Event::kBegin, Event::kRobotsMoved, Event::kStartTimeout, Event::kReady, Event::kReadyTimeout,
    Event::kGoal, Event::kThrowIn, Event::kCornerKick, Event::kGoalKick, Event::kTouchLineUnknown,
    Event::kAttackerTooCloseToDefenseArea, Event::kRestartNotTaken, Event::kStuckBall,
    Event::kSignalled, Event::kHalfOver, Event::kGameOver, Event::kNoProgressInGame,
    Event::kBotKickedBallTooFast, Event::kChippedGoal, Event::kInvalidGoal, Event::kIndirectGoal,
    Event::kFreeKickOwnGoal, Event::kDefenderInDefenseArea, Event::kDefenderInDefenseAreaPartially,
    Event::kAttackerTouchedBallInDefenseArea, Event::kAttackerDoubleTouchedBall,
    Event::kDefenderTooCloseToKickPoint, Event::kBotDribbledBallTooFar, Event::kKeeperHeldBall,
    Event::kBotCrashUnique, Event::kBotPushedBot, Event::kTooManyRobots, Event::kKickoffPositions,
    Event::kPenaltyPositions, Event::kPenaltyKickFailed, Event::kAimlessKick, Event::kOffside,
    Event::kGoalLineUnknown, Event::kBotCrashDrawn, Event::kAttackerStaysNearArea,
    Event::kBotTooFastInStop, Event::kStopDistance, Event::kBotInterferedPlacement,
    Event::kMultipleFouls, Event::kMultipleCards, Event::kCardOver, Event::kTimeout,
    Event::kTimeoutOver, Event::kGoalLead, Event::kExtraTime, Event::kShootout,
    Event::kShootoutOver, Event::kCommandGiven, Event::kOverruled, Event::kPlacementSucceeded,
    Event::kPlacementFailed, Event::kBoundaryCrossing));
static_assert(are_numbered_from_0(State::kInit, State::kWaitStart, State::kWaitStop, State::kRun,
                                  State::kDelayWait, State::kOver, State::kTimeout));

TEST(Events, HaveUniqueNamesAndASentence) {
  std::set<std::string_view> names;
  for (const EventEntry& entry : event_table()) {
    EXPECT_FALSE(entry.name.empty()) << static_cast<int>(entry.event);
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_TRUE(entry.about.ends_with('.')) << entry.name;
  }
}

// If exactly one league event means the same, the names differ only in case.
TEST(Events, UseTheLeaguesNames) {
  EXPECT_EQ(name_of(Event::kBotCrashUnique), "bot_crash_unique");
  EXPECT_EQ(entry_of(Event::kBotCrashUnique).league_event, "BOT_CRASH_UNIQUE");
  EXPECT_EQ(entry_of(Event::kThrowIn).league_event, "BALL_LEFT_FIELD_TOUCH_LINE");
  EXPECT_EQ(entry_of(Event::kOffside).league_event, "");
}

// Calls are made for play and robots, not for the course of the game or the cards that follow.
TEST(Events, AreCallsIfTheyConcernPlayOrRobots) {
  EXPECT_TRUE(is_call(Event::kGoal));
  EXPECT_TRUE(is_call(Event::kBotCrashDrawn));
  EXPECT_FALSE(is_call(Event::kReady));
  EXPECT_FALSE(is_call(Event::kSignalled));
  EXPECT_FALSE(is_call(Event::kMultipleFouls));
}

// Of the events of 1.0; others follow from their entries.
TEST(Events, MayComeInAStopIfTheirRuleIsActiveThen) {
  const std::set<Event> in_stop = {Event::kAttackerStaysNearArea, Event::kBotTooFastInStop,
                                   Event::kStopDistance,          Event::kBotInterferedPlacement,
                                   Event::kBoundaryCrossing,      Event::kTooManyRobots};
  for (int number = 0; number <= static_cast<int>(Event::kBoundaryCrossing); ++number) {
    const Event event = static_cast<Event>(number);
    EXPECT_EQ(may_come_in_stop(event), in_stop.contains(event)) << name_of(event);
  }
}

// A ball that leaves the field, a goal that does not count and a restart that is not taken are not
// fouls.
TEST(Events, AreFoulsIfARobotBreaksARule) {
  for (const Event event : {Event::kGoal, Event::kThrowIn, Event::kChippedGoal, Event::kStuckBall,
                            Event::kNoProgressInGame, Event::kAimlessKick,
                            Event::kPenaltyKickFailed, Event::kRestartNotTaken}) {
    EXPECT_FALSE(entry_of(event).is_foul) << name_of(event);
  }
  for (const Event event : {Event::kBotCrashUnique, Event::kBotPushedBot, Event::kOffside,
                            Event::kBotTooFastInStop, Event::kKeeperHeldBall}) {
    EXPECT_TRUE(entry_of(event).is_foul) << name_of(event);
  }
}

}  // namespace
}  // namespace autoref::referee
