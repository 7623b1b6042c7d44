#include "game/loop/substitution.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/staged_game.hpp"

namespace autoref::game {
namespace {

constexpr double kFrame_s = 1 / StagedGame::kRate_hz;

std::vector<int> numbers(const StagedGame& game, Side side) {
  std::vector<int> all;
  for (const sim::RobotState& robot : game.robots(side)) all.push_back(robot.number);
  return all;
}

// A team of dummies that sends the given requests.
struct Asking final : strategies::Strategy {
  explicit Asking(const TeamRequests& asks) : wishes(asks) {}
  void decide(const TeamView& /*view*/, TeamCommands& /*commands*/) override {}
  TeamRequests requests() const override { return wishes; }
  TeamRequests wishes;
};

// Six dummies per side; the west makes the given requests.
StagedGame dummies(const TeamRequests& west = {}) {
  StagedGame game({}, {});
  game.teams[Side::kWest] = std::make_unique<Asking>(west);
  return game;
}

TeamRequests naming(int keeper, std::optional<int> leaves) {
  TeamRequests requests;
  requests.keeper = keeper;
  requests.leaves = leaves;
  return requests;
}

TEST(SubstitutionController, TakesOffTheHighestNumberASecondAfterTheAllowanceFalls) {
  StagedGame game = dummies();
  game.run(0.5);
  game.signal.robots_allowed[Side::kWest] = 5;
  game.run(1.0 - kFrame_s / 2);
  EXPECT_EQ(game.robots(Side::kWest).size(), 6U);
  game.frame();
  EXPECT_EQ(numbers(game, Side::kWest), (std::vector{0, 1, 2, 3, 4}));
  EXPECT_EQ(game.robots(Side::kEast).size(), 6U);
}

TEST(SubstitutionController, TakesOffTheNamedRobotAndThenTheHighestExceptTheKeeper) {
  StagedGame game = dummies(naming(5, 2));
  game.signal.robots_allowed[Side::kWest] = 4;
  game.run(1.2);
  EXPECT_EQ(numbers(game, Side::kWest), (std::vector{0, 1, 3, 5}));
}

TEST(SubstitutionController, WaitsUntilPlayIsStopped) {
  for (const CommandKind kind : {CommandKind::kForceStart, CommandKind::kNormalStart,
                                 CommandKind::kDirectFree, CommandKind::kIndirectFree}) {
    StagedGame game = dummies();
    game.command(kind);
    game.signal.robots_allowed[Side::kWest] = 5;
    game.run(3);
    EXPECT_EQ(game.robots(Side::kWest).size(), 6U) << name_of(game.signal.command);
  }
  for (const CommandKind kind : {CommandKind::kHalt, CommandKind::kPrepareKickoff,
                                 CommandKind::kPreparePenalty, CommandKind::kTimeout}) {
    StagedGame game = dummies();
    game.command(kind);
    game.signal.robots_allowed[Side::kWest] = 5;
    game.run(1.1);
    EXPECT_EQ(game.robots(Side::kWest).size(), 5U) << name_of(game.signal.command);
  }
}

TEST(SubstitutionController, PutsRobotsBackWhenTheyAreAllowedAgain) {
  StagedGame game = dummies();
  game.signal.robots_allowed[Side::kEast] = 3;
  game.run(2);
  ASSERT_EQ(game.robots(Side::kEast).size(), 3U);
  game.command(CommandKind::kForceStart);
  game.signal.robots_allowed[Side::kEast] = 16;
  game.run(1);
  EXPECT_EQ(game.robots(Side::kEast).size(), 3U);
  game.command(CommandKind::kStop);
  game.run(0.1);
  EXPECT_EQ(numbers(game, Side::kEast), (std::vector{0, 1, 2, 3, 4, 5}));
}

TEST(SubstitutionController, NeverAddsMoreRobotsThanTheTeamHas) {
  StagedGame game = dummies();
  game.run(2);
  EXPECT_EQ(game.robots(Side::kWest).size(), 6U);
}

TEST(SubstitutionController, HandlesAnAllowanceOfZero) {
  StagedGame game = dummies();
  game.signal.robots_allowed = {{0, 0}};
  game.run(2);
  EXPECT_TRUE(game.robots(Side::kWest).empty());
  EXPECT_TRUE(game.robots(Side::kEast).empty());
}

TEST(ReturnPosition, IsInTheRunOffOfItsOwnHalfNearTheHalfwayLine) {
  const StagedGame game = dummies();
  const Vec2 west_m = return_position(game.field, Side::kWest, {}, game.world, 0.5).value();
  EXPECT_LT(west_m.x(), -kRobotRadius_m);
  EXPECT_GT(west_m.x(), -0.5);
  EXPECT_GT(std::abs(west_m.y()), game.field.half_width_m() + kRobotRadius_m);
  EXPECT_LT(std::abs(west_m.y()), game.field.wall_y_m() - kRobotRadius_m);
  EXPECT_EQ(return_position(game.field, Side::kEast, {}, game.world, 0.5).value(), -west_m);
}

// On every field that a rule book has.
TEST(ReturnPosition, LeavesRoomForTheHullBetweenLineAndWall) {
  for (const std::string& book : rule_book_names()) {
    StagedGame game = dummies();
    game.field = find_game_setup(book)->field;
    const Vec2 position_m = return_position(game.field, Side::kWest, {}, game.world, 0.5).value();
    EXPECT_GT(std::abs(position_m.y()) + 1e-9, game.field.half_width_m() + kRobotRadius_m) << book;
    EXPECT_LT(std::abs(position_m.y()), game.field.wall_y_m() - kRobotRadius_m) << book;
  }
}

TEST(ReturnPosition, KeepsItsDistanceFromTheBallAndThePlacementTarget) {
  StagedGame game = dummies();
  const Vec2 first_m = return_position(game.field, Side::kWest, {}, game.world, 0.5).value();
  RefereeSignal signal;
  signal.placement = Placement{first_m + Vec2(0, 0.4), false};
  game.put_ball(first_m + Vec2(-0.6, 0.1));
  const Vec2 position_m = return_position(game.field, Side::kWest, signal, game.world, 0.5).value();
  EXPECT_GT((position_m - game.ball().position_m).norm(), 0.5 + kRobotRadius_m);
  EXPECT_GT((position_m - signal.placement->target_m).norm(), 0.5 + kRobotRadius_m);
}

TEST(ReturnPosition, IsBesideARobotIfTheFirstPositionIsTaken) {
  StagedGame game = dummies();
  const Vec2 first_m = return_position(game.field, Side::kWest, {}, game.world, 0.5).value();
  game.put_robot({Side::kEast, 3}, first_m);
  const Vec2 position_m = return_position(game.field, Side::kWest, {}, game.world, 0.5).value();
  EXPECT_GE((position_m - first_m).norm(), 2 * kRobotRadius_m);
  EXPECT_LT((position_m - first_m).norm(), 0.45);
}

// Alternates between stops and running play while the allowance of both sides falls and rises.
TEST(Basic, PlaysOnWithFewerRobotsAndNamesItsKeeper) {
  StagedGame game({"basic", 6, {}}, {"basic", 6, {}});
  for (const int allowed : {4, 2, 1, 0, 1, 3, 6}) {
    game.signal.robots_allowed = {{allowed, allowed}};
    game.command(CommandKind::kStop);
    game.signal.placement = Placement{{0.3, 0.2}, false};
    game.run(3);
    ASSERT_EQ(game.robots(Side::kWest).size(), static_cast<std::size_t>(allowed));
    game.signal.placement.reset();
    game.command(CommandKind::kForceStart);
    const bool is_touched = game.happens(5, [&] { return !game.world.touches().empty(); });
    EXPECT_EQ(is_touched, allowed > 0) << allowed;
    ASSERT_TRUE(game.world.is_finite());
  }
}

TEST(Basic, NamesTheRobotThatKeepsItsGoal) {
  StagedGame game({"basic", 6, {}}, {});
  game.signal.robots_allowed[Side::kWest] = 5;
  game.world.take_off({Side::kWest, 0});
  game.run(4);  // the tracker drops the keeper's track, and another robot becomes keeper
  const int keeper = game.teams[Side::kWest]->requests().keeper;
  EXPECT_EQ(keeper, 1);
  EXPECT_NEAR(game.robot({Side::kWest, 1}).position_m.x(), -game.field.half_length_m(), 0.2);
}

}  // namespace
}  // namespace autoref::game
