// Which kicks are passes and which passes are completed.
#include <gtest/gtest.h>

#include "tests/game/play_counts/play_sequence.hpp"

namespace autoref::game {
namespace {

struct Mate {
  const char* what;
  Vec2 mate_m;
  Vec2 ball_mps;  // of a kick from the centre
  bool is_pass;
};

std::ostream& operator<<(std::ostream& out, const Mate& mate) { return out << mate.what; }

class KickWithAMate : public testing::TestWithParam<Mate> {};

TEST_P(KickWithAMate, IsAPassIfItsPathLeadsToOrNearTheMate) {
  PlaySequence play;
  play.put(kWest2, GetParam().mate_m);
  play.kick(kWest1, {0, 0}, GetParam().ball_mps);
  play.frame();
  play.stop();
  EXPECT_EQ(play.west().passes_tried, GetParam().is_pass ? 1 : 0);
  EXPECT_EQ(play.west().passes_completed, 0);
}

// The kicks go north, so none of them is a shot. Kicked at 4 m/s, the ball passes y = 1.5 m after
// 0.44 s. Kicked at 2 m/s, it passes y = 1.5 m after 1.2 s at 1.04 m/s, and slows down to 1 m/s
// after 1.65 m. It leaves the field at y = 2.025 m.
INSTANTIATE_TEST_SUITE_P(
    PlayStatistics, KickWithAMate,
    testing::Values(Mate{"on the path", {0, 1.5}, {0, 4}, true},
                    Mate{"a step aside", {0.45, 1.5}, {0, 4}, true},
                    Mate{"too far aside", {0.6, 1.5}, {0, 4}, false},
                    Mate{"in reach of a slow ball", {0.9, 1.5}, {0, 2}, true},
                    Mate{"out of reach even of a slow ball", {1.05, 1.5}, {0, 2}, false},
                    Mate{"beside the kicker", {0.2, 0.3}, {0, 4}, false},
                    Mate{"behind the kicker", {0, -1}, {0, 4}, false},
                    Mate{"where a slow ball still arrives", {0, 1.6}, {0, 2}, true},
                    Mate{"where a slow ball arrives too slowly", {0, 1.8}, {0, 2}, false},
                    Mate{"a step outside the field", {0, 2.3}, {0, 4}, true},
                    Mate{"far outside the field", {0, 3.1}, {0, 4}, false}));

TEST(Pass, IsCompletedIfAMateTouchesTheBallNext) {
  PlaySequence play;
  play.put(kWest2, {0, 1.5});
  play.kick_to(kWest1, {0, 0}, {0, 4}, kWest2, {0, 1.4});
  EXPECT_EQ(play.west().passes_tried, 1);
  EXPECT_EQ(play.west().passes_completed, 1);
  EXPECT_EQ(play.east().passes_tried, 0);
}

TEST(Pass, IsCompletedIfAMateKicksTheBallFirstTime) {
  PlaySequence play;
  play.put(kWest2, {0, 1.5});
  play.kick(kWest1, {0, 0}, {0, 4});
  play.frames(30);
  play.kick(kWest2, {0, 1.4}, {6, -2});
  play.frame();
  EXPECT_EQ(play.west().passes_completed, 1);
}

TEST(Pass, IsNotCompletedIfAnOpponentTouchesTheBallFirst) {
  PlaySequence play;
  play.put(kWest2, {0, 1.5});
  play.kick_to(kWest1, {0, 0}, {0, 4}, kEast1, {0, 1.0});
  play.hull(kWest2, {0, 1.4});
  play.frame();
  EXPECT_EQ(play.west().passes_tried, 1);
  EXPECT_EQ(play.west().passes_completed, 0);
}

TEST(Pass, IsNotCompletedIfBothTeamsTouchTheBallInTheSameSubstep) {
  PlaySequence play;
  play.put(kWest2, {0, 1.5});
  play.kick(kWest1, {0, 0}, {0, 4});
  play.frames(30);
  play.hull(kWest2, {0, 1.4});
  play.hull(kEast1, {0, 1.4});
  play.frame();
  EXPECT_EQ(play.west().passes_tried, 1);
  EXPECT_EQ(play.west().passes_completed, 0);
}

TEST(Pass, IsCompletedIfTheMateIsASubstepAhead) {
  PlaySequence play;
  play.put(kWest2, {0, 1.5});
  play.kick(kWest1, {0, 0}, {0, 4});
  play.frames(30);
  play.hull(kWest2, {0, 1.4});
  play.substep = 1;
  play.hull(kEast1, {0, 1.4});
  play.frame();
  EXPECT_EQ(play.west().passes_completed, 1);
}

TEST(Pass, IsNotCountedIfTheKickerTouchesTheBallNext) {
  PlaySequence play;
  play.put(kWest2, {0, 1.5});
  play.kick_to(kWest1, {0, 0}, {0, 4}, kWest1, {0, 0.8});
  play.hull(kWest2, {0, 1.4});
  play.stop();
  EXPECT_EQ(play.west().passes_tried, 0);
}

TEST(Pass, IsNotCountedIfNoMateIsNearThePath) {
  PlaySequence play;
  play.put(kWest2, {0, -1.5});
  play.kick_to(kWest1, {0, 0}, {0, 4}, kWest2, {0, 1.4});
  EXPECT_EQ(play.west().passes_tried, 0);
  EXPECT_EQ(play.west().passes_completed, 0);
}

TEST(Pass, IsNotAShotIfAMateTouchesTheBallInFrontOfTheGoal) {
  PlaySequence play;
  play.put(kWest2, {2, 0});
  play.kick_to(kWest1, {0.5, 0}, {5, 0}, kWest2, {1.9, 0});
  EXPECT_EQ(play.west().passes_completed, 1);
  EXPECT_EQ(play.west().shots, 0);
}

TEST(Pass, CountsAsAShotAtTheGoalIfNoMateTouchesTheBall) {
  PlaySequence play;
  play.put(kWest2, {2, 0.3});
  play.kick_to(kWest1, {0.5, 0}, {5, 0}, kEast1, {2.8, 0});
  EXPECT_EQ(play.west().shots_on_goal, 1);
  EXPECT_EQ(play.west().passes_tried, 0);
}

// At 3.5 m/s both forwards and upwards, the ball lands after 2.5 m.
TEST(Pass, ThroughTheAirReachesMatesWhereItLandsButNotUnderItsFlight) {
  for (const double mate_x_m : {1.0, 2.8}) {
    PlaySequence play;
    play.put(kWest2, {mate_x_m - 2.9, 1.5});
    play.kick(kWest1, {-2.9, 1.5}, {3.5, 0}, 3.5);
    play.frame();
    play.stop();
    EXPECT_EQ(play.west().passes_tried, mate_x_m > 2 ? 1 : 0);
  }
}

TEST(Pass, RequiresTheBallToBeFasterThanItsKicker) {
  for (const double robot_mps : {0.0, 2.0}) {
    PlaySequence play;
    play.put(kWest1, {0, -0.1}, {0, robot_mps});
    play.put(kWest2, {0, 1.0});
    play.kick(kWest1, {0, 0}, {0, 2.5});
    play.frame();
    play.stop();
    EXPECT_EQ(play.west().passes_tried, robot_mps == 0 ? 1 : 0);
  }
}

}  // namespace
}  // namespace autoref::game
