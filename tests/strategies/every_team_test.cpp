#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "strategies/registry.hpp"
#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {
namespace {

// Requirements for every team that follows the rules, whatever its style.
class EveryTeam : public testing::TestWithParam<std::string_view> {
 protected:
  static std::unique_ptr<Strategy> make(const TeamContext& context = {}) {
    return find_strategy(GetParam())->make(context);
  }
};

std::vector<std::string_view> lawful_teams() {
  std::vector<std::string_view> names;
  for (const Entry& entry : all_strategies()) {
    if (entry.name != "dummy" && entry.name != "rowdy") names.push_back(entry.name);
  }
  return names;
}

std::string name_of_team(const testing::TestParamInfo<std::string_view>& team) {
  return std::string(team.param);
}

INSTANTIATE_TEST_SUITE_P(Named, EveryTeam, testing::ValuesIn(lawful_teams()), name_of_team);

TEST_P(EveryTeam, KeepsItsDistanceFromTheBallAndComesToRestWhilePlayIsStopped) {
  for (const Vec2& ball_m : {Vec2(0, 0), Vec2(-2.9, 1.9), Vec2(2.9, -1.9), Vec2(-1, 1)}) {
    const auto team = make();
    StagedWorld world(Play::kStop);
    world.six_against_six().ball(ball_m).run(*team, 5);
    const TeamView before = world.view;
    world.run(*team, 1);
    for (std::size_t i = 1; i < before.own.size(); ++i) {  // the keeper may stay in its goal
      const Vec2& position_m = world.view.own[i].position_m;
      EXPECT_GE((position_m - ball_m).norm(), kBallGap_m) << i << ", ball " << ball_m.transpose();
      EXPECT_LT((position_m - before.own[i].position_m).norm(), 15_mm)
          << i << ", ball " << ball_m.transpose();
    }
  }
}

TEST_P(EveryTeam, IsInItsOwnHalfForAKickoff) {
  for (const bool ours : {true, false}) {
    const auto team = make();
    StagedWorld world(Play::kPrepareKickoff, ours);
    world.six_against_six();
    world.view.own[5].position_m = {1.5, 0.5};
    world.run(*team, 6);
    for (const TrackedRobot& robot : world.view.own)
      EXPECT_LE(robot.position_m.x(), -kRobotRadius_m) << robot.number;
  }
}

TEST_P(EveryTeam, GoesToTheBallInOpenPlayAndAtItsRestarts) {
  for (const Play play : {Play::kRunning, Play::kDirectFree, Play::kKickoff}) {
    const auto team = make();
    StagedWorld world(Play::kStop, true);
    world.view.next_is_ours = true;
    world.view.next =
        play == Play::kKickoff ? CommandKind::kPrepareKickoff : CommandKind::kDirectFree;
    world.six_against_six().ball({0, 0}).run(*team, 3);
    world.view.play = play;
    double least_m = 9;
    for (int frame = 0; frame < 240; ++frame) {
      world.step(*team);
      for (const TrackedRobot& robot : world.view.own)
        least_m = std::min(least_m, robot.position_m.norm());
    }
    EXPECT_LT(least_m, 0.12) << static_cast<int>(play);
  }
}

TEST_P(EveryTeam, PlaysWithAnyNumberOfRobotsInEveryPlay) {
  for (int play = 0; play <= static_cast<int>(Play::kRunning); ++play) {
    for (const int robots : {0, 1, 2, 3, kMaxRobots}) {
      const auto team = make();
      StagedWorld world(static_cast<Play>(play), true);
      for (int i = 0; i < robots; ++i)
        world.own(i, {-2.5 + 0.3 * i, 1.0}).opponent(i, {-2.5 + 0.3 * i, -1.0});
      world.run(*team, 0.5);
      for (const TrackedRobot& robot : world.view.own) {
        EXPECT_TRUE(is_finite(robot.position_m)) << play;
      }
    }
  }
}

TEST_P(EveryTeam, GivesTheSameCommandsForTheSameViews) {
  const auto first = make();
  const auto second = make();
  StagedWorld world(Play::kStop, true);
  world.six_against_six().ball({0.1, 0.05});
  for (const Play play : {Play::kStop, Play::kPrepareKickoff, Play::kKickoff, Play::kRunning,
                          Play::kDirectFree, Play::kPreparePenalty, Play::kPenalty}) {
    world.view.play = play;
    if (play == Play::kRunning) world.kick({2, 1});
    for (int frame = 0; frame < 60; ++frame) {
      TeamCommands commands{};
      second->decide(world.view, commands);
      world.step(*first);
      for (std::size_t i = 0; i < commands.size(); ++i) {
        ASSERT_EQ(commands[i].velocity_mps, world.commands[i].velocity_mps) << i << ", " << frame;
        ASSERT_EQ(commands[i].kick_mps, world.commands[i].kick_mps) << i << ", " << frame;
      }
    }
  }
}

}  // namespace
}  // namespace autoref::strategies
