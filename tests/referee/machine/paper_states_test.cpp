// One test per sentence of the paper's section 4.3 that describes a state; suites are named after
// the section and paragraph.
#include <gtest/gtest.h>

#include "tests/referee/support/scripted_game.hpp"

namespace autoref::referee {
namespace {

// "RUN: ... AutoRef observes the state of the game until a condition is met"
TEST(Paper43States, RunLastsUntilSomethingHappens) {
  ScriptedGame game = in_play();
  game.run(8);
  EXPECT_EQ(game.referee.state(), State::kRun);
  EXPECT_EQ(game.decisions.back().transition, "start");
}

// "WAIT_STOP: In this state, AutoRef waits for all robots to stop moving"
TEST(Paper43States, WaitStopLastsOneCheckPeriodIfAllRobotsStandStill) {
  ScriptedGame game = in_play();
  game.kick_from(Side::kWest, 1, {1, 1.8}, {0, 4});
  const double stopped_s = game.run_until("throw_in").time_s;
  EXPECT_NEAR(game.run_until("start").time_s, stopped_s + 1, 1e-9);
}

// "INIT: This state occurs only once, immediately after execution begins"
TEST(Paper43States, InitOccursOnce) {
  Configuration configuration;
  configuration.half_s = 2;
  configuration.after_game = AfterGame::kNewGame;
  ScriptedGame game(configuration);
  game.line_up().kick_off();
  game.run(60);
  EXPECT_EQ(game.count("begin"), 1);
  EXPECT_GE(game.referee.games_finished(), 2);
}

// "once all robots have moved, it signals a kickoff and enters WAIT_STOP"; Deviation D5: one robot
// per team is enough.
TEST(Paper43States, WaitStartEndsWithAKickOff) {
  ScriptedGame game;
  game.line_up().kick_off();
  EXPECT_EQ(game.count("clients_moved"), 1);
  EXPECT_EQ(game.count("start_timeout"), 0);
}

// "DELAY_WAIT: This state only occurs for one frame at a time"
TEST(Paper43States, DelayWaitLastsOneFrame) {
  ScriptedGame game = in_play();
  game.kick_from(Side::kWest, 1, {2.5, 0}, {6, 0});
  game.run_until("goal");
  EXPECT_EQ(game.referee.state(), State::kDelayWait);
  game.step();
  EXPECT_EQ(game.referee.state(), State::kWaitStop);
}

}  // namespace
}  // namespace autoref::referee
