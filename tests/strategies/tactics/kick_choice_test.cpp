#include "strategies/tactics/kick_choice.hpp"

#include <gtest/gtest.h>

#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {
namespace {

constexpr double kGoal_m = 3.025;    // x of the opponents' goal line
constexpr double kSomeChance = 0.3;  // scoring chance of a team-mate's shot
constexpr double kWorthNothing = -1;

TEST(ShotFrom, AimsAtTheLargerOpeningBesideTheKeeper) {
  for (const double side : {1.0, -1.0}) {
    StagedPrediction stage(Play::kRunning);
    stage.world.own(1, {1.5, 0}).opponent(0, {2.9, side * 0.12});
    const Choice shot = shot_from(stage.look(), 1, {1.6, 0});
    EXPECT_LT(shot.strike.target_m.y() * side, -0.05);
    EXPECT_EQ(shot.strike.target_m.x(), kGoal_m);
  }
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
  for (const double x_m : {-4.0, 4.0}) {  // in the defence areas of that rule book
    PassOver stage({x_m, 0.5}, team_context_of("2026-b"));
    EXPECT_EQ(stage.pass_worth(), kWorthNothing) << x_m;
    EXPECT_EQ(stage.chip_worth(), kWorthNothing) << x_m;
  }
}

TEST(ChipTo, FliesOverARobotThatStopsAPass) {
  PassOver stage({2.2, 0});
  stage.world.opponent(1, {0.6, 0});
  EXPECT_LT(stage.pass_worth(), 0);
  EXPECT_GT(stage.chip_worth(), 0);
}

TEST(ChipTo, DoesNotFlyOverARobotAtTheBallOrWhereItLands) {
  for (const double x_m : {0.25, 1.2}) {  // the mate is 1 m behind the landing point
    PassOver stage({2.2, 0});
    stage.world.opponent(1, {x_m, 0});
    EXPECT_LT(stage.chip_worth(), 0) << x_m;
  }
}

// At 45 degrees the chip lands after v^2/g, which should be 1 m before the mate.
TEST(ChipTo, LandsAMetreBeforeTheMate) {
  PassOver stage({2.2, 0});
  const Choice chip = chip_to(stage.look(), 1, kSomeChance, {0, 0});
  EXPECT_TRUE(chip.strike.chip);
  EXPECT_NEAR(chip.strike.kick_mps * chip.strike.kick_mps / 9.81, 1.2, 0.01);
}

TEST(ChipTo, IsRejectedIfTheRobotsCannotChipThatFarOrAtAll) {
  TeamContext weak;
  for (Abilities& robot : weak.robots) robot.chip_mps = 0;
  PassOver with_weak_robots({2.2, 0}, weak);
  EXPECT_EQ(with_weak_robots.chip_worth(), kWorthNothing);
  PassOver far({5, 0});  // a 5.5 m/s chip lands after 3.1 m
  EXPECT_EQ(far.chip_worth(), kWorthNothing);
}

TEST(CarryFrom, IsWorthLessTheNearerAnOpponentIs) {
  double former = 1;
  for (const double gap_m : {0.55, 0.4, 0.25}) {
    StagedPrediction stage(Play::kRunning);
    stage.world.own(1, {-0.1, 0}).opponent(1, {gap_m, 0});
    const double worth = carry_from(stage.look(), {0, 0}).worth;
    EXPECT_LT(worth, former) << gap_m;
    former = worth;
  }
}

TEST(ClearFrom, GoesWhereThereIsRoomButNeverBack) {
  for (const double side : {1.0, -1.0}) {
    StagedPrediction stage(Play::kRunning);
    stage.world.own(1, {-1.1, 0}).opponent(1, {-0.4, 0}).opponent(2, {-0.5, side * 0.6});
    const Vec2 from_m(-1, 0);
    const Choice clear = clear_from(stage.look(), from_m, {1, 0});
    EXPECT_LT(clear.strike.target_m.y() * side, -0.2);
    EXPECT_GT(clear.strike.target_m.x(), from_m.x());
  }
}

}  // namespace
}  // namespace autoref::strategies
