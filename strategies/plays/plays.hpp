// The plays, which decide the robots' roles in each situation. Each play fills in a RoleAssignment.
#pragma once

#include <array>
#include <cstdint>

#include "strategies/tactics/handle_ball.hpp"
#include "strategies/tactics/pass_field.hpp"
#include "strategies/tactics/predicted_state.hpp"

namespace autoref::strategies {

// The assignment of roles to robots.
enum class Role : std::uint8_t { kNone, kKeeper, kGoalLine, kBall, kReceiver, kStands, kTaker };

// A robot's role, and its target position if the role has one.
struct Task {
  Role role = Role::kNone;
  Waypoint waypoint;
};

class RoleAssignment {
 public:
  explicit RoleAssignment(const PredictedState& predicted) : predicted_(&predicted) {}

  bool is_free(int index) const { return task(index).role == Role::kNone; }
  const Task& task(int index) const { return tasks_[static_cast<std::size_t>(index)]; }
  int free_robots() const;

  void give(int index, Role role, const Waypoint& waypoint = {});

  // The free robot nearest to the position, extrapolated by the style's moves_on_s; -1 if there is
  // none.
  int nearest_free(const Vec2& position_m) const;

  // Moves all positions to permitted ones, and moves them apart if robots would overlap.
  void spread();

  // Sends the nearest free robot to the waypoint, if there is a free robot.
  void send_nearest(const Waypoint& waypoint);

 private:
  const PredictedState* predicted_;
  std::array<Task, kMaxRobots> tasks_;
};

// The data that plays read, and the data that they store from frame to frame.
struct PlayContext {
  const PredictedState& predicted;
  const BallHandler& handler;
  PassField& field;
  int former = -1;          // number of the robot at the ball in the previous frame
  int restarter = -1;       // number of the robot that must not yet touch the ball again
  int stuck = -1;           // number of the robot that failed to take this restart
  double waited_s = 0;      // time since play last changed
  double taker_from_s = 0;  // waited_s when the restart's taker was chosen
  // Whether play has been stopped for so long that robots now keep their positions.
  bool is_settled = false;
  // The key of each robot's formation spot, by robot number; 0 for no spot (formation_spots.hpp).
  std::array<int, kMaxRobots> spots{};
};

// The robot that goes for the ball: the fastest one, with a bonus for the previous robot and for
// the receiver of a pass; -1 if there is no free robot.
int choose_for_ball(const PlayContext& book, const RoleAssignment& assignment);

// The play while the ball is in play.
void open_play(PlayContext& book, RoleAssignment& assignment);

// Used while play is stopped before the team's own restart: aligns the taker with the receiver that
// has the best pass.
void line_up_taker(const PlayContext& book, RoleAssignment& assignment);

// The play for the team's own restart, once it can be taken. All robots except the taker keep their
// tasks in `assignment`.
void take_restart(PlayContext& book, RoleAssignment& assignment);

// The play while play is stopped, and at the opponents' restarts.
void await_restart(PlayContext& book, RoleAssignment& assignment);

// The play before and at a kick-off.
void await_kickoff(PlayContext& book, RoleAssignment& assignment);

// The play before and at a penalty kick.
void penalty(PlayContext& book, RoleAssignment& assignment);

// The start of every play while the ball is in play: assigns the keeper and the robot at the ball.
void give_goal_and_ball(PlayContext& book, RoleAssignment& assignment);

// The start of every play while play is stopped: assigns the keeper, and a robot to take or block
// the restart.
void give_goal_and_restart(PlayContext& book, RoleAssignment& assignment);

// Assigns defenders: a wall of up to `wall` robots, then markers for up to `markers` opponents.
void defend(PlayContext& book, RoleAssignment& assignment, int wall, int markers);

// Assigns up to `count` robots that have no opponent to mark to positions between ball and goal,
// one behind the other.
void cover(const PlayContext& book, RoleAssignment& assignment, int count);

// Makes all remaining free robots run for passes.
void run_for_passes(PlayContext& book, RoleAssignment& assignment);

}  // namespace autoref::strategies
