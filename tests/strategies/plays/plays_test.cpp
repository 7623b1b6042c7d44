#include "strategies/plays/plays.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>

#include "tests/strategies/staged_play.hpp"

namespace autoref::strategies {
namespace {

struct Staged : StagedPlay {
  using StagedPlay::StagedPlay;

  void robots(int count) {
    for (int i = 0; i < count; ++i) world.own(i, {-2.5 + 0.5 * i, 1.0 - 0.35 * i});
  }
};

int count_of(const Staged& stage, const RoleAssignment& assignment, Role role) {
  int count = 0;
  for (int i = 0; i < stage.predicted.robots(); ++i)
    count += assignment.task(i).role == role ? 1 : 0;
  return count;
}

// The largest x of the positions at which robots are to stand; -10 if there are none.
double foremost_stand_m(const Staged& stage, const RoleAssignment& assignment) {
  double foremost_m = -10;
  for (int i = 0; i < stage.predicted.robots(); ++i) {
    if (assignment.task(i).role != Role::kStands) continue;
    foremost_m = std::max(foremost_m, assignment.task(i).waypoint.position_m.x());
  }
  return foremost_m;
}

TEST(RoleAssignment, GivesAPositionToTheNearestFreeRobot) {
  Staged stage(Play::kRunning);
  stage.world.own(0, {-2, 0}).own(1, {0, 1}).own(2, {1, 0});
  RoleAssignment assignment(stage.look());
  assignment.send_nearest({{0.8, 0}, {1, 0}});
  EXPECT_EQ(assignment.task(2).role, Role::kStands);
  assignment.send_nearest({{0.9, 0}, {1, 0}});
  EXPECT_EQ(assignment.task(1).role, Role::kStands);
  EXPECT_EQ(assignment.free_robots(), 1);
}

TEST(RoleAssignment, LeavesAPositionEmptyIfNoRobotIsFree) {
  Staged stage(Play::kRunning);
  RoleAssignment assignment(stage.look());
  assignment.send_nearest({{0, 0}, {1, 0}});
  EXPECT_EQ(assignment.nearest_free({0, 0}), -1);
}

class OpenPlayOf : public testing::TestWithParam<int> {};

// Two rows; every robot must have a role, and exactly one of them the ball.
void expect_a_role_for_everybody(int robots, double ball_x_m) {
  SCOPED_TRACE(fmt::format("ball at x = {} m", ball_x_m));
  Staged stage(Play::kRunning);
  for (int i = 0; i < robots; ++i) stage.world.own(i, {-2.5 + 0.3 * i, 1.0 - 0.12 * i});
  for (int i = 0; i < 6; ++i) stage.world.opponent(i, {2.5 - 0.4 * i, 0.3 * i - 1});
  stage.world.ball({ball_x_m, 0.2});
  const RoleAssignment assignment = stage.assignment(open_play);
  EXPECT_EQ(assignment.free_robots(), 0);
  EXPECT_EQ(count_of(stage, assignment, Role::kBall), 1);
}

TEST_P(OpenPlayOf, GivesEveryRobotARole) {
  expect_a_role_for_everybody(GetParam(), -1.5);
  expect_a_role_for_everybody(GetParam(), 0.5);
  expect_a_role_for_everybody(GetParam(), 2.0);
}

INSTANTIATE_TEST_SUITE_P(Robots, OpenPlayOf, testing::Range(2, kMaxRobots + 1),
                         testing::PrintToStringParamName());

class OpenPlayAsRobotsLeave : public testing::TestWithParam<int> {};

TEST_P(OpenPlayAsRobotsLeave, KeepsTheKeeperAndTheRobotAtTheBall) {
  Staged stage(Play::kRunning);
  stage.robots(GetParam());
  stage.world.opponent(0, {2, 0}).ball({1, 0});
  const RoleAssignment assignment = stage.assignment(open_play);
  EXPECT_EQ(assignment.task(0).role, Role::kKeeper);
  EXPECT_EQ(count_of(stage, assignment, Role::kBall), 1);
}

INSTANTIATE_TEST_SUITE_P(Robots, OpenPlayAsRobotsLeave, testing::Range(2, 7),
                         testing::PrintToStringParamName());

TEST(OpenPlay, SendsALoneRobotToABallInItsHalfOnlyIfItIsThereFirst) {
  Staged ours(Play::kRunning);
  ours.world.own(3, {-1.5, 0}).opponent(0, {2.5, 1}).ball({-1.1, 0});
  EXPECT_EQ(ours.assignment(open_play).task(0).role, Role::kBall);
  Staged far(Play::kRunning);
  far.world.own(3, {0, 0}).opponent(0, {2.5, 1}).ball({0.4, 0});
  EXPECT_EQ(far.assignment(open_play).task(0).role, Role::kKeeper);
  Staged theirs(Play::kRunning);
  theirs.world.own(3, {-2.5, 0}).opponent(0, {1.2, 0}).ball({1, 0});
  EXPECT_EQ(theirs.assignment(open_play).task(0).role, Role::kKeeper);
}

TEST(OpenPlay, EverybodyAttacksWithoutOpponents) {
  Staged stage(Play::kRunning);
  stage.robots(4);
  stage.world.ball({1, 0});
  const RoleAssignment assignment = stage.assignment(open_play);
  EXPECT_EQ(count_of(stage, assignment, Role::kKeeper), 0);
  EXPECT_EQ(count_of(stage, assignment, Role::kBall), 1);
  EXPECT_EQ(count_of(stage, assignment, Role::kReceiver), 3);
}

// Nobody else may touch a ball there.
TEST(OpenPlay, TheKeeperFetchesTheBallInItsAreaWithoutOpponents) {
  Staged stage(Play::kRunning);
  stage.robots(4);
  stage.world.ball({-2.8, 0});
  EXPECT_EQ(stage.assignment(open_play).task(0).role, Role::kBall);
}

// A single opponent keeps its goal, so nobody has to stand in a wall.
TEST(OpenPlay, NeedsNoWallAgainstASingleOpponent) {
  Staged stage(Play::kRunning);
  stage.robots(6);
  stage.world.opponent(0, {2.8, 0}).ball({1, 0});
  const RoleAssignment assignment = stage.assignment(open_play);
  EXPECT_EQ(count_of(stage, assignment, Role::kReceiver), 4);
}

TEST(OpenPlay, SendsTheKeeperToASlowBallInItsArea) {
  Staged stage(Play::kRunning);
  stage.robots(6);
  stage.world.opponent(0, {1, 0}).ball({-2.6, -0.3});
  const RoleAssignment assignment = stage.assignment(open_play);
  EXPECT_EQ(assignment.task(0).role, Role::kBall);
  EXPECT_EQ(count_of(stage, assignment, Role::kBall), 1);
}

TEST(OpenPlay, RunsForPassesInPossessionAndStaysBackOtherwise) {
  Staged ours(Play::kRunning);
  ours.robots(6);
  ours.world.opponent(0, {-2.5, -1.5}).ball({1, -0.8});
  const int with_ball = count_of(ours, ours.assignment(open_play), Role::kReceiver);
  Staged theirs(Play::kRunning);
  theirs.robots(6);
  theirs.world.opponent(0, {1.2, 1.5}).ball({1, 1.5});
  const int without_ball = count_of(theirs, theirs.assignment(open_play), Role::kReceiver);
  EXPECT_GT(with_ball, without_ball);
}

TEST(OpenPlay, CoversTheOwnGoalWithRobotsThatHaveNobodyToMark) {
  Staged stage(Play::kRunning);
  stage.robots(6);
  stage.world.ball({1.5, 0.5}).opponent(1, {1.59, 0.5});
  const RoleAssignment assignment = stage.assignment(open_play);
  ASSERT_FALSE(stage.predicted.is_ours());
  EXPECT_EQ(count_of(stage, assignment, Role::kReceiver), 0);
  EXPECT_LT(foremost_stand_m(stage, assignment), 1.0);
}

TEST(ChooseForBall, ChoosesTheRobotThatGetsThereFirst) {
  Staged stage(Play::kRunning);
  stage.world.own(0, {-2.8, 0}).own(1, {-1, 1}).own(2, {1, 1}).ball({1, 0});
  const RoleAssignment assignment(stage.look());
  EXPECT_EQ(choose_for_ball(stage.book, assignment), 2);
}

TEST(ChooseForBall, KeepsThePreviousRobotIfBothAreAboutAsNear) {
  Staged stage(Play::kRunning);
  stage.world.own(0, {-2.8, 0}).own(1, {0, 1.02}).own(2, {0, -1}).ball({0, 0});
  const RoleAssignment assignment(stage.look());
  EXPECT_EQ(choose_for_ball(stage.book, assignment), 2);
  stage.book.former = 1;
  EXPECT_EQ(choose_for_ball(stage.book, assignment), 1);
}

TEST(ChooseForBall, AvoidsARobotThatMustNotTouchTheBallAgain) {
  Staged stage(Play::kRunning);
  stage.world.own(0, {-2.8, 0}).own(1, {0.2, 0}).own(2, {-1, 0}).ball({0, 0});
  const RoleAssignment assignment(stage.look());
  EXPECT_EQ(choose_for_ball(stage.book, assignment), 1);
  stage.book.restarter = 1;
  EXPECT_EQ(choose_for_ball(stage.book, assignment), 2);
}

// Whether a robot with a task is sent to within 0.6 m of the opponent.
bool has_marker(const RoleAssignment& assignment, const Vec2& opponent_m) {
  for (int i = 0; i < 6; ++i) {
    const double off_m = (assignment.task(i).waypoint.position_m - opponent_m).norm();
    if (!assignment.is_free(i) && off_m < 0.6) return true;
  }
  return false;
}

TEST(Defend, SendsTheWallAndThenAMarkerToEachDangerousOpponent) {
  Staged stage(Play::kRunning);
  stage.robots(6);
  stage.world.ball({1, 0}).opponent(0, {1.2, 0}).opponent(1, {-1, -1.2}).opponent(2, {0, 1.5});
  RoleAssignment assignment(stage.look());
  defend(stage.book, assignment, 2, 4);
  EXPECT_EQ(assignment.free_robots(), 2);
  EXPECT_TRUE(has_marker(assignment, {-1, -1.2}));
  EXPECT_TRUE(has_marker(assignment, {0, 1.5}));
}

TEST(TakeRestart, IsGivenToTheFieldPlayerNearestToTheBall) {
  Staged stage(Play::kIndirectFree, true);
  stage.world.own(0, {1.1, 1}).own(1, {0, 0}).own(4, {0.7, 0.4}).own(5, {2, -1}).ball({1, 1});
  const RoleAssignment assignment = stage.assignment(take_restart);
  EXPECT_EQ(assignment.task(2).role, Role::kBall);
  EXPECT_EQ(count_of(stage, assignment, Role::kBall), 1);
}

TEST(TakeRestart, IsGivenToTheKeeperIfItIsAlone) {
  Staged stage(Play::kDirectFree, true);
  stage.world.own(5, {-2.8, 0}).ball({0, 1});
  EXPECT_EQ(stage.assignment(take_restart).task(0).role, Role::kBall);
}

// Whether a field player is sent between the ball and the own goal, near the ball.
bool is_path_to_goal_blocked(const RoleAssignment& assignment, const Vec2& ball_m) {
  const Vec2 goal_m = Field{}.goal_centre_m(Side::kWest);
  for (int i = 1; i < 6; ++i) {
    const Vec2& position_m = assignment.task(i).waypoint.position_m;
    if ((position_m - ball_m).norm() < 0.9 && distance_to_segment(position_m, ball_m, goal_m) < 0.1)
      return true;
  }
  return false;
}

TEST(AwaitRestart, BlocksTheBallsPathToTheOwnGoal) {
  Staged stage(Play::kDirectFree, false);
  stage.robots(6);
  const Vec2 ball_m(-0.5, 1.2);
  stage.world.opponent(0, {-0.4, 1.3}).ball(ball_m);
  const RoleAssignment assignment = stage.assignment(await_restart);
  EXPECT_TRUE(is_path_to_goal_blocked(assignment, ball_m));
  EXPECT_EQ(assignment.free_robots(), 0);
}

// The number of robots and whether the kick-off is the team's own.
class AwaitKickoff : public testing::TestWithParam<std::tuple<int, bool>> {};

TEST_P(AwaitKickoff, GivesEveryRobotASeparatePositionInTheOwnHalf) {
  const auto& [robots, ours] = GetParam();
  Staged stage(Play::kPrepareKickoff, ours);
  stage.robots(robots);
  const RoleAssignment assignment = stage.assignment(await_kickoff);
  EXPECT_EQ(assignment.free_robots(), 0);
  EXPECT_LE(foremost_stand_m(stage, assignment), -kRobotRadius_m);
}

INSTANTIATE_TEST_SUITE_P(Of, AwaitKickoff, testing::Combine(testing::Range(1, 9), testing::Bool()),
                         [](const auto& test) {
                           const bool ours = std::get<1>(test.param);
                           return (ours ? "OursWith" : "TheirsWith") +
                                  std::to_string(std::get<0>(test.param));
                         });

int sent_to_ball_at_penalty(Play play) {
  Staged stage(play, true);
  stage.robots(6);
  stage.world.ball(Field{}.penalty_mark_at(Side::kEast));
  const RoleAssignment assignment = stage.assignment(penalty);
  EXPECT_EQ(assignment.free_robots(), 0);
  return count_of(stage, assignment, Role::kBall);
}

TEST(Penalty, SendsARobotToTheBallOnlyOnceThePenaltyMayBeTaken) {
  EXPECT_EQ(sent_to_ball_at_penalty(Play::kPreparePenalty), 0);
  EXPECT_EQ(sent_to_ball_at_penalty(Play::kPenalty), 1);
}

TEST(ChooseForBall, LetsTheRobotThatHasTheBallGoOnWithIt) {
  Staged stage(Play::kRunning);
  stage.world.own(0, {-2.8, 0}).own(1, {0, 0}).own(2, {0.25, 0.05}).ball({kHeldBall_m, 0});
  const RoleAssignment assignment(stage.look());
  stage.book.former = 2;
  EXPECT_EQ(choose_for_ball(stage.book, assignment), 1);
}

}  // namespace
}  // namespace autoref::strategies
