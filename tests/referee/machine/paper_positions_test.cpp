// One test per sentence of the paper's section 4.4 that compares positions; suites are named after
// the section and paragraph.
#include <gtest/gtest.h>

#include "referee/machine/readiness.hpp"
#include "tests/referee/support/scripted_game.hpp"

namespace autoref::referee {
namespace {

// "When entering the WAIT_STOP state, AutoRef saves the current positions of the robots"; "every i"
TEST(Paper44RobotPositions, TheLargestMoveOfAnyRobotCounts) {
  ScriptedGame game;
  game.line_up();
  const SavedPositions saved = positions_in(game.frame);
  game.robot(Side::kWest, 2).position_m += Vec2(0.003, 0.004);
  game.robot(Side::kWest, 5).position_m += Vec2(0.006, -0.008);
  const LargestMoves moves = largest_moves(saved, game.frame);
  EXPECT_NEAR(moves.move_m[Side::kWest], 0.010, 1e-12);
  EXPECT_EQ(moves.robot[Side::kWest]->number, 5);
  EXPECT_EQ(moves.move_m[Side::kEast], 0);
}

// "Currently, epsilon is set to 15mm"
// How long a stop lasts if a robot moves by that distance after half a second.
double stop_with_moved_robot_s(double move_m) {
  ScriptedGame game = in_play();
  game.kick_from(Side::kWest, 1, {1, 1.8}, {0, 4});
  const double stopped_s = game.run_until("throw_in").time_s;
  game.run(0.5);
  game.robot(Side::kEast, 4).position_m.x() += move_m;
  return game.run_until("start").time_s - stopped_s;
}

TEST(Paper44RobotPositions, EpsilonIs15Millimetres) {
  EXPECT_NEAR(stop_with_moved_robot_s(0.014), 1, 1e-9);
  EXPECT_NEAR(stop_with_moved_robot_s(0.016), 2, 1e-9);
}

// "If some i violates this condition, then AutoRef ... saves the new positions for later
// comparison"
TEST(Paper44RobotPositions, NewPositionsAreSavedWhenARobotHasMoved) {
  ScriptedGame game = in_play();
  game.kick_from(Side::kWest, 1, {1, 1.8}, {0, 4});
  const double stopped_s = game.run_until("throw_in").time_s;
  game.robot(Side::kEast, 4).position_m.x() += 1;  // far from the first saved position, but at rest
  EXPECT_NEAR(game.run_until("start").time_s, stopped_s + 2, 1e-9);
}

// AutoRef's own rule: the ball must also rest at its position.
TEST(Paper44RobotPositions, PlayWaitsForTheBallAtItsPosition) {
  ScriptedGame game = in_play();
  game.kick_from(Side::kWest, 1, {1, 1.8}, {0, 4});
  game.placement_works = false;
  const double stopped_s = game.run_until("throw_in").time_s;
  game.put_ball({1, 1.5});
  game.run(2.5);
  EXPECT_EQ(game.referee.state(), State::kWaitStop);
  game.put_ball({1.009, 1.925});  // within 10 mm
  EXPECT_NEAR(game.run_until("start").time_s, stopped_s + 3, 0.02);
}

// "it leaves the state when at least one robot on each team has moved a distance greater than
// epsilon"
TEST(Paper44RobotPositions, WaitStartComparesWithThePositionsSavedAtTheBeginning) {
  ScriptedGame game;
  game.line_up().step();
  for (int i = 0; i < 240; ++i) {
    game.robot(Side::kWest, 0).position_m.x() += 0.0001;  // 6 mm in a second
    game.robot(Side::kEast, 0).position_m.x() += 0.0001;
    game.step();
  }
  ASSERT_EQ(game.count("clients_moved"), 1);
  EXPECT_NEAR(game.decisions[1].time_s, 3, 1e-9);
}

// "AutoRef judges that the ball is out of the field if ..."
TEST(Paper44BallPosition, ABallOnTheLineIsIn) {
  ScriptedGame game = in_play();
  game.put_ball({0.5, 2.046});
  game.run(1);
  EXPECT_EQ(game.referee.state(), State::kRun);
  game.put_ball({0.5, 2.047});
  game.step();
  EXPECT_EQ(game.referee.state(), State::kWaitStop);
}

// "compare the current and last positions of the ball to determine where it first was located
// entirely outside the field"
TEST(Paper44BallPosition, AThrowInNearTheCornerIsNotACornerKick) {
  ScriptedGame game = in_play();
  game.kick_from(Side::kEast, 1, {2.80, 1.85}, {5, 5});
  game.run_until("throw_in", 1);
  EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kIndirectFree, Side::kWest}));
}

// "AutoRef judges that the ball is in a goal if the following conditions hold": the height
TEST(Paper44BallPosition, ABallOverTheBarIsNotAGoal) {
  ScriptedGame game = in_play();
  game.kick_from(Side::kWest, 1, {2.5, 0}, {6, 0});
  game.frame.ball->height_m = 0.2;
  game.run_until("goal_kick");
  EXPECT_EQ(game.signal.goals[Side::kWest], 0);
}

TEST(Paper44BallPosition, ABallOfUnknownHeightCountsAsOnTheGround) {
  ScriptedGame game = in_play();
  game.frame.ball->height_m.reset();
  game.kick_from(Side::kWest, 1, {2.5, 0}, {6, 0});
  game.run_until("goal");
  EXPECT_EQ(game.signal.goals[Side::kWest], 1);
}

}  // namespace
}  // namespace autoref::referee
