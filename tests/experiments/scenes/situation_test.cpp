// Start states that are drawn.
#include "experiments/scenes/situation.hpp"

#include <gtest/gtest.h>

#include "game/settings/setting_value.hpp"

namespace autoref::experiments {
namespace {

DrawnRobot robot_at(int number, const Distribution& x_m, const Distribution& y_m) {
  DrawnRobot robot;
  robot.number = number;
  robot.x_m = x_m;
  robot.y_m = y_m;
  return robot;
}

SituationSetup drawn_situation() {
  SituationSetup situation;
  situation.ball.x_m = Distribution::uniform(1, 2);
  situation.attackers = {robot_at(1, -1, Distribution::normal(0, 0.2)),
                         robot_at(4, -2, Distribution::uniform(-1, 1))};
  situation.defenders = {robot_at(0, 2.8, 0)};
  situation.defenders[0].vx_mps = -1;
  return situation;
}

game::StartState drawn_from(const SituationSetup& situation, std::uint64_t seed = 7,
                            int scene = 1) {
  return drawn_state(situation, "corner", Field{}, seed, scene);
}

TEST(DrawnState, IsTheSameEveryTimeAndAnotherForEachSceneAndSeed) {
  const SituationSetup situation = drawn_situation();
  const Vec2 ball_m = drawn_from(situation).ball.position_m;
  EXPECT_EQ(drawn_from(situation).ball.position_m, ball_m);
  EXPECT_NE(drawn_from(situation, 7, 2).ball.position_m, ball_m);
  EXPECT_NE(drawn_from(situation, 8).ball.position_m, ball_m);
  EXPECT_NE(drawn_state(situation, "free_kick", Field{}, 7, 1).ball.position_m, ball_m);
}

TEST(DrawnState, DrawsEachNumberIndependentlyOfTheOthers) {
  SituationSetup situation = drawn_situation();
  const game::StartState before = drawn_from(situation);
  std::swap(situation.attackers[0], situation.attackers[1]);
  situation.attackers.pop_back();
  situation.defenders.push_back(robot_at(3, Distribution::uniform(0, 0.5), 1.5));
  const game::StartState after = drawn_from(situation);
  EXPECT_EQ(after.ball.position_m, before.ball.position_m);
  EXPECT_EQ(after.robots[Side::kWest][0].position_m, before.robots[Side::kWest][1].position_m);
}

TEST(DrawnState, FacesTheBallUnlessAHeadingIsGiven) {
  SituationSetup situation = drawn_situation();
  situation.attackers[0].y_m = 0;
  situation.defenders[0].heading_deg = 90;
  const game::StartState state = drawn_from(situation);
  EXPECT_NEAR(state.robots[Side::kWest][0].heading.x(), 1, 1e-9);
  EXPECT_NEAR(state.robots[Side::kEast][0].heading.y(), 1, 1e-9);
}

TEST(DrawnState, HasTheVelocitiesAndTheRestartOfTheAttackers) {
  SituationSetup situation = drawn_situation();
  situation.restart = Restart::kDirectFree;
  const game::StartState state = drawn_from(situation);
  EXPECT_EQ(state.robots[Side::kEast][0].velocity_mps, Vec2(-1, 0));
  EXPECT_EQ(state.referee.restart, (Command{CommandKind::kDirectFree, Side::kWest}));
  EXPECT_EQ(state.referee.ball_m, state.ball.position_m);
}

TEST(DrawnState, HasTheRestartOfTheDefendersIfTheyTakeIt) {
  SituationSetup situation = drawn_situation();
  situation.restart = Restart::kPenalty;
  situation.is_attackers_restart = false;
  situation.is_after_stop = true;
  const referee::MidwayStart midway_start = drawn_from(situation).referee;
  EXPECT_EQ(midway_start.restart, (Command{CommandKind::kPreparePenalty, Side::kEast}));
  EXPECT_TRUE(midway_start.is_stopped);
}

TEST(DrawnState, IsDrawnAgainWhileBodiesOverlap) {
  SituationSetup situation = drawn_situation();
  situation.attackers[0].x_m = situation.attackers[1].x_m = -1;
  situation.attackers[0].y_m = situation.attackers[1].y_m = Distribution::uniform(0, 0.5);
  for (int scene = 1; scene <= 50; ++scene) {
    const auto robots = drawn_from(situation, 7, scene).robots[Side::kWest];
    EXPECT_GE((robots[0].position_m - robots[1].position_m).norm(), 0.169) << scene;
  }
}

std::string drawing_error_of(const SituationSetup& situation) {
  try {
    drawn_from(situation);
  } catch (const game::SettingError& error) {
    EXPECT_EQ(error.path(), "situations.corner");
    return error.what();
  }
  return "drawn";
}

TEST(DrawnState, IsAnErrorIfBodiesAlwaysOverlap) {
  SituationSetup situation = drawn_situation();
  situation.attackers[0].x_m = 2.8;
  situation.attackers[0].y_m = 0.1;
  EXPECT_EQ(drawing_error_of(situation),
            "situations.corner: 100 draws of scene 1 failed; in the last one attackers.1 and "
            "defenders.0 overlap");
}

TEST(DrawnState, IsAnErrorIfTheBallOfARestartIsOutside) {
  SituationSetup situation = drawn_situation();
  situation.ball.x_m = 3.2;
  situation.restart = Restart::kDirectFree;
  EXPECT_NE(drawing_error_of(situation).find("the ball of the restart is outside the field"),
            std::string::npos);
}

TEST(MirroredState, IsTurnedAndHasTheSidesSwapped) {
  SituationSetup situation = drawn_situation();
  situation.restart = Restart::kPenalty;
  const game::StartState state = drawn_from(situation);
  const game::StartState other = game::mirrored(state);
  EXPECT_EQ(other.ball.position_m, Vec2(-state.ball.position_m));
  EXPECT_EQ(other.robots[Side::kEast][1].position_m,
            Vec2(-state.robots[Side::kWest][1].position_m));
  EXPECT_EQ(other.robots[Side::kWest][0].velocity_mps, Vec2(1, 0));
  EXPECT_EQ(other.referee.restart, (Command{CommandKind::kPreparePenalty, Side::kEast}));
  EXPECT_EQ(game::mirrored(other).robots[Side::kWest][1].position_m,
            state.robots[Side::kWest][1].position_m);
}

}  // namespace
}  // namespace autoref::experiments
