// The plays: which parts the robots get in which situation. Each fills the cast that is still free.
#pragma once

#include <array>

#include "strategies/plays/role_assignment.hpp"
#include "strategies/tactics/handle_ball.hpp"
#include "strategies/tactics/pass_field.hpp"

namespace autoref::strategies {

// What plays look at and remember.
struct PlayContext {
  const PredictedState& predicted;
  const BallHandler& handler;
  PassField& field;
  int former = -1;          // number of the robot that had the ball's part in the last frame
  int restarter = -1;       // number of the robot that must not touch the ball again yet
  int stuck = -1;           // number of the robot that could not take the restart at hand
  double waited_s = 0;      // since play last changed
  double taker_from_s = 0;  // so long had been waited when the taker of the restart was chosen
  bool is_settled = false;  // play has been stopped for so long that places are kept
  // By number of robot, the key of the post that it mans; 0: none (formation_spots.hpp).
  std::array<int, kMaxRobots> spots{};
};

// The robot that goes for the ball: who gets there first, the former one and a pass's receiver
// preferred; -1 without free robots.
int choose_for_ball(const PlayContext& book, const RoleAssignment& assignment);

// While the ball runs.
void open_play(PlayContext& book, RoleAssignment& assignment);

// While play is stopped before the team's own restart: who will take it waits where it looks to the
// receiver whom a pass serves best.
void line_up_taker(const PlayContext& book, RoleAssignment& assignment);

// The team's own restart once it may be taken: the others stay where `assignment` has them.
void take_restart(PlayContext& book, RoleAssignment& assignment);

// While play is stopped and at the opponents' restarts.
void await_restart(PlayContext& book, RoleAssignment& assignment);

// Before and at a kick-off.
void await_kickoff(PlayContext& book, RoleAssignment& assignment);

// Before and at a penalty kick.
void penalty(PlayContext& book, RoleAssignment& assignment);

// What every play begins with while the ball runs: who keeps the goal and who goes for the ball.
void give_goal_and_ball(PlayContext& book, RoleAssignment& assignment);

// The same while play is stopped: who keeps the goal, and who waits to take or to block the
// restart.
void give_goal_and_restart(PlayContext& book, RoleAssignment& assignment);

// The backs: a wall of up to `wall` robots, then markers for up to `markers` opponents.
void defend(PlayContext& book, RoleAssignment& assignment, int wall, int markers);

// Who finds nobody to mark: up to `count` robots one behind the other on the way from ball to goal.
void cover(const PlayContext& book, RoleAssignment& assignment, int count);

// All who are still free run for passes.
void run_for_passes(PlayContext& book, RoleAssignment& assignment);

}  // namespace autoref::strategies
