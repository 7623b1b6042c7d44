#include "strategies/plays/squad.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {
namespace {

class SquadInStop : public testing::TestWithParam<Vec2> {};

TEST_P(SquadInStop, KeepsItsDistanceFromTheBall) {
  Squad team(TeamContext{}, TeamPlaybook{});
  StagedWorld world(Play::kStop);
  world.six_against_six().ball(GetParam()).run(team, 5);
  EXPECT_EQ(field_players_within(world, GetParam(), kBallGap_m), kNobody);
}

// Stops play for 3 s before a free kick of that side. Returns who moves in the next second.
Numbers moving_before_free_kick(const Vec2& ball_m, bool ours) {
  Squad team(TeamContext{}, TeamPlaybook{});
  StagedWorld world(Play::kStop);
  world.view.next = CommandKind::kDirectFree;
  world.view.next_is_ours = ours;
  world.six_against_six().ball(ball_m).run(team, 3);
  const TeamView before = world.view;
  world.run(team, 1);
  return moved_since(before, world, 15_mm);
}

TEST_P(SquadInStop, ComesToRestBeforeItsOwnFreeKick) {
  EXPECT_EQ(moving_before_free_kick(GetParam(), true), kNobody);
}

TEST_P(SquadInStop, ComesToRestBeforeTheOpponentsFreeKick) {
  EXPECT_EQ(moving_before_free_kick(GetParam(), false), kNobody);
}

INSTANTIATE_TEST_SUITE_P(BallAt, SquadInStop,
                         testing::Values(Vec2(0, 0), Vec2(-2.925, 1.925), Vec2(2.925, -1.925),
                                         Vec2(-1, 1), Vec2(1.5, 0.3), Vec2(-1.4, 0)),
                         name_of_place);

TEST(Squad, LeavesAStoppedBallWithinTwoSeconds) {
  Squad team(team_context_of("2014"), TeamPlaybook{});
  StagedWorld world(Play::kStop);
  world.six_against_six().ball({1, 1});
  world.view.own[2].position_m = {0.9, 0.95};
  world.view.own[3].position_m = {1.1, 1.15};
  world.run(team, 2);
  EXPECT_EQ(robots_within(world, {1, 1}, kBallGap_m), kNobody);
}

TEST(Squad, KeepsItsHullClearOfTheOpponentsAreaBeforeARestart) {
  Squad team(TeamContext{}, TeamPlaybook{});
  StagedWorld world(Play::kDirectFree, false);
  world.six_against_six().ball({2.525, 1.925});  // the opponents' goal kick
  world.view.own[3].position_m = {2.2, 0.3};
  world.run(team, 4);
  EXPECT_EQ(near_their_area(world, 200_mm + kRobotRadius_m), kNobody);
}

// The maximum speed of a robot in a stop of 4 s under that rule book.
double fastest_in_stop_mps(const char* rules) {
  Squad team(team_context_of(rules), TeamPlaybook{});
  StagedWorld world(Play::kStop);
  world.six_against_six().ball({-2.9, -1.9});
  double fastest_mps = 0;
  for (int frame = 0; frame < 240; ++frame) {
    world.step(team);
    for (const TrackedRobot& robot : world.view.own)
      fastest_mps = std::max(fastest_mps, robot.velocity_mps.norm());
  }
  return fastest_mps;
}

TEST(Squad, KeepsTheSpeedLimitInAStopIfThereIsOne) {
  EXPECT_LT(fastest_in_stop_mps("2014"), 1.0);
  EXPECT_LT(fastest_in_stop_mps("2026-b"), 1.5);
  EXPECT_GT(fastest_in_stop_mps("paper"), 1.5);
}

// The smallest distance of each robot from the ball while the team plays for 3 s.
std::array<double, 6> least_gaps_m(StagedWorld& world, Squad& team) {
  std::array<double, 6> least_m;
  least_m.fill(9);
  for (int frame = 0; frame < 180; ++frame) {
    world.step(team);
    for (const TrackedRobot& robot : world.view.own) {
      double& gap_m = least_m[static_cast<std::size_t>(robot.number)];
      gap_m = std::min(gap_m, (robot.position_m - world.view.ball.position_m).norm());
    }
  }
  return least_m;
}

int nearest_field_player(const StagedWorld& world, const Vec2& ball_m) {
  const auto gap_m = [&](const TrackedRobot& robot) { return (robot.position_m - ball_m).norm(); };
  const TrackedRobots& own = world.view.own;
  return std::min_element(own.begin() + 1, own.end(),
                          [&](const auto& a, const auto& b) { return gap_m(a) < gap_m(b); })
      ->number;
}

// Plays a stop, then the restart, which only the field player nearest to the ball takes.
TEST(Squad, TakesItsRestartWithTheNearestRobotOnly) {
  const Vec2 ball_m(1, 1.9);
  Squad team(TeamContext{}, TeamPlaybook{});
  StagedWorld world(Play::kStop);
  world.view.next = CommandKind::kIndirectFree;
  world.view.next_is_ours = true;
  world.six_against_six().ball(ball_m).run(team, 4);
  const int taker = nearest_field_player(world, ball_m);
  world.view.play = Play::kIndirectFree;
  world.view.ours = true;
  std::array<double, 6> least_m = least_gaps_m(world, team);
  EXPECT_LT(std::exchange(least_m[static_cast<std::size_t>(taker)], 9.0), 0.12);
  EXPECT_GT(*std::min_element(least_m.begin(), least_m.end()), 0.3)
      << testing::PrintToString(least_m);
}

// Plays for 8 s in which robot 1 cannot move. Returns how near robot 2 gets to the ball.
double least_gap_with_robot_1_stuck_m(StagedWorld& world, Squad& team, const Vec2& stuck_m) {
  double least_m = 9;
  for (int frame = 0; frame < 480; ++frame) {
    world.step(team);
    world.view.own[1].position_m = stuck_m;
    least_m = std::min(least_m, (world.robot(2).position_m - world.view.ball.position_m).norm());
  }
  return least_m;
}

// If the nearest robot cannot move, as if it were trapped, another robot takes the restart.
TEST(Squad, TakesItsRestartWithAnotherRobotIfTheNearestIsStuck) {
  const Vec2 stuck_m(0.5, 1);
  Squad team(TeamContext{}, TeamPlaybook{});
  StagedWorld world(Play::kDirectFree, true);
  world.own(0, {-2.8, 0}).own(1, stuck_m).own(2, {-1, -1}).ball({1, 1});
  EXPECT_LT(least_gap_with_robot_1_stuck_m(world, team, stuck_m), 0.12);
}

// How near robot 1 gets to the ball in 2 s, or until robot 2 is there.
double least_gap_of_taker_m(StagedWorld& world, Squad& team) {
  const Vec2& ball_m = world.view.ball.position_m;
  double least_m = 9;
  for (int frame = 0; frame < 120; ++frame) {
    world.step(team);
    if ((world.robot(2).position_m - ball_m).norm() < 0.2) break;
    least_m = std::min(least_m, (world.robot(1).position_m - ball_m).norm());
  }
  return least_m;
}

// Laws 2014: the taker of a restart must not touch the ball again before another robot has.
TEST(Squad, DoesNotPlayTheBallTwiceAfterItsRestart) {
  Squad team(team_context_of("2014"), TeamPlaybook{});
  StagedWorld world(Play::kDirectFree, true);
  world.own(0, {-2.8, 0}).own(1, {0.7, 0.8}).own(2, {-2, -1}).ball({1, 1}).run(team, 2);
  world.view.play = Play::kRunning;
  world.ball({1.5, 1.2});
  EXPECT_GT(least_gap_of_taker_m(world, team), kHeldBall_m + 20_mm);
}

// Whether robot 4 kicks the ball within 400 frames.
bool robot_4_takes_restart(StagedWorld& world, Squad& team) {
  for (int i = 0; i < 400; ++i) {
    const RobotCommand& command = world.step(team)[4];
    const double gap_m = (world.robot(4).position_m - world.view.ball.position_m).norm();
    if (command.kick_mps > 0 && gap_m < 0.12) return true;
  }
  return false;
}

TEST(Squad, TakesItsRestartEvenWithASingleRobot) {
  Squad team(TeamContext{}, TeamPlaybook{});
  StagedWorld world(Play::kIndirectFree, true);
  world.own(4, {-2, -1}).ball({1, 1.925});
  EXPECT_TRUE(robot_4_takes_restart(world, team));
}

TEST(Squad, StandsStillInHalt) {
  Squad team(TeamContext{}, TeamPlaybook{});
  StagedWorld world(Play::kHalt);
  world.six_against_six();
  EXPECT_EQ(active_robots(world.step(team)), kNobody);
}

TEST(Squad, DeclaresItsLowestNumberAsKeeper) {
  Squad team(TeamContext{}, TeamPlaybook{});
  StagedWorld world(Play::kRunning);
  world.own(3, {-2, 0}).own(7, {0, 0}).step(team);
  EXPECT_EQ(team.requests().keeper, 3);
}

// Two teams in a game that looks the same when turned by 180 degrees. Each robot moves in its own
// team's frame, so that the symmetry is exact to the last bit.
struct SymmetricGame {
  SymmetricGame() {
    for (const Side side : kSides) {
      for (int i = 0; i < 6; ++i) ends[side].own(i, {-0.4 - 0.4 * i, 1.2 - 0.35 * i});
    }
  }
  void frame() {
    const PerSide<TrackedRobots> before{{ends[Side::kWest].view.own, ends[Side::kEast].view.own}};
    for (const Side side : kSides) {
      TrackedRobots& opponents = ends[side].view.opponents;
      opponents.clear();
      for (const TrackedRobot& robot : before[opponent_of(side)])
        opponents.push_back(mirrored(robot));
      ends[side].step(*teams[side]);
    }
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i) frame();
  }

  PerSide<std::unique_ptr<Squad>> teams{{std::make_unique<Squad>(TeamContext{}, TeamPlaybook{}),
                                         std::make_unique<Squad>(TeamContext{}, TeamPlaybook{})}};
  PerSide<StagedWorld> ends{{StagedWorld(Play::kRunning), StagedWorld(Play::kRunning)}};
};

std::vector<Vec2> positions_of(const TrackedRobots& robots) {
  std::vector<Vec2> positions;
  for (const TrackedRobot& robot : robots) positions.push_back(robot.position_m);
  return positions;
}

TEST(Squad, PlaysSymmetricallyFromTheOtherEnd) {
  SymmetricGame game;
  game.frames(180);
  EXPECT_EQ(positions_of(game.ends[Side::kWest].view.own),
            positions_of(game.ends[Side::kEast].view.own));
}

}  // namespace
}  // namespace autoref::strategies
