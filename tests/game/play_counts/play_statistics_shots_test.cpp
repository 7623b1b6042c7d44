// Which kicks are shots and which shots are on goal.
#include <gtest/gtest.h>

#include "tests/game/play_counts/play_sequence.hpp"

namespace autoref::game {
namespace {

struct Kick {
  const char* what;
  Vec2 from_m;
  Vec2 ball_mps;
  bool is_shot;
};

std::ostream& operator<<(std::ostream& out, const Kick& kick) { return out << kick.what; }

class KickOfWest : public testing::TestWithParam<Kick> {};

TEST_P(KickOfWest, IsAShotIfItCrossesTheGoalLineNearTheGoalFastEnough) {
  PlaySequence play;
  play.kick(kWest1, GetParam().from_m, GetParam().ball_mps);
  play.frame();
  play.stop();
  EXPECT_EQ(play.west().shots, GetParam().is_shot ? 1 : 0);
  EXPECT_EQ(play.east().shots, 0);
}

// Kicked at 2 m/s, the ball slides for 0.324 m, then rolls at 1.34 m/s and slows down to 1 m/s
// after another 1.3 m. West's own third ends at x = -1.008 m.
INSTANTIATE_TEST_SUITE_P(
    PlayStatistics, KickOfWest,
    testing::Values(Kick{"straight", {1, 0}, {6, 0}, true},
                    Kick{"wide by 0.2 m", {1, 0.55}, {6, 0}, true},
                    Kick{"wide by 0.3 m", {1, 0.65}, {6, 0}, false},
                    Kick{"diagonally from the wing", {1, 1.5}, {4, -3}, true},
                    Kick{"at the team's own goal", {1, 0}, {-6, 0}, false},
                    Kick{"along the goal line", {3, 0}, {0, 6}, false},
                    Kick{"from the halfway line", {-0.1, 0}, {6, 0}, true},
                    Kick{"from just outside the team's own third", {-1.0, 0}, {6.5, 0}, true},
                    Kick{"from the team's own third", {-1.02, 0}, {6.5, 0}, false},
                    Kick{"slow but near", {1.5, 0}, {2, 0}, true},
                    Kick{"slow and too far", {1.3, 0}, {2, 0}, false},
                    Kick{"just a nudge", {2.9, 0}, {0.9, 0}, false}));

TEST(Shot, CountsOnceForTheTeamThatKicked) {
  PlaySequence play;
  play.kick(kEast1, {-1, 0}, {-6, 0});
  play.frame();
  play.stop();
  EXPECT_EQ(play.east().shots, 1);
  EXPECT_EQ(play.west().shots, 0);
}

TEST(Shot, IsOnGoalIfAnOpponentTouchesItBetweenThePosts) {
  PlaySequence play;
  play.kick_to(kWest1, {1, 0}, {6, 0.5}, kEast1, {2.9, 0.2});
  EXPECT_EQ(play.west().shots, 1);
  EXPECT_EQ(play.west().shots_on_goal, 1);
}

TEST(Shot, IsNotOnGoalIfItIsWideOfThePost) {
  PlaySequence play;
  play.kick_to(kWest1, {1, 0.5}, {6, 0}, kEast1, {2.9, 0.5});
  EXPECT_EQ(play.west().shots, 1);
  EXPECT_EQ(play.west().shots_on_goal, 0);
}

TEST(Shot, IsNotOnGoalIfNobodyTouchesItBeforePlayStops) {
  PlaySequence play;
  play.kick(kWest1, {1, 0}, {6, 0});
  play.frame();
  play.stop();
  EXPECT_EQ(play.west().shots_on_goal, 0);
}

TEST(Shot, IsOnGoalIfItBecomesAGoalWhateverItsPredictedPath) {
  PlaySequence play;
  play.kick(kWest1, {-2, 0}, {6.5, 3});
  play.frame();
  play.goal_of(Side::kWest);
  EXPECT_EQ(play.west().shots, 1);
  EXPECT_EQ(play.west().shots_on_goal, 1);
  EXPECT_EQ(play.west().passes_tried, 0);
}

// At 4 m/s upwards and 1.5 m/s forwards, the ball lands after 0.815 s and 1.22 m; its apex is 0.8 m
// high, at 0.6 m.
TEST(Shot, IsNotOnGoalIfItFliesOverTheBar) {
  PlaySequence play;
  play.kick(kWest1, {2.4, 0}, {1.5, 0}, 4.0);
  play.frame();
  play.hull(kEast1, {2.9, 0});
  play.frame();
  EXPECT_EQ(play.west().shots, 1);
  EXPECT_EQ(play.west().shots_on_goal, 0);
}

TEST(Shot, CanBeABallCarriedOverTheLine) {
  PlaySequence play;
  play.hull(kWest1, {3.0, 0});
  play.frame();
  play.goal_of(Side::kWest);
  EXPECT_EQ(play.west().shots, 1);
  EXPECT_EQ(play.west().shots_on_goal, 1);
}

TEST(Shot, IsNotCountedForAnOwnGoal) {
  PlaySequence play;
  play.kick(kEast1, {2.5, 1}, {3, -6});
  play.frame();
  play.goal_of(Side::kWest);
  EXPECT_EQ(play.west().shots, 0);
  EXPECT_EQ(play.east().shots, 0);
}

TEST(Shot, IsNotCountedIfTheKickerTouchesTheBallNext) {
  PlaySequence play;
  play.kick_to(kWest1, {2, 0}, {3, 0}, kWest1, {2.4, 0});
  play.stop();
  EXPECT_EQ(play.west().shots, 0);
}

TEST(Shot, IsCountedIfTheKickersHullTouchesTheDepartingBall) {
  PlaySequence play;
  play.kick(kWest1, {2, 0}, {6, 0});
  play.frames(3);
  play.hull(kWest1, {2.01, 0});
  play.frames(30);
  play.hull(kEast1, {2.9, 0});
  play.frame();
  EXPECT_EQ(play.west().shots_on_goal, 1);
}

TEST(Shot, IsNotCountedIfAnOpponentIsAlreadyAtTheBall) {
  PlaySequence play;
  play.kick_to(kWest1, {2, 0}, {6, 0}, kEast1, {2.1, 0});
  play.stop();
  EXPECT_EQ(play.west().shots, 0);
}

TEST(Shot, IsNotCountedIfBothTeamsKickSimultaneously) {
  PlaySequence play;
  play.kick(kWest1, {2, 0}, {6, 0});
  play.kick(kEast1, {2, 0}, {6, 0});
  play.frame();
  play.stop();
  EXPECT_EQ(play.west().shots + play.east().shots, 0);
}

TEST(Shot, IsNotCountedOutsidePlay) {
  PlaySequence play;
  play.stop();
  play.kick(kWest1, {1, 0}, {6, 0});
  play.frames(60);
  EXPECT_EQ(play.west().shots, 0);
}

}  // namespace
}  // namespace autoref::game
