// The foul behaviours of `rowdy`, their view of the game, and the robot motions that they share.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "soccer/field.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/rules/rule_book.hpp"
#include "soccer/team_view.hpp"
#include "strategies/skills/motion.hpp"

namespace autoref::strategies::rowdy {

// The game in the team's frame, extrapolated to when commands take effect.
struct RowdyView {
  const Field& field;
  const RuleBook& rules;
  const TeamView& now;
  int keeper = 0;  // number of the team's keeper
};

// The robot with that number; nullptr if there is none.
const TrackedRobot* find(const TrackedRobots& robots, int number);

// The team's own robot nearest to a point, excluding the keeper; nullptr if none is within
// `reach_m`.
const TrackedRobot* nearest_mate(const RowdyView& view, const Vec2& point_m, double reach_m);

// The opponent nearest to a point; nullptr if none is within `reach_m`.
const TrackedRobot* nearest_opponent(const RowdyView& view, const Vec2& point_m, double reach_m);

// Whether the robot has the ball at its front plate, within about 15 mm.
bool has_ball(const TrackedRobot& robot, const TrackedBall& ball);

bool is_running(const RowdyView& view);
// Whether the team takes, or the opponents are about to take, a restart other than a penalty.
bool is_own_restart(const RowdyView& view);
bool is_opponents_restart(const RowdyView& view);
bool is_free_kick(Play play);

// Commands that drive the robot to a position, around all other robots, facing the ball.
RobotCommand go_to(const RowdyView& view, const TrackedRobot& robot, const Vec2& position_m);

// Commands that drive the robot straight ahead with that velocity, facing its direction of motion.
RobotCommand charge(const TrackedRobot& robot, const Vec2& velocity_mps);

// Commands that drive the robot straight towards a point.
RobotCommand charge_at(const TrackedRobot& robot, const Vec2& point_m, double speed_mps);

// Commands that drive the robot behind the ball and kick it straight at the target.
RobotCommand kick_at(const RowdyView& view, const TrackedRobot& robot, const Vec2& target_m,
                     double kick_mps);

// Stops the team-mates of robot `number` that are within `reach_m` of a point.
void hold_back(const RowdyView& view, int number, const Vec2& point_m, double reach_m,
               TeamCommands& commands);

// Sends team-mates of robot `number`, including the keeper, out of the path from `from_m` to
// `to_m`.
void clear_lane(const RowdyView& view, int number, const Vec2& from_m, const Vec2& to_m,
                TeamCommands& commands);

// A foul behaviour under way.
struct ActiveFoul {
  int robot = -1;  // number of the offending robot; -1 if the whole team offends
  int other = -1;  // number of the opponent that is fouled
  // Random value in [0, 1) that sets a distance or duration, depending on the kind.
  double amount = 0;
  double begun_s = 0;  // view time at which the foul began
  // Position of the ball when the foul began, or another point, depending on the kind.
  Vec2 from_m{0, 0};
  bool is_halfway = false;  // whether the first of two parts is done, for kinds with two parts
};

// The commands and requests that the team is about to send.
struct TeamOutput {
  TeamCommands& commands;
  TeamRequests& requests;
  RobotCommand& command(int number) const { return commands[static_cast<std::size_t>(number)]; }
};

// A foul by `robot`; nullopt if `robot` is null.
inline std::optional<ActiveFoul> foul_by(const TrackedRobot* robot, const Vec2& from_m) {
  if (robot == nullptr) return std::nullopt;
  ActiveFoul foul;
  foul.robot = robot->number;
  foul.from_m = from_m;
  return foul;
}

// A foul by `robot` against an opponent.
inline ActiveFoul foul_against(const TrackedRobot& victim, const TrackedRobot& robot) {
  ActiveFoul foul = *foul_by(&robot, victim.position_m);
  foul.other = victim.number;
  return foul;
}

// The opponent that is fouled; nullptr if that robot is gone or the ball is not in play.
inline const TrackedRobot* victim_of(const ActiveFoul& foul, const RowdyView& view) {
  return is_running(view) ? find(view.now.opponents, foul.other) : nullptr;
}

// A way of breaking a rule: how the team finds an opportunity for it, and what it then does. Each
// way has its own file in kinds/.
struct FoulBehaviour {
  std::string_view name;  // name of the parameter that sets `share`
  std::string_view about;
  double share;      // default fraction of opportunities taken
  double longest_s;  // after this time, the foul is abandoned
  // The foul that is possible now, with `amount` and `begun_s` not yet set; nullopt if there is no
  // opportunity.
  std::optional<ActiveFoul> (*find_chance)(const RowdyView& view);
  // Changes the team's output. Returns false once the foul is over. If the foul names an offending
  // robot, that robot must be on the field.
  bool (*go_on)(const RowdyView& view, ActiveFoul& foul, TeamOutput& output);
};

extern const FoulBehaviour kAimlessKick;
extern const FoulBehaviour kAttackInArea;
extern const FoulBehaviour kChipGoal;
extern const FoulBehaviour kCrowdRestart;
extern const FoulBehaviour kDelay;
extern const FoulBehaviour kHardKick;
extern const FoulBehaviour kIndirectShot;
extern const FoulBehaviour kKeeperHold;
extern const FoulBehaviour kKeeperOffLine;
extern const FoulBehaviour kKickoffIntruder;
extern const FoulBehaviour kLongDribble;
extern const FoulBehaviour kNearArea;
extern const FoulBehaviour kOwnGoalKick;
extern const FoulBehaviour kPenaltyCrowd;
extern const FoulBehaviour kPlayAtOwnArea;
extern const FoulBehaviour kPlayInOwnArea;
extern const FoulBehaviour kRam;
extern const FoulBehaviour kRamEvenly;
extern const FoulBehaviour kSecondTouch;
extern const FoulBehaviour kShove;
extern const FoulBehaviour kStopCrowd;
extern const FoulBehaviour kStopSprint;
extern const FoulBehaviour kTimeout;

inline constexpr int kKindCount = 23;

// All kinds, in the order in which they are considered if several have an opportunity in the same
// frame.
std::span<const FoulBehaviour* const, kKindCount> all_kinds();

}  // namespace autoref::strategies::rowdy
