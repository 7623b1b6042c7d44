#include "strategies/tactics/handle_ball.hpp"

#include <gtest/gtest.h>

#include "strategies/teams/playbooks.hpp"
#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {
namespace {

// A staged world and the ball handler in it.
struct StagedHandling : StagedPrediction {
  using StagedPrediction::StagedPrediction;

  // Decides often enough for all team-mates to be evaluated.
  RobotCommand play(int index, int frames = 12) {
    RobotCommand command;
    for (int i = 0; i < frames; ++i) {
      look(1);
      handler.update();
      command = handler.play(index);
    }
    return command;
  }
  // Does the same while the robot follows its commands and the ball stays where it is.
  RobotCommand drive(int index, double seconds) {
    RobotCommand command;
    for (int i = 0; i < seconds * 60; ++i) {
      command = play(index, 1);
      obey(world.view.own[static_cast<std::size_t>(index)], command);
    }
    return command;
  }
  // Does the same until the robot kicks the ball; returns whether it did.
  bool drive_until_kick(int index, double seconds) {
    for (int i = 0; i < seconds * 60; ++i) {
      const RobotCommand command = drive(index, kStagedFrame_s);
      const TrackedRobot& robot = world.view.own[static_cast<std::size_t>(index)];
      if (command.kick_mps > 0 && has_ball(robot, world.view.ball.position_m)) return true;
    }
    return false;
  }
  // Only observes.
  void watch(double seconds) {
    for (int i = 0; i < seconds * 60; ++i) {
      look(1);
      handler.update();
    }
  }

  BallHandler handler{predicted};
};

Vec2 ball_held_by(const Vec2& robot_m, double side = 1) {
  return robot_m + Vec2(side * kHeldBall_m, 0);
}

TEST(BallHandler, ShootsAtAnOpenGoal) {
  StagedHandling stage(Play::kRunning);
  stage.world.own(0, {-2.8, 0}).own(1, {1.5, 0}).own(2, {1, 1}).ball(ball_held_by({1.5, 0}));
  const RobotCommand command = stage.play(1);
  const Choice& choice = stage.handler.choice();
  EXPECT_EQ(choice.kind, Choice::Kind::kShot);
  EXPECT_LT((choice.strike.target_m - Field{}.goal_centre_m(Side::kEast)).norm(), 0.35);
  EXPECT_GT(command.kick_mps, 4);
}

TEST(BallHandler, KeepsTheKickSpeedLimitIfThereIsOne) {
  StagedHandling stage(Play::kRunning, false, team_context_of("2026-b"));
  stage.world.own(0, {-4, 0}).own(1, {3, 0}).ball(ball_held_by({3, 0}));
  EXPECT_LE(stage.play(1).kick_mps, 6.5);
}

// Two opponents block the goal for robot 1, which has the ball, and a third its lane to robot 3;
// robot 2 has an open goal.
void stage_a_pass(StagedWorld& world) {
  const Vec2 robot_m(1.5, -1.2);
  world.own(0, {-2.8, 0}).own(1, robot_m).own(2, {1.5, 0.9}).own(3, {0, -1.1});
  world.view.own[1].heading = {0, 1};
  world.opponent(0, {1.95, -0.9}).opponent(1, {1.85, -0.75}).opponent(2, {0.6, -1.1});
  world.ball(robot_m + Vec2(0, kHeldBall_m));
}

TEST(BallHandler, PassesToAFreeMateIfTheGoalIsBlocked) {
  StagedHandling stage(Play::kRunning);
  stage_a_pass(stage.world);
  const RobotCommand command = stage.play(1);
  EXPECT_EQ(stage.handler.choice().kind, Choice::Kind::kPass);
  EXPECT_EQ(stage.handler.receiver(), 2);
  EXPECT_GT(command.kick_mps, 1);
}

// Robot 1 has the ball and faces robot 2; behind it, robot 3 stands nearer to the goal. Opponents
// block its own shot, and one is `away_m` from the ball.
int receiver_of_pressed(double late_cost, double away_m) {
  Style style;
  style.carry = 0;
  style.turn_nll = 0;
  style.stopped_share = 1;
  style.contested_hold_s = 0;
  style.late_cost = late_cost;
  StagedHandling stage(Play::kRunning, false, {}, style);
  const Vec2 robot_m(1, 0);
  const Vec2 ball_m = robot_m + Vec2(0, kHeldBall_m);
  stage.world.own(0, {-2.8, 0}).own(1, robot_m).own(2, {0.7, 1.5}).own(3, {2, -1.2});
  stage.world.view.own[1].heading = {0, 1};
  stage.world.ball(ball_m).opponent(0, {2.8, 0.15}).opponent(1, {1.6, 0.05});
  stage.world.opponent(2, ball_m + Vec2(away_m, 0));
  stage.play(1);
  return stage.handler.choice().receiver;
}

TEST(BallHandler, PassesWhereItFacesIfThereIsNoTimeToTurn) {
  EXPECT_EQ(receiver_of_pressed(0.2, 0.25), 2);
  EXPECT_EQ(receiver_of_pressed(0.2, 1.5), 3);
  EXPECT_EQ(receiver_of_pressed(0, 0.25), 3);
}

// Opponents press robot 1 and block the goal and the lane to its only team-mate.
void stage_a_chip(StagedWorld& world) {
  const Vec2 lane(0.96, 0.28);
  const Vec2 ball_m = Vec2(0, 0.8) + kHeldBall_m * lane;
  world.own(0, {-2.8, 0}).own(1, {0, 0.8}).own(2, ball_m + 1.9 * lane).ball(ball_m);
  world.view.own[1].heading = lane;
  world.opponent(0, {2.9, 0}).opponent(1, ball_m + 0.5 * lane);
  world.opponent(2, {0.6, 0.68}).opponent(3, {0.05, 0.58});
}

TEST(BallHandler, ChipsOverARobotInTheLane) {
  StagedHandling stage(Play::kRunning);
  stage_a_chip(stage.world);
  const RobotCommand command = stage.play(1);
  EXPECT_EQ(stage.handler.choice().kind, Choice::Kind::kChip);
  EXPECT_EQ(stage.handler.choice().receiver, 2);
  EXPECT_TRUE(command.chip);
}

TEST(BallHandler, DoesNotChipWithRobotsThatCannotChip) {
  StagedHandling stage(Play::kRunning, false, context_without_chips());
  stage_a_chip(stage.world);
  const RobotCommand command = stage.play(1);
  EXPECT_NE(stage.handler.choice().kind, Choice::Kind::kChip);
  EXPECT_FALSE(command.chip);
}

// Robot 1 is pressed and its shot is blocked; robot 2 stands in the opponents' area and would have
// a free shot.
int receiver_in_area(const TeamContext& context) {
  Style style;
  style.carry = 0;
  StagedHandling stage(Play::kRunning, false, context, style);
  stage.world.own(0, {-4.3, 0}).own(1, {2, -2}).own(2, {3.6, 0.9}).own(3, {-1, 1});
  stage.world.view.own[1].heading = {0, 1};
  stage.world.ball(Vec2(2, -2) + Vec2(0, kHeldBall_m));
  stage.world.opponent(0, {4.4, 0}).opponent(1, {2.44, -1.58}).opponent(2, {2.22, -1.95});
  stage.play(1);
  return stage.handler.choice().receiver;
}

TEST(BallHandler, DoesNotPassToARobotThatMustNotTouchTheBall) {
  TeamContext context = team_context_of("2026-b");
  EXPECT_NE(receiver_in_area(context), 2);
  context.rules.in_force[RuleId::kAttackerTouchedBallInDefenseArea] = false;
  EXPECT_EQ(receiver_in_area(context), 2);
}

TEST(BallHandler, ForgetsTheReceiverOnceThePassMustHaveArrived) {
  StagedHandling stage(Play::kRunning);
  stage_a_pass(stage.world);
  stage.play(1);
  ASSERT_TRUE(stage.handler.receiver().has_value());
  stage.watch(4);
  EXPECT_FALSE(stage.handler.receiver().has_value());
}

TEST(BallHandler, ClearsTheBallUnderPressureWithNobodyToPassTo) {
  StagedHandling stage(Play::kRunning);
  const Vec2 robot_m(-2.2, 0.2);
  // The team-mate is too near for a pass.
  stage.world.own(3, robot_m).own(4, robot_m - Vec2(0.2, 0.1)).ball(ball_held_by(robot_m));
  const Vec2 presser_m = ball_held_by(robot_m) + Vec2(0.1, 0.14);
  stage.world.opponent(0, {2.9, 0}).opponent(1, presser_m);
  stage.play(0);
  const Choice& choice = stage.handler.choice();
  EXPECT_EQ(choice.kind, Choice::Kind::kClear);
  EXPECT_GT((choice.strike.target_m - ball_held_by(robot_m)).x(), 0.2);
  EXPECT_GT(choice.strike.kick_mps, 1);
}

// Its goal is empty meanwhile, so it neither carries the ball nor touches it gently.
TEST(BallHandler, ARobotWithoutTeamMatesKicksTheBallFarAway) {
  StagedHandling stage(Play::kRunning);
  stage.world.own(1, {-2, 0.5}).ball(ball_held_by({-2, 0.5}));
  stage.world.opponent(0, {2.9, 0}).opponent(1, {1, 1.5});
  stage.play(0);
  EXPECT_EQ(stage.handler.choice().kind, Choice::Kind::kShot);
  EXPECT_GT(stage.handler.choice().strike.kick_mps, 5);
}

TEST(BallHandler, CarriesTheBallIfItIsFreeButCannotShootOrPass) {
  StagedHandling stage(Play::kRunning);
  // The team-mate is too near for a pass.
  stage.world.own(1, {-1, 0.5}).own(2, {-1.2, 0.6}).ball(ball_held_by({-1, 0.5}));
  stage.world.opponent(0, {2.9, -0.1}).opponent(1, {2.9, 0.1}).opponent(2, {1, 1.5});
  const RobotCommand command = stage.play(0);
  EXPECT_EQ(stage.handler.choice().kind, Choice::Kind::kCarry);
  EXPECT_TRUE(command.dribble);
  EXPECT_EQ(command.kick_mps, 0);
}

TEST(BallHandler, StandsBetweenItsGoalAndAnOpponentWithTheBall) {
  StagedHandling stage(Play::kRunning);
  stage.world.own(0, {-2.9, 0}).own(1, {-1, 0.8}).opponent(0, {0, 0}).ball({-kHeldBall_m, 0});
  stage.drive(1, 3);
  const Vec2 ball_m(-kHeldBall_m, 0);
  const Vec2& robot_m = stage.world.view.own[1].position_m;
  EXPECT_LT(distance_to_segment(robot_m, ball_m, Field{}.goal_centre_m(Side::kWest)), 50_mm);
  EXPECT_LT((robot_m - ball_m).norm(), 0.25);
}

TEST(BallHandler, LeavesAFaceOffSideways) {
  StagedHandling stage(Play::kRunning);
  stage.world.own(0, {-2.9, 0}).own(1, {0, 0}).opponent(0, {2 * kHeldBall_m, 0});
  stage.world.ball({kHeldBall_m, 0});
  const RobotCommand command = stage.play(1);
  EXPECT_GT(std::abs(command.velocity_mps.y()), 0.3);
  EXPECT_TRUE(command.dribble);
  const RobotCommand next = stage.play(1, 3);
  EXPECT_GT(command.velocity_mps.y() * next.velocity_mps.y(), 0);  // the same side for a while
}

TEST(BallHandler, FetchesABallAtRestAndKicksItAtTheGoal) {
  StagedHandling stage(Play::kRunning);
  stage.world.own(0, {-2.9, 0}).own(1, {0.9, 0.9}).ball({0.5, 0});
  ASSERT_TRUE(stage.drive_until_kick(1, 4));
  const Vec2& ray = stage.world.view.own[1].heading;
  EXPECT_LT(std::abs(ray.y() / ray.x() * (3.025 - 0.5)), 0.35);
}

// Robot 1 drives towards the goal with the ball, at this speed, under the Laws of 2014, until it
// has dribbled it that far.
StagedHandling dribbled(double speed_mps, double path_m) {
  StagedHandling stage(Play::kRunning, false, team_context_of("2014"), cobalt_playbook().style);
  stage.world.own(0, {-2.8, 0}).own(1, {-1.5, 0}).opponent(0, {2.8, 0}).opponent(1, {1, 0.2});
  TrackedRobot& robot = stage.world.view.own[1];
  robot.velocity_mps = {speed_mps, 0};
  const double start_x = robot.position_m.x();
  while (robot.position_m.x() - start_x <= path_m) {
    stage.world.view.ball = {ball_held_by(robot.position_m), robot.velocity_mps};
    stage.play(1, 1);
    robot.position_m.x() += speed_mps * kStagedFrame_s;
  }
  return stage;
}

TEST(BallHandler, StopsCarryingEarlierTheFasterItIs) {
  EXPECT_EQ(dribbled(0.3, 0.25).handler.choice().kind, Choice::Kind::kCarry);
  EXPECT_NE(dribbled(2.4, 0.25).handler.choice().kind, Choice::Kind::kCarry);
}

TEST(BallHandler, KicksABallThatItMustReleaseFasterThanItDrives) {
  StagedHandling stage = dribbled(2.4, 0.3);
  stage.world.view.ball.position_m = ball_held_by(stage.world.view.own[1].position_m);
  EXPECT_GE(stage.play(1, 1).kick_mps, 3.3);
}

// What the taker of an indirect free kick before an open goal does.
Choice::Kind indirect_kick_under(const char* rules) {
  StagedHandling stage(Play::kIndirectFree, true, team_context_of(rules));
  stage.world.own(0, {-2.8, 0}).own(1, {1.4, 0}).own(2, {1, 1}).ball(ball_held_by({1.4, 0}));
  stage.play(1);
  return stage.handler.choice().kind;
}

TEST(BallHandler, ShootsFromAnIndirectFreeKickOnlyIfTheGoalCounts) {
  EXPECT_NE(indirect_kick_under("2014"), Choice::Kind::kShot);
  EXPECT_EQ(indirect_kick_under("paper"), Choice::Kind::kShot);
}

}  // namespace
}  // namespace autoref::strategies
