#include "strategies/tactics/kick_choice.hpp"

#include <gtest/gtest.h>

#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {
namespace {

constexpr double kGoal_m = 3.025;    // x of the opponents' goal line
constexpr double kSomeChance = 0.3;  // scoring chance of a team-mate's shot
constexpr double kWorthNothing = -1;

// The target of a shot past a keeper at that y.
Vec2 target_past_keeper_m(double keeper_y_m) {
  StagedPrediction stage(Play::kRunning);
  stage.world.own(1, {1.5, 0}).opponent(0, {2.9, keeper_y_m});
  return shot_from(stage.look(), 1, {1.6, 0}).strike.target_m;
}

TEST(ShotFrom, AimsAtTheLargerOpeningBesideTheKeeper) {
  EXPECT_LT(target_past_keeper_m(0.12).y(), -0.05);
  EXPECT_GT(target_past_keeper_m(-0.12).y(), 0.05);
}

TEST(ShotFrom, AimsAtAPointOnTheGoalLine) {
  EXPECT_EQ(target_past_keeper_m(0.12).x(), kGoal_m);
  EXPECT_EQ(target_past_keeper_m(-0.12).x(), kGoal_m);
}

TEST(ShotFrom, HasANegativeValueIfTheGoalIsBlocked) {
  StagedPrediction stage(Play::kRunning);
  stage.world.own(1, {1, 0}).opponent(0, {1.35, 0.08}).opponent(1, {1.35, -0.08});
  EXPECT_LE(shot_from(stage.look(), 1, {1.1, 0}).worth, 0);
}

TEST(ShotFrom, IsWorthMoreThanAnyPassIfTheGoalIsOpen) {
  StagedPrediction stage(Play::kRunning);
  stage.world.own(1, {1.5, 0}).own(2, {1.5, 1.2}).opponent(0, {0, -1.5});
  const PredictedState& predicted = stage.look();
  EXPECT_GT(shot_from(predicted, 1, {1.6, 0}).worth, pass_to(predicted, 1, 1.0, {1.6, 0}).worth);
}

// A pass from robot 1's ball at the origin to robot 2.
struct PassOver : StagedPrediction {
  explicit PassOver(const Vec2& mate_m, const TeamContext& context = {})
      : StagedPrediction(Play::kRunning, false, context) {
    world.own(1, {-0.1, 0}).own(2, mate_m);
  }
  double pass_worth() { return pass_to(look(), 1, kSomeChance, {0, 0}).worth; }
  double chip_worth() { return chip_to(look(), 1, kSomeChance, {0, 0}).worth; }
};

TEST(PassTo, IsWorthLessIfARobotIsInTheLane) {
  PassOver open({2, 0});
  PassOver shut({2, 0});
  shut.world.opponent(1, {0.8, 0});
  EXPECT_GT(open.pass_worth(), 0);
  EXPECT_LT(shut.pass_worth(), 0);
}

TEST(PassTo, IsRejectedForAMateThatIsTooNear) {
  PassOver near({0.3, 0.2});
  EXPECT_EQ(near.pass_worth(), kWorthNothing);
}

TEST(PassTo, ArrivesWithTheStylesSpeed) {
  PassOver stage({2, 0});
  const Choice pass = pass_to(stage.look(), 1, kSomeChance, {0, 0});
  EXPECT_NEAR(pass.strike.kick_mps, kick_for_mps(2, Style{}.pass_arrival_mps), 0.01);
  EXPECT_EQ(pass.receiver, 2);
}

TEST(PassTo, IsRejectedForAMateThatMustNotTouchTheBallThere) {
  PassOver own_area({-4, 0.5}, team_context_of("2026-b"));
  EXPECT_EQ(own_area.pass_worth(), kWorthNothing);
  EXPECT_EQ(own_area.chip_worth(), kWorthNothing);
  PassOver their_area({4, 0.5}, team_context_of("2026-b"));
  EXPECT_EQ(their_area.pass_worth(), kWorthNothing);
  EXPECT_EQ(their_area.chip_worth(), kWorthNothing);
}

TEST(ChipTo, FliesOverARobotThatStopsAPass) {
  PassOver stage({2.2, 0});
  stage.world.opponent(1, {0.6, 0});
  EXPECT_LT(stage.pass_worth(), 0);
  EXPECT_GT(stage.chip_worth(), 0);
}

double chip_worth_over(const Vec2& opponent_m) {
  PassOver stage({2.2, 0});
  stage.world.opponent(1, opponent_m);
  return stage.chip_worth();
}

TEST(ChipTo, DoesNotFlyOverARobotAtTheBallOrWhereItLands) {
  EXPECT_LT(chip_worth_over({0.25, 0}), 0);
  EXPECT_LT(chip_worth_over({1.2, 0}), 0);  // the mate is 1 m behind the landing point
}

// At 45 degrees the chip lands after v^2/g, which should be 1 m before the mate.
TEST(ChipTo, LandsAMetreBeforeTheMate) {
  PassOver stage({2.2, 0});
  const Choice chip = chip_to(stage.look(), 1, kSomeChance, {0, 0});
  EXPECT_TRUE(chip.strike.chip);
  EXPECT_NEAR(chip.strike.kick_mps * chip.strike.kick_mps / 9.81, 1.2, 0.01);
}

TEST(ChipTo, IsRejectedIfTheRobotsCannotChipThatFarOrAtAll) {
  PassOver with_weak_robots({2.2, 0}, context_without_chips());
  EXPECT_EQ(with_weak_robots.chip_worth(), kWorthNothing);
  PassOver far({5, 0});  // a 5.5 m/s chip lands after 3.1 m
  EXPECT_EQ(far.chip_worth(), kWorthNothing);
}

double carry_worth_before(double opponent_x_m) {
  StagedPrediction stage(Play::kRunning);
  stage.world.own(1, {-0.1, 0}).opponent(1, {opponent_x_m, 0});
  return carry_from(stage.look(), {0, 0}).worth;
}

TEST(CarryFrom, IsWorthLessTheNearerAnOpponentIs) {
  EXPECT_LT(carry_worth_before(0.55), 1);
  EXPECT_LT(carry_worth_before(0.4), carry_worth_before(0.55));
  EXPECT_LT(carry_worth_before(0.25), carry_worth_before(0.4));
}

// The target of a robot at (-1, 0), pressed from the front and by an opponent at that y.
Vec2 cleared_to_m(double presser_y_m) {
  StagedPrediction stage(Play::kRunning);
  stage.world.own(1, {-1.1, 0}).opponent(1, {-0.4, 0}).opponent(2, {-0.5, presser_y_m});
  return clear_from(stage.look(), {-1, 0}, {1, 0}).strike.target_m;
}

TEST(ClearFrom, GoesWhereThereIsRoomButNeverBack) {
  EXPECT_LT(cleared_to_m(0.6).y(), -0.2);
  EXPECT_GT(cleared_to_m(-0.6).y(), 0.2);
  EXPECT_GT(cleared_to_m(0.6).x(), -1);
  EXPECT_GT(cleared_to_m(-0.6).x(), -1);
}

}  // namespace
}  // namespace autoref::strategies
