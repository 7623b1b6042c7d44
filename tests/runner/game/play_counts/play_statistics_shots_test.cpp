// Which kicks are shots, and which of them are on goal.
#include <gtest/gtest.h>

#include "tests/runner/game/play_counts/play_sequence.hpp"

namespace autoref::runner {
namespace {

struct Kick {
  const char* what;
  Vec2 from_m;
  Vec2 ball_mps;
  bool is_shot;
};

std::ostream& operator<<(std::ostream& out, const Kick& kick) { return out << kick.what; }

class KickOfWest : public testing::TestWithParam<Kick> {};

TEST_P(KickOfWest, IsAShotIfItsWayLeadsAboutBetweenThePostsFastEnough) {
  PlaySequence play;
  play.kick(kWest1, GetParam().from_m, GetParam().ball_mps);
  play.frame();
  play.stop();
  EXPECT_EQ(play.west().shots, GetParam().is_shot ? 1 : 0);
  EXPECT_EQ(play.east().shots, 0);
}

// Of a kick at 2 m/s the ball slides for 0.324 m and then rolls at 1.34 m/s; after 1.3 m more it is
// down to 1 m/s. In the own third x is less than -1.008 m.
INSTANTIATE_TEST_SUITE_P(
    PlayStatistics, KickOfWest,
    testing::Values(Kick{"straight", {1, 0}, {6, 0}, true},
                    Kick{"wide by 0.2 m", {1, 0.55}, {6, 0}, true},
                    Kick{"wide by 0.3 m", {1, 0.65}, {6, 0}, false},
                    Kick{"slanting in from the wing", {1, 1.5}, {4, -3}, true},
                    Kick{"at the own goal", {1, 0}, {-6, 0}, false},
                    Kick{"along the goal line", {3, 0}, {0, 6}, false},
                    Kick{"from the halfway line", {-0.1, 0}, {6, 0}, true},
                    Kick{"from just outside the own third", {-1.0, 0}, {6.5, 0}, true},
                    Kick{"from the own third", {-1.02, 0}, {6.5, 0}, false},
                    Kick{"slow but near", {1.5, 0}, {2, 0}, true},
                    Kick{"slow and too far", {1.3, 0}, {2, 0}, false},
                    Kick{"no more than a nudge", {2.9, 0}, {0.9, 0}, false}));

TEST(Shot, CountsOnceForTheTeamThatTookIt) {
  PlaySequence play;
  play.kick(kEast1, {-1, 0}, {-6, 0});
  play.frame();
  play.stop();
  EXPECT_EQ(play.east().shots, 1);
  EXPECT_EQ(play.west().shots, 0);
}

TEST(Shot, BetweenThePostsThatAnOpponentTouchesIsOnGoal) {
  PlaySequence play;
  play.kick_to(kWest1, {1, 0}, {6, 0.5}, kEast1, {2.9, 0.2});
  EXPECT_EQ(play.west().shots, 1);
  EXPECT_EQ(play.west().shots_on_goal, 1);
}

TEST(Shot, WideOfThePostIsNotOnGoalWhoeverTouchesIt) {
  PlaySequence play;
  play.kick_to(kWest1, {1, 0.5}, {6, 0}, kEast1, {2.9, 0.5});
  EXPECT_EQ(play.west().shots, 1);
  EXPECT_EQ(play.west().shots_on_goal, 0);
}

TEST(Shot, ThatNobodyTouchesBeforePlayStopsIsNotOnGoal) {
  PlaySequence play;
  play.kick(kWest1, {1, 0}, {6, 0});
  play.frame();
  play.stop();
  EXPECT_EQ(play.west().shots_on_goal, 0);
}

TEST(Shot, ThatBecomesAGoalIsOnGoalWhereverItsWaySeemedToLead) {
  PlaySequence play;
  play.kick(kWest1, {-2, 0}, {6.5, 3});
  play.frame();
  play.goal_of(Side::kWest);
  EXPECT_EQ(play.west().shots, 1);
  EXPECT_EQ(play.west().shots_on_goal, 1);
  EXPECT_EQ(play.west().passes_tried, 0);
}

// Up at 4 m/s and 1.5 m/s forward the ball has fallen after 0.815 s and 1.22 m; at 0.6 m it is at
// the top, 0.8 m high.
TEST(Shot, ThatFliesOverTheBarIsNotOnGoal) {
  PlaySequence play;
  play.kick(kWest1, {2.4, 0}, {1.5, 0}, 4.0);
  play.frame();
  play.hull(kEast1, {2.9, 0});
  play.frame();
  EXPECT_EQ(play.west().shots, 1);
  EXPECT_EQ(play.west().shots_on_goal, 0);
}

TEST(Shot, IsAlsoABallCarriedOverTheLine) {
  PlaySequence play;
  play.hull(kWest1, {3.0, 0});
  play.frame();
  play.goal_of(Side::kWest);
  EXPECT_EQ(play.west().shots, 1);
  EXPECT_EQ(play.west().shots_on_goal, 1);
}

TEST(Shot, IsNoneOfTheTeamThatGetsAGoalByAnOwnGoal) {
  PlaySequence play;
  play.kick(kEast1, {2.5, 1}, {3, -6});
  play.frame();
  play.goal_of(Side::kWest);
  EXPECT_EQ(play.west().shots, 0);
  EXPECT_EQ(play.east().shots, 0);
}

TEST(Shot, IsNoneWhereTheKickerItselfTouchesTheBallNext) {
  PlaySequence play;
  play.kick_to(kWest1, {2, 0}, {3, 0}, kWest1, {2.4, 0});
  play.stop();
  EXPECT_EQ(play.west().shots, 0);
}

TEST(Shot, IsStillOneWhenTheHullMeetsTheBallWhileItLeaves) {
  PlaySequence play;
  play.kick(kWest1, {2, 0}, {6, 0});
  play.frames(3);
  play.hull(kWest1, {2.01, 0});
  play.frames(30);
  play.hull(kEast1, {2.9, 0});
  play.frame();
  EXPECT_EQ(play.west().shots_on_goal, 1);
}

TEST(Shot, IsNoneAgainstAnOpponentWhoIsAtTheBallAlready) {
  PlaySequence play;
  play.kick_to(kWest1, {2, 0}, {6, 0}, kEast1, {2.1, 0});
  play.stop();
  EXPECT_EQ(play.west().shots, 0);
}

TEST(Shot, IsNoneWhereBothTeamsKickAtOnce) {
  PlaySequence play;
  play.kick(kWest1, {2, 0}, {6, 0});
  play.kick(kEast1, {2, 0}, {6, 0});
  play.frame();
  play.stop();
  EXPECT_EQ(play.west().shots + play.east().shots, 0);
}

TEST(Shot, OutsidePlayIsNone) {
  PlaySequence play;
  play.stop();
  play.kick(kWest1, {1, 0}, {6, 0});
  play.frames(60);
  EXPECT_EQ(play.west().shots, 0);
}

}  // namespace
}  // namespace autoref::runner
