#include "strategies/plays/squad.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {
namespace {

const std::vector<Vec2> kBallPositions_m = {{0, 0},  {-2.925, 1.925}, {2.925, -1.925},
                                            {-1, 1}, {1.5, 0.3},      {-1.4, 0}};

TEST(Squad, KeepsItsDistanceFromTheBallWhilePlayIsStopped) {
  for (const Vec2& ball_m : kBallPositions_m) {
    Squad team(TeamContext{}, TeamPlaybook{});
    StagedWorld world(Play::kStop);
    world.six_against_six().ball(ball_m).run(team, 5);
    for (const TrackedRobot& robot : world.view.own) {
      if (robot.number == 0) continue;  // the keeper may stay in its goal
      EXPECT_GE((robot.position_m - ball_m).norm(), kBallGap_m)
          << robot.number << ", ball at " << ball_m.transpose();
    }
  }
}

TEST(Squad, ComesToRestWhilePlayIsStopped) {
  for (const Vec2& ball_m : kBallPositions_m) {
    for (const bool ours : {true, false}) {
      Squad team(TeamContext{}, TeamPlaybook{});
      StagedWorld world(Play::kStop);
      world.view.next = CommandKind::kDirectFree;
      world.view.next_is_ours = ours;
      world.six_against_six().ball(ball_m).run(team, 3);
      const TeamView before = world.view;
      world.run(team, 1);
      for (std::size_t i = 0; i < before.own.size(); ++i) {
        EXPECT_LT((world.view.own[i].position_m - before.own[i].position_m).norm(), 15_mm)
            << i << ", ball at " << ball_m.transpose();
      }
    }
  }
}

TEST(Squad, LeavesAStoppedBallWithinTwoSeconds) {
  Squad team(team_context_of("2014"), TeamPlaybook{});
  StagedWorld world(Play::kStop);
  world.six_against_six().ball({1, 1});
  world.view.own[2].position_m = {0.9, 0.95};
  world.view.own[3].position_m = {1.1, 1.15};
  world.run(team, 2);
  for (const TrackedRobot& robot : world.view.own)
    EXPECT_GE((robot.position_m - Vec2(1, 1)).norm(), kBallGap_m) << robot.number;
}

TEST(Squad, KeepsItsHullClearOfTheOpponentsAreaBeforeARestart) {
  Squad team(TeamContext{}, TeamPlaybook{});
  StagedWorld world(Play::kDirectFree, false);
  world.six_against_six().ball({2.525, 1.925});  // the opponents' goal kick
  world.view.own[3].position_m = {2.2, 0.3};
  world.run(team, 4);
  for (const TrackedRobot& robot : world.view.own) {
    EXPECT_GE(distance_to_defence_area(Field{}, Side::kEast, robot.position_m),
              200_mm + kRobotRadius_m)
        << robot.number;
  }
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

// Plays a stop, then the restart, which only the field player nearest to the ball takes.
TEST(Squad, TakesItsRestartWithTheNearestRobotOnly) {
  const Vec2 ball_m(1, 1.9);
  Squad team(TeamContext{}, TeamPlaybook{});
  StagedWorld world(Play::kStop);
  world.view.next = CommandKind::kIndirectFree;
  world.view.next_is_ours = true;
  world.six_against_six().ball(ball_m).run(team, 4);
  const auto gap_m = [&](int number) { return (world.robot(number).position_m - ball_m).norm(); };
  int nearest = 1;
  for (int i = 2; i < 6; ++i) nearest = gap_m(i) < gap_m(nearest) ? i : nearest;
  world.view.play = Play::kIndirectFree;
  world.view.ours = true;
  std::array<double, 6> least_m;
  least_m.fill(9);
  for (int frame = 0; frame < 180; ++frame) {
    world.step(team);
    for (int i = 0; i < 6; ++i)
      least_m[static_cast<std::size_t>(i)] =
          std::min(least_m[static_cast<std::size_t>(i)], gap_m(i));
  }
  for (int i = 0; i < 6; ++i) {
    const double reached_m = least_m[static_cast<std::size_t>(i)];
    EXPECT_TRUE(i == nearest ? reached_m < 0.12 : reached_m > 0.3) << i << ": " << reached_m;
  }
}

// If the nearest robot cannot move, as if it were trapped, another robot takes the restart.
TEST(Squad, TakesItsRestartWithAnotherRobotIfTheNearestIsStuck) {
  const Vec2 ball_m(1, 1);
  Squad team(TeamContext{}, TeamPlaybook{});
  StagedWorld world(Play::kDirectFree, true);
  world.own(0, {-2.8, 0}).own(1, {0.5, 1}).own(2, {-1, -1}).ball(ball_m);
  double least_m = 9;
  for (int frame = 0; frame < 480; ++frame) {
    world.step(team);
    world.view.own[1].position_m = {0.5, 1};
    least_m = std::min(least_m, (world.robot(2).position_m - ball_m).norm());
  }
  EXPECT_LT(least_m, 0.12);
}

// Laws 2014: the taker of a restart must not touch the ball again before another robot has.
TEST(Squad, DoesNotPlayTheBallTwiceAfterItsRestart) {
  Squad team(team_context_of("2014"), TeamPlaybook{});
  StagedWorld world(Play::kDirectFree, true);
  world.own(0, {-2.8, 0}).own(1, {0.7, 0.8}).own(2, {-2, -1}).ball({1, 1}).run(team, 2);
  world.view.play = Play::kRunning;
  world.ball({1.5, 1.2});
  for (int frame = 0; frame < 120; ++frame) {
    world.step(team);
    const double gap_m = (world.robot(1).position_m - Vec2(1.5, 1.2)).norm();
    if ((world.robot(2).position_m - Vec2(1.5, 1.2)).norm() < 0.2) break;
    ASSERT_GT(gap_m, kHeldBall_m + 20_mm) << frame;
  }
}

TEST(Squad, TakesItsRestartEvenWithASingleRobot) {
  Squad team(TeamContext{}, TeamPlaybook{});
  StagedWorld world(Play::kIndirectFree, true);
  world.own(4, {-2, -1}).ball({1, 1.925});
  bool is_taken = false;
  for (int i = 0; i < 400; ++i) {
    const RobotCommand& command = world.step(team)[4];
    is_taken = is_taken ||
               (command.kick_mps > 0 && (world.robot(4).position_m - Vec2(1, 1.925)).norm() < 0.12);
  }
  EXPECT_TRUE(is_taken);
}

TEST(Squad, StandsStillInHalt) {
  Squad team(TeamContext{}, TeamPlaybook{});
  StagedWorld world(Play::kHalt);
  world.six_against_six();
  for (const RobotCommand& command : world.step(team)) {
    EXPECT_EQ(command.velocity_mps, Vec2(0, 0));
    EXPECT_EQ(command.kick_mps, 0);
  }
}

TEST(Squad, DeclaresItsLowestNumberAsKeeper) {
  Squad team(TeamContext{}, TeamPlaybook{});
  StagedWorld world(Play::kRunning);
  world.own(3, {-2, 0}).own(7, {0, 0}).step(team);
  EXPECT_EQ(team.requests().keeper, 3);
}

// Two teams in a game that looks the same when turned by 180 degrees must give the same commands.
// Each robot moves in its own team's frame, so that the symmetry is exact to the last bit.
TEST(Squad, PlaysSymmetricallyFromTheOtherEnd) {
  PerSide<std::unique_ptr<Squad>> teams;
  PerSide<StagedWorld> ends{{StagedWorld(Play::kRunning), StagedWorld(Play::kRunning)}};
  for (const Side side : kSides) {
    teams[side] = std::make_unique<Squad>(TeamContext{}, TeamPlaybook{});
    for (int i = 0; i < 6; ++i) ends[side].own(i, {-0.4 - 0.4 * i, 1.2 - 0.35 * i});
  }
  for (int frame = 0; frame < 180; ++frame) {
    const PerSide<TrackedRobots> before{{ends[Side::kWest].view.own, ends[Side::kEast].view.own}};
    for (const Side side : kSides) {
      TeamView& view = ends[side].view;
      view.opponents.clear();
      for (const TrackedRobot& robot : before[opponent_of(side)])
        view.opponents.push_back(mirrored(robot));
      ends[side].step(*teams[side]);
    }
  }
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(ends[Side::kWest].robot(i).position_m, ends[Side::kEast].robot(i).position_m) << i;
  }
}

}  // namespace
}  // namespace autoref::strategies
