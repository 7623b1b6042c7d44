// Tests teams without one of their robots. Even robot 0 may be off the field; another robot is then
// the keeper. Only the keeper that the team declares enters the team's own area.
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "strategies/registry.hpp"
#include "tests/strategies/readme_team.hpp"
#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {
namespace {

std::unique_ptr<Strategy> made(const std::string& name) {
  const TeamContext context;
  if (name == "readme_mine") return std::make_unique<readme::Mine>(context);
  if (name == "readme_bus") return std::make_unique<Squad>(context, readme::bus_playbook());
  return find_strategy(name)->make(context);
}

std::vector<std::string> names_of_teams() {
  std::vector<std::string> names = {"readme_mine", "readme_bus"};
  for (const Entry& entry : all_strategies()) {
    if (entry.name != "dummy" && entry.name != "rowdy") names.emplace_back(entry.name);
  }
  return names;
}

// A team, and the number of the robot that is missing.
class MissingRobot : public testing::TestWithParam<std::tuple<std::string, int>> {};

INSTANTIATE_TEST_SUITE_P(
    Of, MissingRobot, testing::Combine(testing::ValuesIn(names_of_teams()), testing::Range(0, 6)),
    [](const auto& test) {
      return std::get<0>(test.param) + "_without_" + std::to_string(std::get<1>(test.param));
    });

StagedWorld without(int missing, Play play, bool ours, const Vec2& ball_m) {
  StagedWorld world(play, ours);
  world.six_against_six().ball(ball_m);
  auto& own = world.view.own;
  own.erase(std::find_if(own.begin(), own.end(),
                         [missing](const TrackedRobot& robot) { return robot.number == missing; }));
  return world;
}

// How deep the centre of any robot other than the declared keeper gets into the team's own area. A
// robot that starts there has a second to leave.
double deepest_m(Strategy& team, StagedWorld& world, double seconds) {
  const Field field;
  double deepest_m = 0;
  world.run(team, 1);
  for (int frame = 0; frame < seconds / kStagedFrame_s; ++frame) {
    world.step(team);
    for (const TrackedRobot& robot : world.view.own) {
      const bool is_on_field = std::abs(robot.position_m.x()) < field.half_length_m();
      if (robot.number == team.requests().keeper || !is_on_field) continue;
      deepest_m =
          std::max(deepest_m, -distance_to_defence_area(field, Side::kWest, robot.position_m));
    }
  }
  return deepest_m;
}

void expect_own_area_left_to_keeper(const std::string& name, int missing, const Vec2& ball_m) {
  for (const Play play : {Play::kRunning, Play::kDirectFree}) {
    const auto team = made(name);
    StagedWorld world = without(missing, play, false, ball_m);
    EXPECT_EQ(deepest_m(*team, world, 4), 0)
        << "ball " << ball_m.transpose() << ", play " << static_cast<int>(play);
  }
}

TEST_P(MissingRobot, LeavesTheOwnAreaToTheDeclaredKeeper) {
  const auto& [name, missing] = GetParam();
  expect_own_area_left_to_keeper(name, missing, {-2.7, 0.2});
  expect_own_area_left_to_keeper(name, missing, {-1.5, -0.5});
  expect_own_area_left_to_keeper(name, missing, {0.5, 1});
}

TEST_P(MissingRobot, DeclaresAKeeperThatIsOnTheField) {
  const auto& [name, missing] = GetParam();
  const auto team = made(name);
  StagedWorld world = without(missing, Play::kRunning, true, {0, 0});
  world.run(*team, 1);
  const int keeper = team->requests().keeper;
  EXPECT_NE(keeper, missing);
  EXPECT_NO_THROW(world.robot(keeper));
}

TEST_P(MissingRobot, StillGoesToTheBall) {
  const auto& [name, missing] = GetParam();
  const auto team = made(name);
  StagedWorld world = without(missing, Play::kRunning, true, {0, 0});
  EXPECT_LT(least_gap_m(world, *team, 4, {0, 0}), 0.12);
}

}  // namespace
}  // namespace autoref::strategies
