#include "strategies/plays/formation_spots.hpp"

#include <gtest/gtest.h>

#include "tests/strategies/staged_play.hpp"

namespace autoref::strategies {
namespace {

FormationSpot spot(int key, const Vec2& position_m) { return {key, {position_m, Vec2(1, 0)}}; }

// Index of the robot that the assignment sends to the position; -1: none.
int who_goes_to(const StagedPlay& stage, const RoleAssignment& assignment, const Vec2& position_m) {
  for (int i = 0; i < stage.predicted.robots(); ++i) {
    const Task& task = assignment.task(i);
    if (task.role == Role::kStands && task.waypoint.position_m == position_m) return i;
  }
  return -1;
}

const Vec2 kNorth_m(0, 1);
const Vec2 kSouth_m(0, -1);
const FormationSpots kNorthAndSouth = {spot(1, kNorth_m), spot(2, kSouth_m)};

// Two robots at the two spots, with the ball far away.
struct TwoRobots : StagedPlay {
  TwoRobots() : StagedPlay(Play::kRunning) {
    world.own(3, {0, 0.9}).own(5, {0, -0.9}).ball({-2, 0});
    look();
  }
  void move(std::size_t index, const Vec2& position_m) {
    world.view.own[index].position_m = position_m;
    look();
  }
  RoleAssignment man(const FormationSpots& spots = kNorthAndSouth) {
    RoleAssignment assignment(predicted);
    fill_spots(book, assignment, spots);
    return assignment;
  }
};

TEST(FillSpots, SendsTheNearestRobotToEachSpot) {
  TwoRobots stage;
  const RoleAssignment assignment = stage.man();
  EXPECT_EQ(who_goes_to(stage, assignment, kNorth_m), 0);
  EXPECT_EQ(who_goes_to(stage, assignment, kSouth_m), 1);
}

TEST(FillSpots, FillsTheMostImportantSpotsFirst) {
  TwoRobots stage;
  const RoleAssignment assignment =
      stage.man({spot(1, {2, 0}), spot(2, {1, 0}), spot(3, kNorth_m)});
  EXPECT_NE(who_goes_to(stage, assignment, {2, 0}), -1);
  EXPECT_NE(who_goes_to(stage, assignment, {1, 0}), -1);
  EXPECT_EQ(who_goes_to(stage, assignment, kNorth_m), -1);
}

TEST(FillSpots, LeavesRobotsAtTheirSpotsIfASwapWouldSaveLittle) {
  TwoRobots stage;
  stage.man();
  stage.move(0, {0, -0.1});
  stage.move(1, {0, 0.1});  // a swap would save 0.4 m in total
  EXPECT_EQ(who_goes_to(stage, stage.man(), kNorth_m), 0);
}

TEST(FillSpots, SwapsRobotsIfThatSavesALongPath) {
  TwoRobots stage;
  stage.man();
  stage.move(0, kSouth_m);
  stage.move(1, kNorth_m);
  EXPECT_EQ(who_goes_to(stage, stage.man(), kNorth_m), 1);
}

TEST(FillSpots, LetsARobotFollowItsSpotPastTheOthers) {
  TwoRobots stage;
  stage.man();
  const Vec2 moved_m(0.2, -1.2);  // closer to the other robot
  const RoleAssignment assignment = stage.man({spot(1, moved_m), spot(2, {0.2, -0.6})});
  EXPECT_EQ(who_goes_to(stage, assignment, moved_m), 0);
}

TEST(FillSpots, GivesTheSpotOfARobotWithAnotherRoleToAFreeRobot) {
  TwoRobots stage;
  stage.world.own(7, {0, 1.8});
  stage.man();
  RoleAssignment assignment(stage.look());
  assignment.give(0, Role::kBall);
  fill_spots(stage.book, assignment, kNorthAndSouth);
  EXPECT_EQ(who_goes_to(stage, assignment, kNorth_m), 2);
  EXPECT_EQ(who_goes_to(stage, stage.man(), kNorth_m),
            2);  // even after the other robot is free again
}

TEST(FillOwnSpots, KeepsTheSpotOfTheRobotAtTheBallAndLeavesItEmpty) {
  TwoRobots stage;
  stage.world.own(7, {0, 1.8});
  RoleAssignment before(stage.look());
  fill_own_spots(stage.book, before, kNorthAndSouth);
  ASSERT_EQ(who_goes_to(stage, before, kNorth_m), 0);
  RoleAssignment assignment(stage.look());
  assignment.give(0, Role::kBall);
  fill_own_spots(stage.book, assignment, kNorthAndSouth);
  EXPECT_EQ(who_goes_to(stage, assignment, kNorth_m), -1);
  EXPECT_TRUE(assignment.is_free(2));
}

TEST(FillOwnSpots, ReturnsTheRobotFromTheBallToItsOwnSpot) {
  TwoRobots stage;
  const FormationSpots spots = {spot(1, kNorth_m), spot(2, kSouth_m), spot(3, {1, 0})};
  RoleAssignment before(stage.look());
  fill_own_spots(stage.book, before, spots);
  stage.move(0, {0.9, 0});
  RoleAssignment meanwhile(stage.predicted);
  meanwhile.give(0, Role::kBall);
  fill_own_spots(stage.book, meanwhile, spots);
  RoleAssignment after(stage.look());
  fill_own_spots(stage.book, after, spots);
  EXPECT_EQ(who_goes_to(stage, after, kNorth_m), 0);
}

TEST(FillOwnSpots, GivesTheRobotAtTheBallTheNearestSpotFromTheStart) {
  TwoRobots stage;
  stage.world.own(7, {0, -1.8});
  RoleAssignment first(stage.look());
  first.give(1, Role::kBall);
  fill_own_spots(stage.book, first, kNorthAndSouth);
  EXPECT_EQ(who_goes_to(stage, first, kNorth_m), 0);
  EXPECT_EQ(who_goes_to(stage, first, kSouth_m), -1);
  EXPECT_TRUE(first.is_free(2));
}

TEST(FillOwnSpots, LeavesTheRobotsOfTheLastSpotsFree) {
  TwoRobots stage;
  RoleAssignment assignment(stage.look());
  fill_own_spots(stage.book, assignment, kNorthAndSouth, 1);
  EXPECT_EQ(who_goes_to(stage, assignment, kNorth_m), 0);
  EXPECT_TRUE(assignment.is_free(1));
}

TEST(SendAhead, LetsTheRobotsFarthestAheadRunForPasses) {
  StagedPlay stage(Play::kRunning);
  stage.world.own(1, {-1, 1}).own(2, {1, 1}).own(3, {-2, 0}).own(4, {0.5, -1}).ball({-1.5, 0});
  stage.watch();
  RoleAssignment assignment(stage.predicted);
  send_ahead(stage.book, assignment, 2);
  EXPECT_EQ(assignment.task(1).role, Role::kReceiver);
  EXPECT_EQ(assignment.task(3).role, Role::kReceiver);
  EXPECT_EQ(assignment.free_robots(), 2);
}

TEST(SendAhead, SendsAllFreeRobotsIfThereAreTooFew) {
  StagedPlay stage(Play::kRunning);
  stage.world.own(1, {-1, 1}).own(2, {1, 1}).ball({-1.5, 0});
  stage.watch();
  RoleAssignment assignment(stage.predicted);
  assignment.give(0, Role::kBall);
  send_ahead(stage.book, assignment, 5);
  EXPECT_EQ(assignment.task(0).role, Role::kBall);
  EXPECT_EQ(assignment.task(1).role, Role::kReceiver);
}

class OffTheirAreaUnder : public testing::TestWithParam<const char*> {};

// How far a position in the area is moved away from it, beyond the required distance.
double extra_off_their_area_m(const PredictedState& predicted, double more_m) {
  const Vec2 position_m = predicted.field().goal_centre_m(Side::kEast) - Vec2(0.5, 0.3);
  const double least_m =
      predicted.rules().attacker_to_area_m + kRobotRadius_m + room_for_error_m(predicted.rules());
  const Vec2 p = off_their_area(predicted, position_m, more_m).position_m;
  return distance_to_defence_area(predicted.field(), Side::kEast, p) - least_m;
}

TEST_P(OffTheirAreaUnder, KeepsAPositionThisFarFromTheAreaPlusAnExtraDistance) {
  StagedPrediction stage(Play::kRunning, false, team_context_of(GetParam()));
  const PredictedState& predicted = stage.look();
  EXPECT_NEAR(extra_off_their_area_m(predicted, 0), 30_mm, 30_mm);
  EXPECT_NEAR(extra_off_their_area_m(predicted, 0.25), 0.25 + 30_mm, 30_mm);
}

INSTANTIATE_TEST_SUITE_P(Books, OffTheirAreaUnder, testing::Values("paper", "2026-b"),
                         name_of_rule_book);

}  // namespace
}  // namespace autoref::strategies
