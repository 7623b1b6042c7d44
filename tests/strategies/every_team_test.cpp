#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "strategies/registry.hpp"
#include "tests/strategies/lawful_teams.hpp"
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

std::string name_of_team(const testing::TestParamInfo<std::string_view>& team) {
  return std::string(team.param);
}

INSTANTIATE_TEST_SUITE_P(Named, EveryTeam, testing::ValuesIn(lawful_teams()), name_of_team);

class EveryTeamInStop : public testing::TestWithParam<std::tuple<std::string_view, Vec2>> {};

TEST_P(EveryTeamInStop, KeepsItsDistanceFromTheBallAndComesToRest) {
  const auto& [name, ball_m] = GetParam();
  const auto team = find_strategy(name)->make({});
  StagedWorld world(Play::kStop);
  world.six_against_six().ball(ball_m).run(*team, 5);
  const TeamView before = world.view;
  world.run(*team, 1);
  EXPECT_EQ(field_players_within(world, ball_m, kBallGap_m), kNobody);
  world.view.own.erase(world.view.own.begin());  // the keeper may stay in its goal, and move there
  EXPECT_EQ(moved_since(before, world, 15_mm), kNobody);
}

INSTANTIATE_TEST_SUITE_P(BallAt, EveryTeamInStop,
                         testing::Combine(testing::ValuesIn(lawful_teams()),
                                          testing::Values(Vec2(0, 0), Vec2(-2.9, 1.9),
                                                          Vec2(2.9, -1.9), Vec2(-1, 1))),
                         [](const auto& test) {
                           return std::string(std::get<0>(test.param)) + "_" +
                                  place_name(std::get<1>(test.param));
                         });

// Prepares a kick-off for 6 s with one robot in the opponents' half. Returns who is not in its own.
Numbers beyond_half_before_kickoff(Strategy& team, bool ours) {
  StagedWorld world(Play::kPrepareKickoff, ours);
  world.six_against_six();
  world.view.own[5].position_m = {1.5, 0.5};
  world.run(team, 6);
  return numbers_of(world.view.own, is_beyond_own_half);
}

TEST_P(EveryTeam, IsInItsOwnHalfForAKickoff) {
  EXPECT_EQ(beyond_half_before_kickoff(*make(), true), kNobody);
  EXPECT_EQ(beyond_half_before_kickoff(*make(), false), kNobody);
}

// Stops play for 3 s and then lets the team have the ball for 4 s. Returns how near it gets.
double nearest_to_its_ball_m(Strategy& team, CommandKind next, Play play) {
  StagedWorld world(Play::kStop, true);
  world.view.next_is_ours = true;
  world.view.next = next;
  world.six_against_six().ball({0, 0}).run(team, 3);
  world.view.play = play;
  return least_gap_m(world, team, 4, {0, 0});
}

TEST_P(EveryTeam, GoesToTheBallInOpenPlayAndAtItsRestarts) {
  EXPECT_LT(nearest_to_its_ball_m(*make(), CommandKind::kDirectFree, Play::kRunning), 0.12);
  EXPECT_LT(nearest_to_its_ball_m(*make(), CommandKind::kDirectFree, Play::kDirectFree), 0.12);
  EXPECT_LT(nearest_to_its_ball_m(*make(), CommandKind::kPrepareKickoff, Play::kKickoff), 0.12);
}

// Lets a new team with that many robots play for half a second in every play.
void expect_positions_in_every_play(std::string_view name, int robots) {
  for (int play = 0; play <= static_cast<int>(Play::kRunning); ++play) {
    const auto team = find_strategy(name)->make({});
    StagedWorld world(static_cast<Play>(play), true);
    world.rows_of(robots).run(*team, 0.5);
    EXPECT_EQ(numbers_of(world.view.own, is_nowhere), kNobody)
        << robots << " robots, play " << play;
  }
}

TEST_P(EveryTeam, PlaysWithAnyNumberOfRobotsInEveryPlay) {
  expect_positions_in_every_play(GetParam(), 0);
  expect_positions_in_every_play(GetParam(), 1);
  expect_positions_in_every_play(GetParam(), 2);
  expect_positions_in_every_play(GetParam(), 3);
  expect_positions_in_every_play(GetParam(), kMaxRobots);
}

// Both teams decide for a second in that play, and the world follows the first.
void expect_same_commands(Strategy& first, Strategy& second, StagedWorld& world, Play play) {
  world.view.play = play;
  for (int frame = 0; frame < 60; ++frame) {
    TeamCommands commands{};
    second.decide(world.view, commands);
    world.step(first);
    for (std::size_t i = 0; i < commands.size(); ++i) {
      ASSERT_EQ(commands[i].velocity_mps, world.commands[i].velocity_mps) << i << ", " << frame;
      ASSERT_EQ(commands[i].kick_mps, world.commands[i].kick_mps) << i << ", " << frame;
    }
  }
}

TEST_P(EveryTeam, GivesTheSameCommandsForTheSameViews) {
  const auto first = make();
  const auto second = make();
  StagedWorld world(Play::kStop, true);
  world.six_against_six().ball({0.1, 0.05});
  expect_same_commands(*first, *second, world, Play::kStop);
  expect_same_commands(*first, *second, world, Play::kPrepareKickoff);
  expect_same_commands(*first, *second, world, Play::kKickoff);
  expect_same_commands(*first, *second, world.kick({2, 1}), Play::kRunning);
  expect_same_commands(*first, *second, world, Play::kDirectFree);
  expect_same_commands(*first, *second, world, Play::kPreparePenalty);
  expect_same_commands(*first, *second, world, Play::kPenalty);
}

}  // namespace
}  // namespace autoref::strategies
