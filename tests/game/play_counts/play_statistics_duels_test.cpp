// Duels for the ball: their beginning, end and winner.
#include <gtest/gtest.h>

#include "tests/game/play_counts/play_sequence.hpp"

namespace autoref::game {
namespace {

// Two robots face each other with the ball between their plates at the centre.
struct Duel : PlaySequence {
  explicit Duel(int frames_of_it = 12) {
    put(kWest1, {-0.11, 0});
    put(kEast1, {0.11, 0});
    frames(frames_of_it);
  }
  // Moves the robot, with the ball at its plate, to `x_m`; the other one stays.
  void lead_away(RobotId id, double x_m) {
    put(id, {x_m + 0.1 * goal_sign(id.side), 0});
    hull(id, {x_m, 0});
    frame();
  }
  int won() const { return west().duels_won + east().duels_won; }
};

TEST(Duel, IsWonByTakingTheBallFarAway) {
  Duel duel;
  duel.lead_away(kWest1, -0.6);
  EXPECT_EQ(duel.west().duels_won, 1);
  EXPECT_EQ(duel.east().duels_won, 0);
}

TEST(Duel, CanBeWonByEitherSide) {
  Duel duel;
  duel.lead_away(kEast1, 0.6);
  EXPECT_EQ(duel.east().duels_won, 1);
  EXPECT_EQ(duel.west().duels_won, 0);
}

TEST(Duel, LastsWhileTheOpponentIsNear) {
  Duel duel;
  duel.lead_away(kWest1, -0.25);
  EXPECT_EQ(duel.won(), 0);
}

TEST(Duel, IsWonOnlyOnce) {
  Duel duel;
  for (int i = 0; i < 20; ++i) duel.lead_away(kWest1, -0.6 - 0.01 * i);
  EXPECT_EQ(duel.won(), 1);
}

TEST(Duel, DoesNotBeginBeforeATenthOfASecond) {
  Duel duel(3);
  duel.lead_away(kWest1, -0.6);
  EXPECT_EQ(duel.won(), 0);
}

TEST(Duel, DoesNotBeginIfOneRobotKeepsItsDistance) {
  PlaySequence play;
  play.put(kWest1, {-0.1, 0});
  play.put(kEast1, {0.18, 0});  // 83 mm from the ball
  play.frames(60);
  play.hull(kWest1, {-0.6, 0});
  play.frame();
  EXPECT_EQ(play.west().duels_won, 0);
}

TEST(Duel, IsWonByATeamMateWhoGetsTheBall) {
  Duel duel;
  duel.now.ball.position_m = {0, 1};
  duel.frame();
  duel.hull(kEast2, {0, 1.2});
  duel.frame();
  EXPECT_EQ(duel.east().duels_won, 1);
}

TEST(Duel, IsWonByKickingTheBallAway) {
  Duel duel;
  duel.kick(kWest1, {0, 0}, {0, 5});
  duel.frame();
  duel.now.ball.position_m = {0, 0.6};
  duel.frame();
  duel.hull(kEast2, {0, 1.2});
  duel.frame();
  EXPECT_EQ(duel.west().duels_won, 1);
  EXPECT_EQ(duel.east().duels_won, 0);
}

TEST(Duel, IsDrawnIfPlayStopsFirst) {
  Duel duel;
  duel.stop();
  duel.signal_play();
  duel.lead_away(kWest1, -0.6);
  EXPECT_EQ(duel.won(), 0);
}

TEST(Duel, IsDrawnAfterThreeSeconds) {
  for (const int frames : {170, 200}) {
    Duel duel(frames);
    duel.lead_away(kWest1, -0.6);
    EXPECT_EQ(duel.won(), frames == 170 ? 1 : 0) << frames;
  }
}

TEST(Duel, CanBeginAgainAfterADrawOnceTheRobotsHaveParted) {
  Duel duel(200);
  duel.put(kEast1, {1, 0});
  duel.frame();
  duel.put(kEast1, {0.1, 0});
  duel.frames(12);
  duel.lead_away(kWest1, -0.6);
  EXPECT_EQ(duel.west().duels_won, 1);
}

TEST(Duel, DoesNotBeginIfTheBallFliesOverTheRobots) {
  PlaySequence play;
  play.put(kWest1, {-0.1, 0});
  play.put(kEast1, {0.1, 0});
  play.now.ball.height_m = 0.5;
  play.frames(12);
  play.hull(kWest1, {-0.6, 0});
  play.frame();
  EXPECT_EQ(play.west().duels_won, 0);
}

}  // namespace
}  // namespace autoref::game
