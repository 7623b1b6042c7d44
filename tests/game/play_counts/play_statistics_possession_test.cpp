// Which team has possession, and which team's fouls are counted.
#include <gtest/gtest.h>

#include "tests/game/play_counts/play_sequence.hpp"

namespace autoref::game {
namespace {

using referee::Event;

TEST(Possession, LastsFromATeamsTouchUntilTheOtherTeams) {
  PlaySequence play;
  play.hull(kWest1, {0, 0});
  play.frames(90);
  play.hull(kEast1, {0, 0});
  play.frames(30);
  EXPECT_DOUBLE_EQ(play.west().possession_s, 1.5);
  EXPECT_DOUBLE_EQ(play.east().possession_s, 0.5);
}

TEST(Possession, BelongsToNobodyBeforeTheFirstTouch) {
  PlaySequence play;
  play.hull(kWest1, {0, 0});
  play.frames(60);
  play.stop();
  play.signal_play();
  play.frames(60);
  EXPECT_DOUBLE_EQ(play.west().possession_s, 1.0);
  EXPECT_DOUBLE_EQ(play.east().possession_s, 0.0);
}

TEST(Possession, IsNotCountedBeforeTheBallIsInPlay) {
  PlaySequence play;
  play.stop();
  play.is_on = true;
  play.frame();
  play.hull(kWest1, {0, 0});
  play.frames(60);
  EXPECT_DOUBLE_EQ(play.west().possession_s, 0.0);
  play.is_in_play = true;
  play.frames(60);
  EXPECT_DOUBLE_EQ(play.west().possession_s, 1.0);
}

TEST(Possession, DoesNotChangeIfBothTeamsTouchTheBallSimultaneously) {
  for (const RobotId had_it : {kWest1, kEast1}) {
    PlaySequence play;
    play.hull(had_it, {0, 0});
    play.frame();
    play.hull(kWest1, {0, 0});
    play.hull(kEast1, {0, 0});
    play.frames(59);
    EXPECT_DOUBLE_EQ(play.statistics.counts()[had_it.side].possession_s, 1.0);
  }
}

TEST(Possession, GoesToTheTeamThatTouchesTheBallASubstepLater) {
  PlaySequence play;
  play.hull(kEast1, {0, 0});
  play.substep = 1;
  play.hull(kWest1, {0, 0});
  play.frames(60);
  EXPECT_DOUBLE_EQ(play.west().possession_s, 1.0);
}

referee::Decision decision_on(Event event, std::optional<Side> offender) {
  referee::Decision decision;
  decision.finding.event = event;
  decision.finding.offender = offender;
  return decision;
}

TEST(Fouls, CountForTheSideAtFault) {
  PlaySequence play;
  play.decide(decision_on(Event::kBotPushedBot, Side::kEast));
  play.decide(decision_on(Event::kBotDribbledBallTooFar, Side::kEast));
  play.decide(decision_on(Event::kAttackerTooCloseToDefenseArea, Side::kWest));
  play.frame();
  EXPECT_EQ(play.east().fouls, 2);
  EXPECT_EQ(play.west().fouls, 1);
}

TEST(Fouls, CountForBothSidesIfBothAreAtFault) {
  PlaySequence play;
  play.decide(decision_on(Event::kBotCrashDrawn, std::nullopt));
  play.frame();
  EXPECT_EQ(play.west().fouls, 1);
  EXPECT_EQ(play.east().fouls, 1);
}

TEST(Fouls, CountWhilePlayIsStopped) {
  PlaySequence play;
  play.stop();
  play.decide(decision_on(Event::kBotTooFastInStop, Side::kWest));
  play.frame();
  EXPECT_EQ(play.west().fouls, 1);
}

TEST(Fouls, ExcludeExitsGoalsAndOtherEventsThatAreNotFouls) {
  PlaySequence play;
  for (const Event event :
       {Event::kThrowIn, Event::kGoal, Event::kAimlessKick, Event::kChippedGoal,
        Event::kInvalidGoal, Event::kIndirectGoal, Event::kFreeKickOwnGoal, Event::kRestartNotTaken,
        Event::kPenaltyKickFailed, Event::kStuckBall, Event::kNoProgressInGame,
        Event::kMultipleFouls, Event::kMultipleCards}) {
    play.decide(decision_on(event, Side::kWest));
  }
  play.frame();
  EXPECT_EQ(play.west().fouls, 0);
  EXPECT_EQ(play.east().fouls, 0);
}

}  // namespace
}  // namespace autoref::game
