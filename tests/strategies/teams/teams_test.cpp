// The characteristic behaviour of each team.
#include <gtest/gtest.h>

#include <algorithm>

#include "soccer/robot_shape.hpp"
#include "strategies/registry.hpp"
#include "strategies/tactics/handle_ball.hpp"
#include "strategies/teams/playbooks.hpp"
#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {
namespace {

std::unique_ptr<Strategy> make(std::string_view name) { return find_strategy(name)->make({}); }

// Six against six; the opponents have the ball, and robot 1 is the nearest to it.
StagedWorld theirs_at(const Vec2& ball_m) {
  StagedWorld world(Play::kRunning);
  world.own(0, {-2.9, 0}).own(1, ball_m - Vec2(0.5, 0));
  for (int i = 2; i < 6; ++i) world.own(i, {-1.2, 1.4 - 0.7 * (i - 2)});
  world.opponent(0, {2.9, 0}).opponent(1, ball_m + Vec2(0.1, 0));
  world.view.ball.position_m = ball_m;
  return world;
}

double distance_m(const TrackedRobot& robot, const Vec2& point_m) {
  return (robot.position_m - point_m).norm();
}

// The same with the ball at robot 1's front, and no opponent nearby.
StagedWorld ours_at(const Vec2& ball_m) {
  StagedWorld world = theirs_at(ball_m);
  world.view.opponents[1].position_m = {2, 1.7};
  world.view.own[1].position_m = ball_m - Vec2(kHeldBall_m, 0);
  return world;
}

// The number of the team's robots ahead of `x_m`.
auto ahead_of(const StagedWorld& world, double x_m) {
  const auto& own = world.view.own;
  return std::count_if(own.begin(), own.end(),
                       [&](const TrackedRobot& robot) { return robot.position_m.x() > x_m; });
}

// Number of the team-mate to which a robot with that playbook passes: robot 2 is safe beside it;
// robot 3 is far ahead, with an opponent near the lane. No robot can chip.
int passes_to(const TeamPlaybook& playbook) {
  StagedPrediction stage(Play::kRunning, false, context_without_chips(), playbook.style);
  BallHandler handler(stage.predicted);
  stage.world.own(0, {-2.9, 0}).own(1, {-1, 0}).own(2, {-0.9, 1.3}).own(3, {1.6, -0.9});
  stage.world.view.own[1].heading = {0.8, 0.6};
  stage.world.ball(Vec2(-1, 0) + kHeldBall_m * Vec2(0.8, 0.6));
  stage.world.opponent(0, {2.9, 0}).opponent(1, {-0.3, 0.1}).opponent(2, {0, -0.75});
  for (int frame = 0; frame < 12; ++frame) {
    stage.look(1);
    handler.update();
    handler.play(1);
  }
  return handler.choice().receiver;
}

// Number of the team's robot nearest to the point.
int nearest_to(const StagedWorld& world, const Vec2& point_m) {
  const auto& own = world.view.own;
  return std::min_element(own.begin(), own.end(),
                          [&](const auto& a, const auto& b) {
                            return distance_m(a, point_m) < distance_m(b, point_m);
                          })
      ->number;
}

constexpr double kBeside_m = 0.35;  // a marker stands 300 mm from its opponent

StagedWorld four_to_mark() {
  StagedWorld world = theirs_at({0.5, 0});
  world.opponent(2, {-1.5, 1.0}).opponent(3, {-0.6, -1.2}).opponent(4, {1.0, 1.5});
  return world.opponent(5, {1.4, -1.0});
}

// Those of the given opponents that no robot stands beside.
Numbers unmarked(const StagedWorld& world, Numbers opponents) {
  std::erase_if(opponents, [&](int number) {
    const Vec2& opponent_m = world.view.opponents[static_cast<std::size_t>(number)].position_m;
    return distance_m(world.robot(nearest_to(world, opponent_m)), opponent_m) < kBeside_m;
  });
  return opponents;
}

TEST(Shadow, MarksEveryOpponentWithoutTheBallAllOverTheField) {
  const auto team = make("shadow");
  StagedWorld world = four_to_mark();
  world.run(*team, 4);
  EXPECT_EQ(unmarked(world, {2, 3, 4, 5}), kNobody);
}

// Opponents 2 and 3 swap positions in 3 s, 100 mm apart.
void swap_opponents(StagedWorld& world, Strategy& team) {
  for (int f = 0; f < 180; ++f) {
    world.view.opponents[2].position_m += Vec2(0.9, -2.1) / 180;
    world.view.opponents[3].position_m += Vec2(-0.9, 2.1) / 180;
    world.step(team);
  }
}

TEST(Shadow, FollowsItsOwnOpponentsWhenTheyCrossEachOther) {
  const auto team = make("shadow");
  StagedWorld world = four_to_mark();
  world.run(*team, 4);
  const TrackedRobots& opponents = world.view.opponents;
  const int second = nearest_to(world, opponents[2].position_m);
  const int third = nearest_to(world, opponents[3].position_m);
  swap_opponents(world, *team);
  world.run(*team, 1);
  EXPECT_LT(distance_m(world.robot(second), opponents[2].position_m), kBeside_m);
  EXPECT_LT(distance_m(world.robot(third), opponents[3].position_m), kBeside_m);
}

// Those of the given opponents that have no robot 150 mm or more nearer to the team's goal.
Numbers unshadowed(const StagedWorld& world, Numbers opponents) {
  const Vec2 goal_m = Field{}.goal_centre_m(Side::kWest);
  std::erase_if(opponents, [&](int number) {
    const Vec2& opponent_m = world.view.opponents[static_cast<std::size_t>(number)].position_m;
    const TrackedRobot& marker = world.robot(nearest_to(world, opponent_m));
    return distance_m(marker, goal_m) < (opponent_m - goal_m).norm() - 0.15;
  });
  return opponents;
}

TEST(Shadow, StandsBetweenItsOpponentsAndItsGoal) {
  const auto team = make("shadow");
  StagedWorld world = four_to_mark();
  world.run(*team, 4);
  EXPECT_EQ(unshadowed(world, {2, 3, 4, 5}), kNobody);
}

TEST(Shadow, AlsoMarksInAStop) {
  const auto team = make("shadow");
  StagedWorld world = four_to_mark();
  world.view.play = Play::kStop;
  world.view.ball.position_m = {2.9, 1.9};  // far from all of them
  world.run(*team, 5);
  EXPECT_EQ(unmarked(world, {1, 2, 3, 4}), kNobody);  // the fifth robot blocks the ball
}

// The number of robots, other than the first two, beside an opponent, counted once for each.
int robots_beside_opponents(const StagedWorld& world) {
  int beside = 0;
  for (int i = 2; i < 6; ++i) {
    for (const TrackedRobot& opponent : world.view.opponents)
      beside += distance_m(world.robot(i), opponent.position_m) < kBeside_m ? 1 : 0;
  }
  return beside;
}

TEST(Shadow, ReleasesTwoMarkersInPossession) {
  const auto team = make("shadow");
  StagedWorld world = four_to_mark();
  world.ball({-0.5, 0});
  world.view.own[1].position_m = {-0.5 - kHeldBall_m, 0};
  world.run(*team, 4);
  EXPECT_EQ(robots_beside_opponents(world), 2);
}

// Robots 2 to 5, which form the zone, must have moved by `shift_m`, to within 20 mm.
void expect_zone_shifted_by(const Vec2& shift_m, const StagedWorld& before,
                            const StagedWorld& after) {
  for (int i = 2; i < 6; ++i) {
    const Vec2 moved_m = after.robot(i).position_m - before.robot(i).position_m;
    EXPECT_NEAR(moved_m.x(), shift_m.x(), 0.02) << i;
    EXPECT_NEAR(moved_m.y(), shift_m.y(), 0.02) << i;
  }
}

TEST(Zone, KeepsItsShapeAndShiftsWithTheBall) {
  const auto team = make("zone");
  StagedWorld world = theirs_at({0, 0});
  world.run(*team, 4);
  const StagedWorld before = world;
  const Vec2 moved_m(0.8, 0.6);
  world.view.ball.position_m += moved_m;
  world.view.own[1].position_m += moved_m;  // stays at the ball, as does the opponents' robot
  world.view.opponents[1].position_m += moved_m;
  world.run(*team, 4);
  expect_zone_shifted_by({0.36, 0.21}, before, world);  // 0.45 and 0.35 of the ball's displacement
}

TEST(Zone, SendsOnlyTheFastestToTheBall) {
  const auto team = make("zone");
  StagedWorld world = theirs_at({0, 0});
  world.run(*team, 4);
  EXPECT_EQ(nearest_to(world, {0, 0}), 1);
  EXPECT_EQ(robots_within(world, {0, 0}, 0.5), Numbers({1}));
}

TEST(Zone, MovesUpInPossession) {
  const auto without = make("zone");
  const auto with = make("zone");
  StagedWorld theirs = theirs_at({0, 0});
  StagedWorld ours = ours_at({0, 0});
  theirs.run(*without, 4);
  ours.run(*with, 4);
  expect_zone_shifted_by({0.12 * 3.025, 0}, theirs, ours);  // of half the field's length
}

TEST(Zone, HoldsItsZonesInAStop) {
  const auto team = make("zone");
  StagedWorld world = theirs_at({1.5, 0});
  world.view.own[1].position_m = {1.0, 0};
  world.run(*team, 4);
  const TeamView before = world.view;
  world.view.play = Play::kStop;
  world.run(*team, 4);
  world.view.own.erase(world.view.own.begin(), world.view.own.begin() + 2);
  EXPECT_EQ(moved_since(before, world, 0.05), kNobody);
}

// The number of robots behind the opponents' ball after 4 s.
std::size_t behind_their_ball(const Vec2& ball_m) {
  const auto team = make("counter");
  StagedWorld world = theirs_at(ball_m);
  world.run(*team, 4);
  const auto is_behind = [&](const auto& robot) { return robot.position_m.x() < ball_m.x(); };
  return numbers_of(world.view.own, is_behind).size();
}

TEST(Counter, KeepsAllButOneBehindTheBallOutOfPossession) {
  EXPECT_EQ(behind_their_ball({0.3, 0}), 5U);
  EXPECT_EQ(behind_their_ball({-0.6, 1.2}), 5U);
  EXPECT_EQ(behind_their_ball({1.2, -1.5}), 6U);
}

TEST(Counter, LeavesOneOrTwoInTheOpponentsHalf) {
  const auto team = make("counter");
  StagedWorld world = theirs_at({-1, 0.5});
  world.run(*team, 4);
  EXPECT_GE(ahead_of(world, 0.5), 1);
  EXPECT_LE(ahead_of(world, 0.5), 2);
}

TEST(Counter, HasTwoAheadOfTheBallAndTheOthersBehindInPossession) {
  const auto team = make("counter");
  StagedWorld world = ours_at({-1, 0.5});
  world.run(*team, 4);
  EXPECT_EQ(ahead_of(world, 0.5), 2);
  EXPECT_EQ(ahead_of(world, -0.7),
            2);  // a quarter of half the field's length; nobody is in between
}

// The row moves up to at most a quarter of its half: all robots except the one at the ball and the
// one ahead.
TEST(Counter, DoesNotMoveUpBehindABallFarAhead) {
  const auto team = make("counter");
  StagedWorld world = theirs_at({2, 1});
  world.run(*team, 4);
  EXPECT_EQ(ahead_of(world, -0.7), 2);
}

TEST(Counter, LeavesAForwardAheadInAStop) {
  const auto team = make("counter");
  StagedWorld world = theirs_at({-1, 0.5});
  world.view.play = Play::kStop;
  world.run(*team, 4);
  EXPECT_GE(ahead_of(world, 0.5), 1);
  EXPECT_LE(ahead_of(world, 0.5), 2);
}

TEST(Counter, PassesFarAheadRatherThanSafely) { EXPECT_EQ(passes_to(counter_playbook()), 3); }

TEST(Possession, PassesSafelyRatherThanFarAhead) { EXPECT_EQ(passes_to(possession_playbook()), 2); }

// The number of robots, other than the first two, at passing distance from the ball.
int around_ball(const StagedWorld& world) {
  int around = 0;
  for (int i = 2; i < 6; ++i) {
    const double off_m = distance_m(world.robot(i), world.view.ball.position_m);
    around += off_m > 0.7 && off_m < 1.6 ? 1 : 0;
  }
  return around;
}

TEST(Possession, SpreadsAroundTheBallAtPassingDistanceInPossession) {
  const auto team = make("possession");
  StagedWorld world = ours_at({0.2, 0.3});
  world.run(*team, 4);
  EXPECT_GE(around_ball(world), 3);  // the fourth stays back
}

TEST(Possession, SpreadsAroundTheBallBeforeItsOwnRestart) {
  const auto team = make("possession");
  StagedWorld world = ours_at({0.2, 0.3});
  world.view.play = Play::kStop;
  world.view.next_is_ours = true;
  world.run(*team, 4);
  EXPECT_GE(around_ball(world), 3);
}

TEST(Chaser, SendsOneRobotToTheBallAndKeepsTheOthersInFormation) {
  const auto team = make("chaser");
  StagedWorld world = theirs_at({1.5, 0.5});
  world.run(*team, 3);
  EXPECT_LT(distance_m(world.robot(nearest_to(world, {1.5, 0.5})), {1.5, 0.5}), 0.4);
  const auto& own = world.view.own;
  EXPECT_EQ(
      std::count_if(own.begin(), own.end(), [](const auto& r) { return r.position_m.x() < 0; }), 5);
}

}  // namespace
}  // namespace autoref::strategies
