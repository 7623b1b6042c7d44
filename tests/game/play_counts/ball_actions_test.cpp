#include "game/play_counts/ball_actions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

#include "tests/game/play_counts/chain_play.hpp"

namespace autoref::game {
namespace {

const Vec2 kMidfield_m{0, 0};
const Vec2 kNearGoal_m{2, 0};  // west attacks the goal at +x

struct ActionPlay : ChainPlay {
  ActionPlay() {
    put(kWest1, kMidfield_m);
    put(kWest2, {1.5, 0.5});
    put(kEast1, {2.8, 0});
    put(kEast2, {0, 1.5});
  }

  // West's robot 2 shoots, and east's robot 1 parries.
  void shoot_at_keeper() {
    put(kWest2, kNearGoal_m);
    gain(kWest2, kNearGoal_m);
    kick(kWest2, kNearGoal_m, {6, 0});
    frames(8);
    hull(kEast1, {2.7, 0});
  }

  std::vector<std::tuple<Side, int, ActionKind>> kinds() const {
    std::vector<std::tuple<Side, int, ActionKind>> kinds;
    for (const BallAction& action : actions)
      kinds.emplace_back(action.team, action.robot, action.kind);
    return kinds;
  }

  double worth_to_west() const {
    return std::accumulate(actions.begin(), actions.end(), 0.0,
                           [](double sum, const BallAction& action) {
                             const bool is_west = action.team == Side::kWest;
                             return sum + (is_west ? action.worth : -action.worth);
                           });
  }

  double value_to_west(const BallOwner& owner) const {
    const SituationValue value =
        value_model("paper").value(value_features(owner, now, Field{}), {});
    const double of_owner = value.scores - value.concedes;
    return owner.team == Side::kWest ? of_owner : -of_owner;
  }
  // East's free kick from the position of the ball.
  static referee::Decision free_kick_for_east(referee::Event event, std::optional<Side> offender) {
    referee::Decision decision = call(event, offender);
    decision.finding.restart = {CommandKind::kDirectFree, Side::kEast};
    return decision;
  }
};

using Kinds = std::vector<std::tuple<Side, int, ActionKind>>;

TEST(BallActions, AnActionBeginsWhereThePreviousOneEnds) {
  ActionPlay play;
  play.gain(kWest1, kMidfield_m);
  play.kick_to(kWest1, kMidfield_m, {3, 1}, kWest2, {1.5, 0.5});
  play.kick_to(kWest2, {1.5, 0.5}, {-1.5, 1.0}, kEast2, {0, 1.5});
  play.frames(10);
  play.hull(kEast2, {0, 1.5});
  play.frame();
  EXPECT_EQ(play.kinds(), (Kinds{{Side::kWest, 1, ActionKind::kDribble},
                                 {Side::kWest, 1, ActionKind::kPass},
                                 {Side::kWest, 2, ActionKind::kDribble},
                                 {Side::kWest, 2, ActionKind::kLoss}}));
  for (std::size_t i = 1; i < play.actions.size(); ++i) {
    EXPECT_EQ(play.actions[i].first_frame, play.actions[i - 1].last_frame);
    EXPECT_EQ(play.actions[i].first_m, play.actions[i - 1].last_m);
  }
}

TEST(BallActions, APassTowardsTheGoalHelpsAndALossHarms) {
  ActionPlay play;
  play.gain(kWest1, kMidfield_m);
  play.kick_to(kWest1, kMidfield_m, {3, 1}, kWest2, {1.5, 0.5});
  ASSERT_EQ(play.actions.size(), 2);
  EXPECT_GT(play.actions[1].worth, 0);
  play.put(kEast1, {1.6, 0.5});
  play.gain(kEast1, {1.5, 0.5});
  ASSERT_EQ(play.actions.size(), 3);
  EXPECT_EQ(play.actions[2].kind, ActionKind::kLoss);
  EXPECT_LT(play.actions[2].worth, 0);
}

TEST(BallActions, WorthsAddUpToTheGoalWithoutWhatTheRestartWasWorth) {
  ActionPlay play;
  play.stop_by(ChainPlay::call(referee::Event::kNoProgressInGame));
  play.decide(ChainPlay::decision_of(referee::Event::kReady,
                                     Command{CommandKind::kDirectFree, Side::kWest}));
  play.signal_play();
  const double restart = play.value_to_west({Side::kWest, true});
  play.kick_to(kWest1, kMidfield_m, {3, 1}, kWest2, {1.5, 0.5});
  play.put(kEast2, {1.6, 0.5});
  play.gain(kEast2, {1.5, 0.5});
  play.put(kWest2, kNearGoal_m);
  play.gain(kWest2, kNearGoal_m);
  play.kick(kWest2, kNearGoal_m, {6, 0});
  play.frames(10);
  play.goal_of(Side::kWest);
  EXPECT_EQ(play.actions.back().kind, ActionKind::kShot);
  EXPECT_GT(play.actions.back().worth, 0);
  EXPECT_NEAR(play.worth_to_west(), 1 - restart, 1e-12);
}

TEST(BallActions, ABallPushedAheadStaysADribble) {
  ActionPlay play;
  play.gain(kWest1, kMidfield_m);
  play.kick(kWest1, kMidfield_m, {1.2, 0});
  play.frames(30);
  play.gain(kWest1, {0.5, 0});
  play.put(kEast1, {0.6, 0});
  play.gain(kEast1, {0.6, 0});
  // The kick ends the first dribble, since it may become a pass.
  EXPECT_EQ(play.kinds(),
            (Kinds{{Side::kWest, 1, ActionKind::kDribble}, {Side::kWest, 1, ActionKind::kLoss}}));
}

TEST(BallActions, AParryDoesNotEndTheShot) {
  ActionPlay play;
  play.shoot_at_keeper();
  play.frames(3);
  EXPECT_EQ(play.actions.size(), 1);  // the dribble before the shot
  play.gain(kWest1, {2.2, 0.3});
  EXPECT_EQ(play.kinds(),
            (Kinds{{Side::kWest, 2, ActionKind::kDribble}, {Side::kWest, 2, ActionKind::kShot}}));
}

TEST(BallActions, AReboundToTheShooterIsANewAction) {
  ActionPlay play;
  play.shoot_at_keeper();
  play.frames(8);
  play.gain(kWest2, kNearGoal_m);
  play.put(kEast2, kNearGoal_m);
  play.gain(kEast2, kNearGoal_m);
  EXPECT_EQ(play.kinds(), (Kinds{{Side::kWest, 2, ActionKind::kDribble},
                                 {Side::kWest, 2, ActionKind::kShot},
                                 {Side::kWest, 2, ActionKind::kLoss}}));
}

TEST(BallActions, ABallIsLostAtTheFirstTouchOfTheTeamThatGainsIt) {
  ActionPlay play;
  play.gain(kWest1, kMidfield_m);
  play.kick_to(kWest1, kMidfield_m, {3, 1}, kEast1, {1.5, 0.5});
  play.frames(60);
  play.gain(kEast2, {0.5, 1.0});
  const PossessionChain& chain = play.chains.back();
  EXPECT_EQ(play.kinds(), (Kinds{{Side::kWest, 1, ActionKind::kDribble},
                                 {Side::kWest, 1, ActionKind::kLoss},
                                 {Side::kEast, 1, ActionKind::kDribble}}));
  EXPECT_EQ(play.actions[1].last_frame, chain.last_frame);
  EXPECT_EQ(play.actions[1].last_m, chain.last_m);
}

TEST(BallActions, ASingleTouchThatBecomesAGoalIsAShot) {
  for (const Side owner : kSides) {
    ActionPlay play;
    const RobotId holder = owner == Side::kWest ? kWest1 : kEast1;
    const RobotId other = owner == Side::kWest ? kEast2 : kWest2;
    play.gain(holder, kMidfield_m);
    play.kick_to(holder, kMidfield_m, {goal_sign(owner) * -2, 0}, other, {0.8, 0.2});
    play.frames(20);
    play.goal_of(other.side);
    ASSERT_EQ(play.actions.size(), 3U);
    EXPECT_EQ(play.actions[1].kind, ActionKind::kLoss);
    EXPECT_EQ(play.actions[2].kind, ActionKind::kShot);
    EXPECT_EQ(play.actions[2].team, other.side);
    EXPECT_EQ(play.actions[2].robot, other.number);
    EXPECT_GT(play.actions[2].worth, 0.5);
  }
}

TEST(BallActions, AnOwnGoalIsALoss) {
  ActionPlay play;
  play.gain(kEast1, {2.8, 0});
  const double before = play.value_to_west({Side::kEast});
  play.goal_of(Side::kWest);
  EXPECT_EQ(play.kinds(), (Kinds{{Side::kEast, 1, ActionKind::kLoss}}));
  EXPECT_NEAR(play.actions[0].worth, before - 1, 0.2);
}

TEST(BallActions, AFoulByBothTeamsIsNobodys) {
  ActionPlay play;
  play.gain(kEast1, kMidfield_m);
  play.stop_by(ChainPlay::call(referee::Event::kBotPushedBot));
  EXPECT_EQ(play.kinds(), (Kinds{{Side::kEast, 1, ActionKind::kDribble}}));
}

TEST(BallActions, AFoulDuringAStopCostsTheRestart) {
  ActionPlay play;
  play.gain(kWest1, kMidfield_m);
  referee::Decision out = ChainPlay::call(referee::Event::kThrowIn);
  out.finding.restart = {CommandKind::kDirectFree, Side::kWest};
  play.stop_by(out);
  referee::Decision foul =
      ActionPlay::free_kick_for_east(referee::Event::kAttackerStaysNearArea, Side::kWest);
  foul.from = referee::State::kWaitStop;
  play.stop_by(foul);
  ASSERT_EQ(play.actions.back().kind, ActionKind::kFoul);
  EXPECT_NEAR(play.actions.back().worth,
              play.value_to_west({Side::kEast, true}) - play.value_to_west({Side::kWest, true}),
              1e-12);
}

TEST(BallActions, AFoulCostsItsTeamWhatTheRestartChanges) {
  ActionPlay play;
  play.gain(kWest1, kNearGoal_m);
  const double before = play.value_to_west({Side::kWest});
  referee::Decision foul =
      ActionPlay::free_kick_for_east(referee::Event::kBotPushedBot, Side::kWest);
  foul.finding.robots = {kWest2};
  play.stop_by(foul);
  EXPECT_EQ(play.kinds(),
            (Kinds{{Side::kWest, 1, ActionKind::kDribble}, {Side::kWest, 2, ActionKind::kFoul}}));
  EXPECT_NEAR(play.actions.back().worth, play.value_to_west({Side::kEast, true}) - before, 1e-12);
  EXPECT_LT(play.actions.back().worth, 0);
}

TEST(BallActions, ABallOutIsALossUnlessTheTeamKeepsIt) {
  for (const Side kicker : kSides) {
    ActionPlay play;
    play.gain(kWest1, kMidfield_m);
    referee::Decision out = ChainPlay::call(referee::Event::kThrowIn);
    out.finding.restart = {CommandKind::kDirectFree, kicker};
    play.stop_by(out);
    ASSERT_EQ(play.actions.size(), 1);
    EXPECT_EQ(play.actions[0].kind,
              kicker == Side::kWest ? ActionKind::kDribble : ActionKind::kLoss);
  }
}

TEST(BallActions, CountsAreSumsOverActions) {
  ActionPlay play;
  play.gain(kWest1, kMidfield_m);
  play.kick_to(kWest1, kMidfield_m, {3, 1}, kWest2, {1.5, 0.5});
  play.put(kEast1, {1.6, 0.5});
  play.gain(kEast1, {1.5, 0.5});
  PlayCounts west;
  for (const BallAction& action : play.actions) {
    ++counts_of(west, action.kind).actions;
    counts_of(west, action.kind).worth += action.worth;
  }
  EXPECT_EQ(counts_of(west, ActionKind::kPass).actions, 1);
  EXPECT_EQ(play.west().by_action, west.by_action);
  EXPECT_EQ(play.east().by_action, PlayCounts{}.by_action);
}

}  // namespace
}  // namespace autoref::game
