// The foul behaviours' view of the game, and the robot motions that they share.
#pragma once

#include <optional>

#include "soccer/field.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/rule_book.hpp"
#include "soccer/team_view.hpp"
#include "strategies/skills/motion.hpp"

namespace autoref::strategies::rowdy {

// The game in the team's frame, extrapolated to when commands take effect.
struct Scene {
  const Field& field;
  const RuleBook& rules;
  const TeamView& now;
  int keeper = 0;  // number of the team's keeper
};

// The robot with that number; nullptr if there is none.
const TrackedRobot* find(const TrackedRobots& robots, int number);

// The team's own robot nearest to a point, excluding the keeper; nullptr if none is within
// `reach_m`.
const TrackedRobot* nearest_mate(const Scene& scene, const Vec2& point_m, double reach_m);

// The same for opponents.
const TrackedRobot* nearest_opponent(const Scene& scene, const Vec2& point_m, double reach_m);

// Whether the robot has the ball at its front plate, within about 15 mm.
bool has_ball(const TrackedRobot& robot, const TrackedBall& ball);

bool is_running(const Scene& scene);
// Whether the team takes, or the opponents are about to take, a restart other than a penalty.
bool is_own_restart(const Scene& scene);
bool is_opponents_restart(const Scene& scene);
bool is_free_kick(Play play);

// Commands that drive the robot to a position around everybody else, facing the ball.
RobotCommand go_to(const Scene& scene, const TrackedRobot& robot, const Vec2& position_m);

// Commands that drive the robot straight with that velocity, facing its direction of motion.
RobotCommand charge(const TrackedRobot& robot, const Vec2& velocity_mps);

// Commands that drive the robot straight towards a point.
RobotCommand charge_at(const TrackedRobot& robot, const Vec2& point_m, double speed_mps);

// Commands that drive the robot behind the ball and kick it straight at the target.
RobotCommand kick_at(const Scene& scene, const TrackedRobot& robot, const Vec2& target_m,
                     double kick_mps);

// Stops the team-mates of robot `number` that are within `reach_m` of a point.
void hold_back(const Scene& scene, int number, const Vec2& point_m, double reach_m,
               TeamCommands& commands);

// Sends team-mates of robot `number`, including the keeper, out of the path from `from_m` to
// `to_m`.
void clear_lane(const Scene& scene, int number, const Vec2& from_m, const Vec2& to_m,
                TeamCommands& commands);

}  // namespace autoref::strategies::rowdy
