// How possession chains begin and end, and what is counted in them.
#include "game/play_counts/possession_chains.hpp"

#include <gtest/gtest.h>

#include "tests/game/play_counts/chain_play.hpp"

namespace autoref::game {
namespace {

using referee::Event;

TEST(PossessionChain, BeginsWithTheRestartThatTheTeamTakes) {
  using enum CommandKind;
  const std::pair<CommandKind, ChainStart> starts[] = {{kPrepareKickoff, ChainStart::kKickOff},
                                                       {kPreparePenalty, ChainStart::kPenalty},
                                                       {kDirectFree, ChainStart::kFreeKick},
                                                       {kIndirectFree, ChainStart::kFreeKick}};
  for (const auto& [kind, start] : starts) {
    ChainPlay play;
    play.stop();
    play.restart({kind, Side::kEast}, kEast1, {0, 0});
    EXPECT_EQ(play.last_start(), start);
    EXPECT_EQ(play.chains.back().team, Side::kEast);
  }
}

TEST(PossessionChain, BeginsWithTheCallThatLedToTheFreeKick) {
  using enum CommandKind;
  EXPECT_EQ(ChainPlay().start_after(Event::kThrowIn, kDirectFree), ChainStart::kThrowIn);
  EXPECT_EQ(ChainPlay().start_after(Event::kThrowIn, kIndirectFree), ChainStart::kThrowIn);
  EXPECT_EQ(ChainPlay().start_after(Event::kCornerKick, kDirectFree), ChainStart::kCornerKick);
  EXPECT_EQ(ChainPlay().start_after(Event::kGoalKick, kDirectFree), ChainStart::kGoalKick);
  EXPECT_EQ(ChainPlay().start_after(Event::kBotPushedBot, kDirectFree), ChainStart::kFreeKick);
}

TEST(PossessionChain, BeginsWithAFreeKickIfTheOtherTeamGetsThePlacedBall) {
  ChainPlay play;
  play.gain(kWest1, {0, 0});
  referee::Decision corner = ChainPlay::call(Event::kCornerKick);
  corner.finding.restart = {CommandKind::kDirectFree, Side::kEast};
  play.stop_by(corner);
  play.restart({CommandKind::kDirectFree, Side::kWest}, kWest1, {0, 0});
  EXPECT_EQ(play.last_start(), ChainStart::kFreeKick);
}

TEST(PossessionChain, BeginsWithALooseBallAfterAForceStart) {
  ChainPlay play;
  play.put(kWest2, {0, 1.2});
  play.stop();
  play.restart({CommandKind::kForceStart}, kEast1, {0, 1});
  EXPECT_EQ(play.last_start(), ChainStart::kLooseBall);
}

TEST(PossessionChain, BeginsInOpenPlayIfTheOpponentsTouchTheRestartFirst) {
  ChainPlay play;
  play.stop();
  play.put(kWest1, {0.1, 0});
  play.restart({CommandKind::kDirectFree, Side::kWest}, kEast1, {0, 0});
  EXPECT_EQ(play.last_start(), ChainStart::kDuel);
}

TEST(PossessionChain, BeginsWhereTheTeamInterceptsAKick) {
  ChainPlay play;
  play.kick(kWest1, {-1, 0}, {2, 2});
  play.frames(30);
  play.gain(kEast1, {0.5, 0});
  play.stop();
  ASSERT_EQ(play.chains.size(), 2U);
  EXPECT_EQ(play.chains[0].end, ChainEnd::kLost);
  EXPECT_EQ(play.chains[0].last_m, Vec2(0.5, 0));
  EXPECT_EQ(play.chains[1].team, Side::kEast);
  EXPECT_EQ(play.chains[1].start, ChainStart::kInterception);
  EXPECT_EQ(play.chains[1].first_m, Vec2(0.5, 0));
  EXPECT_EQ(play.chains[1].first_frame, play.chains[0].last_frame);
}

TEST(PossessionChain, BeginsInTheTeamsOwnDefenceAreaWithItsKeeper) {
  ChainPlay play;
  play.kick(kWest1, {1, 0}, {6, 0});
  play.frames(30);
  play.gain(kEast1, {2.9, 0});
  EXPECT_EQ(play.last_start(), ChainStart::kKeeper);
}

TEST(PossessionChain, BeginsWithADuelNextToAnOpponent) {
  ChainPlay play;
  play.put(kWest1, {0.15, 0});
  play.put(kEast1, {-0.15, 0});
  play.gain(kWest1, {0, 0});
  play.gain(kEast1, {0, 0});
  EXPECT_EQ(play.last_start(), ChainStart::kDuel);
}

TEST(PossessionChain, BeginsWithALooseBallIfNoOpponentIsNear) {
  ChainPlay play;
  play.put(kWest1, {-2, 0});
  play.gain(kWest1, {0, 0});
  play.gain(kEast1, {0.5, 0});
  EXPECT_EQ(play.last_start(), ChainStart::kLooseBall);
}

TEST(PossessionChain, GoesOnAfterAnOpponentsSingleTouch) {
  ChainPlay play;
  play.gain(kWest1, {0, 0});
  play.hull(kEast1, {0.5, 0});
  play.frames(30);
  play.gain(kWest2, {0, 0.5});
  play.stop();
  ASSERT_EQ(play.chains.size(), 1U);
  EXPECT_EQ(play.chains[0].team, Side::kWest);
}

TEST(PossessionChain, EndsWithAnOpponentsKick) {
  ChainPlay play;
  play.gain(kWest1, {0, 0});
  play.kick(kEast1, {0.5, 0}, {-3, 0});
  play.frames(2);
  ASSERT_EQ(play.chains.size(), 1U);
  EXPECT_EQ(play.chains[0].end, ChainEnd::kLost);
}

TEST(PossessionChain, EndsWithTheCallThatStopsPlay) {
  const std::pair<referee::Decision, ChainEnd> ends[] = {
      {ChainPlay::call(Event::kThrowIn), ChainEnd::kOut},
      {ChainPlay::call(Event::kAimlessKick, Side::kWest), ChainEnd::kOut},
      {ChainPlay::call(Event::kBotDribbledBallTooFar, Side::kWest), ChainEnd::kFoul},
      {ChainPlay::call(Event::kBotPushedBot, Side::kEast), ChainEnd::kFouled},
      {ChainPlay::call(Event::kHalfOver), ChainEnd::kWhistle}};
  for (const auto& [decision, end] : ends) {
    ChainPlay play;
    play.gain(kWest1, {0, 0});
    play.stop_by(decision);
    ASSERT_EQ(play.chains.size(), 1U);
    EXPECT_EQ(play.chains[0].end, end) << name_of(end);
    play.signal_play();
    play.gain(kWest1, {0, 0});
    play.stop();
    EXPECT_EQ(play.chains[1].end, ChainEnd::kWhistle) << "after " << name_of(end);
  }
}

TEST(PossessionChain, EndsWithAGoalAfterAParry) {
  ChainPlay play;
  play.put(kWest2, {1, 0});
  play.kick(kWest1, {-0.5, 0}, {4, 0});
  play.frames(20);
  play.kick(kWest2, {1, 0}, {6, 0});
  play.frames(20);
  play.hull(kEast1, {2.9, 0});
  play.frame();
  play.goal_of(Side::kWest);
  ASSERT_EQ(play.chains.size(), 1U);
  EXPECT_EQ(play.chains[0].end, ChainEnd::kGoal);
  EXPECT_EQ(play.chains[0].passes, 1);
  EXPECT_EQ(play.chains[0].shots, 1);
  const ChainCounts once{.chains = 1, .shots = 1, .goals = 1, .xg = play.shots[0].chance};
  EXPECT_EQ(play.west().by_start[static_cast<std::size_t>(ChainStart::kLooseBall)], once);
  EXPECT_EQ(play.west().with_pass, once);
  EXPECT_EQ(play.east().by_start, PlayCounts{}.by_start);
}

TEST(PossessionChain, EndsWithAShotIfNothingFollows) {
  ChainPlay play;
  play.kick(kWest1, {1, 0}, {6, 0});
  play.frames(30);
  play.hull(kEast1, {2.9, 0});
  play.frame();
  play.stop_by(ChainPlay::call(Event::kCornerKick));
  ASSERT_EQ(play.chains.size(), 1U);
  EXPECT_EQ(play.chains[0].end, ChainEnd::kShot);
  EXPECT_EQ(play.chains[0].shots, 1);
  EXPECT_EQ(play.west().with_pass, ChainCounts{});
}

TEST(PossessionChain, EndsWithAShotIfTheOpponentsGainTheBall) {
  ChainPlay play;
  play.kick(kWest1, {1, 0}, {6, 0});
  play.frames(30);
  play.gain(kEast1, {2.9, 0});
  ASSERT_EQ(play.chains.size(), 1U);
  EXPECT_EQ(play.chains[0].end, ChainEnd::kShot);
}

TEST(PossessionChain, EndsWithAnOwnGoalOfTheTeamWithTheBall) {
  ChainPlay play;
  play.gain(kWest1, {-2, 0});
  play.goal_of(Side::kEast);
  ASSERT_EQ(play.chains.size(), 1U);
  EXPECT_EQ(play.chains[0].end, ChainEnd::kOwnGoal);
  EXPECT_EQ(play.west().own_goals, 1);
  EXPECT_EQ(play.east().by_start, PlayCounts{}.by_start);
}

TEST(PossessionChain, IsTheScorersIfTheyTouchedTheBallLast) {
  ChainPlay play;
  play.gain(kWest1, {-2, 0});
  play.hull(kEast1, {-2, 0});
  play.frame();
  play.goal_of(Side::kEast);
  ASSERT_EQ(play.chains.size(), 2U);
  EXPECT_EQ(play.chains[0].end, ChainEnd::kLost);
  EXPECT_EQ(play.chains[0].shots, 0);
  EXPECT_EQ(play.chains[1].team, Side::kEast);
  EXPECT_EQ(play.chains[1].shots, 1);
  EXPECT_EQ(play.chains[1].end, ChainEnd::kGoal);
}

// The call of a referee beside a person stops play, and its command names no team.
TEST(PossessionChain, EndsWithTheGoalOfTheTeamThatDoesNotKickOff) {
  ChainPlay play;
  play.gain(kEast1, {-2, 0});
  referee::Decision goal = ChainPlay::call(Event::kGoal);
  goal.finding.restart = {CommandKind::kPrepareKickoff, Side::kWest};
  play.stop_by(goal);
  ASSERT_EQ(play.chains.size(), 1U);
  EXPECT_EQ(play.chains[0].end, ChainEnd::kGoal);
  EXPECT_EQ(play.east().own_goals, 0);
  EXPECT_EQ(play.east().shots_on_goal, 1);
}

TEST(PossessionChain, IsNotChangedByTouchesInTheGoal) {
  ChainPlay play;
  play.kick(kWest1, {1, 0}, {6, 0});
  play.frames(30);
  play.gain(kEast1, {3.1, 0});
  play.gain(kWest2, {3.1, 0});
  play.goal_of(Side::kWest);
  ASSERT_EQ(play.chains.size(), 1U);
  EXPECT_EQ(play.chains[0].end, ChainEnd::kGoal);
  EXPECT_EQ(play.chains[0].shots, 1);
}

TEST(Shot, HasScoredIfAGoalFollowsWithoutAnotherTouchByTheTeam) {
  ChainPlay play;
  play.kick(kWest1, {1, 0}, {6, 0});
  play.frames(20);
  play.hull(kEast1, {2.9, 0});
  play.frames(20);
  play.kick(kWest2, {2, 0}, {6, 0.5});
  play.frames(10);
  play.hull(kEast1, {2.95, 0.1});
  play.frame();
  play.goal_of(Side::kWest);
  ASSERT_EQ(play.shots.size(), 2U);
  EXPECT_FALSE(play.shots[0].has_scored);
  EXPECT_TRUE(play.shots[1].has_scored);
  for (const Shot& shot : play.shots) {
    ASSERT_TRUE(shot.situation);
    EXPECT_EQ(shot.chance, chance_model("paper").chance(*shot.situation));
    EXPECT_EQ(shot.chance_on_target, chance_model("paper").chance_on_target(*shot.situation));
  }
  EXPECT_EQ(play.shots[1].from_m, Vec2(2, 0));
  EXPECT_DOUBLE_EQ(play.west().xg, play.shots[0].chance + play.shots[1].chance);
  EXPECT_DOUBLE_EQ(play.chains[0].xg, play.west().xg);
}

TEST(Shot, HasNotScoredIfTheKeeperHoldsIt) {
  ChainPlay play;
  play.kick(kWest1, {1, 0}, {6, 0});
  play.frames(20);
  play.gain(kEast1, {2.9, 0});
  ASSERT_EQ(play.shots.size(), 1U);
  EXPECT_FALSE(play.shots[0].has_scored);
}

TEST(Shot, IsCertainIfTheBallIsPushedIntoTheGoal) {
  ChainPlay play;
  play.gain(kWest1, {2.9, 0});
  play.goal_of(Side::kWest);
  ASSERT_EQ(play.shots.size(), 1U);
  EXPECT_FALSE(play.shots[0].situation);
  EXPECT_TRUE(play.shots[0].has_scored);
  EXPECT_EQ(play.west().xg, 1);
  EXPECT_EQ(play.west().xgot, 1);
}

}  // namespace
}  // namespace autoref::game
