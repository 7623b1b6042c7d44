// "Additional time is allowed for a penalty kick to be taken at the end of each half" (Laws 2014,
// laws 7 and 14; 2026, Penalty Kick).
#include <gtest/gtest.h>

#include "tests/referee/support/scripted_game.hpp"

namespace autoref::referee {
namespace {

constexpr double kHalf_s = 4;

Configuration with_book(const std::string& book) {
  Configuration configuration;
  configuration.rules = *find_rule_book(book);
  configuration.field = find_game_setup(book)->field;
  configuration.half_s = kHalf_s;
  return configuration;
}

// A defender of east plays the ball inside its own area shortly before the end of the half. The
// others then stand 1.4 m behind the mark.
ScriptedGame with_late_penalty(const std::string& book) {
  const Configuration configuration = with_book(book);
  ScriptedGame game(configuration);
  game.line_up(3).kick_off();
  game.kick(Side::kWest, 1, {-0.5, 0});
  game.run(3);
  const double goal_m = configuration.field.half_length_m();
  game.kick_from(Side::kEast, 2, {goal_m - 0.4, 0}, {-2, 0});
  game.run_until("defender_in_defense_area", 0.5);
  const double behind_m = configuration.field.penalty_mark_at(Side::kEast).x() - 1.4;
  for (const Side side : kSides) {
    for (RobotObservation& robot : game.frame.robots[side]) {
      robot.position_m = {behind_m, goal_sign(side) * (0.5 + 0.4 * robot.number)};
    }
  }
  game.robot(Side::kEast, 0) = {0, Vec2(goal_m - 0.05, -0.2), Vec2(-1, 0)};
  return game;
}

class PenaltyAtTheEnd : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Books, PenaltyAtTheEnd, testing::Values("2014", "2026-b"),
                         [](const auto& book) {
                           return std::string(book.param) == "2014" ? "laws_2014" : "rules_2026_b";
                         });

TEST_P(PenaltyAtTheEnd, IsStillTaken) {
  ScriptedGame game = with_late_penalty(GetParam());
  game.run_until("start");
  EXPECT_EQ(game.signal.command.kind, CommandKind::kNormalStart);
  game.run(4);  // nobody takes it yet
  EXPECT_EQ(game.count("half_over"), 0);
}

TEST_P(PenaltyAtTheEnd, EndsTheHalfAfterItsGoal) {
  ScriptedGame game = with_late_penalty(GetParam());
  game.run_until("start");
  game.run(3);
  game.kick(Side::kWest, 1, {5, 0.1});
  const double goal_s = game.run_until("goal", 3).time_s;
  EXPECT_EQ(game.signal.command.kind, CommandKind::kGoal);
  const Decision over = game.run_until("half_over", 0.1);
  EXPECT_LT(over.time_s - goal_s, 0.05);
  EXPECT_EQ(game.signal.goals[Side::kWest], 1);
  EXPECT_EQ(game.signal.stage, Stage::kHalfTime);
}

TEST_P(PenaltyAtTheEnd, EndsTheHalfWhenItGoesOut) {
  ScriptedGame game = with_late_penalty(GetParam());
  game.run_until("start");
  game.run(3);
  game.kick(Side::kWest, 1, {4, 4});
  game.run_until("half_over", 3);
  EXPECT_EQ(game.signal.goals, PerSide<int>{});
}

TEST_P(PenaltyAtTheEnd, EndsTheHalfWhenNobodyTakesIt) {
  ScriptedGame game = with_late_penalty(GetParam());
  const double began_s = game.run_until("start").time_s;
  EXPECT_NEAR(game.run_until("half_over").time_s, began_s + 10, 1e-6);
}

TEST(PenaltyAtTheEndByTheLaws, EndsTheHalfWhenTheKickerPlaysTheBallAgain) {
  ScriptedGame game = with_late_penalty("2014");
  game.run_until("start");
  game.run(3);
  game.kick(Side::kWest, 1, {0.5, 0});
  game.run(0.4);
  RobotObservation& kicker = game.robot(Side::kWest, 1);
  kicker.position_m = game.frame.ball->position_m - Vec2(kFrontDistance_m + kBallRadius_m, 0);
  game.ball_mps = {0.8, 0};
  game.run_until("half_over", 0.2);
}

// The paper has no penalty kicks; its halves last exactly as long as configured.
TEST(PenaltyAtTheEndInThePaper, DoesNotProlongTheHalf) {
  Configuration configuration = with_book("2014");
  configuration.rules.penalty_prolongs_half = find_rule_book("paper")->penalty_prolongs_half;
  ScriptedGame game(configuration);
  game.line_up(3).kick_off();
  const double began_s = game.now_s();
  EXPECT_NEAR(game.run_until("half_over").time_s, began_s + kHalf_s, 1e-6);
}

}  // namespace
}  // namespace autoref::referee
