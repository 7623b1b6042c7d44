// Tunables of `basic`, the roles of its robots, and the positions of robots that do not play the
// ball.
#pragma once

#include <array>
#include <cstdint>

#include "soccer/field.hpp"
#include "soccer/parameters.hpp"
#include "soccer/team_view.hpp"
#include "soccer/units.hpp"
#include "strategies/skills/motion.hpp"
#include "strategies/skills/prediction.hpp"

namespace autoref::strategies::basic {

// The tunables of `basic`: the parameters in basic_style.def, each with its default.
struct Style {
#define AUTOREF_TUNABLE(type, name, value, ...) type name = value;
#include "strategies/basic/basic_style.def"
#undef AUTOREF_TUNABLE

  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
#define AUTOREF_TUNABLE(type, name, value, range, about) visitor(self.name, {#name, range, about});
#include "strategies/basic/basic_style.def"
#undef AUTOREF_TUNABLE
  }
};

// The keeper's position: in the path of a shot, or else between the ball and the goal's centre.
Waypoint keeper_position(const Field& field, const Style& style, const TrackedBall& ball);

// A position in front of the team's own area, on the line from the ball to the goal's centre. The
// second robot (`order` 1) stands next to the first.
Waypoint wall_position(const Field& field, const Style& style, const Vec2& ball_m, int order);

// A position close to an opponent, on its path to the team's own goal, facing the ball.
Waypoint marker_position(const Field& field, const Style& style, const TrackedRobot& opponent,
                         const Vec2& ball_m);

// A position from which a robot can receive a pass or a rebound. The first supporter stands on the
// side away from the ball; the others are spread along and across the field. `order` counts from 0.
Waypoint supporter_position(const Field& field, const Style& style, const Vec2& ball_m, int order);

// A position in the team's own half for a robot beyond the first four while play is stopped. Each
// of these robots has a different position. `index` counts from 0.
Waypoint reserve_position(const Field& field, const Vec2& ball_m, int index);

enum class Role : std::uint8_t { kKeeper, kAttacker, kWall, kSupporter, kMarker };

// One robot's role and, for markers, the opponent to mark (index in the view).
struct AssignedRole {
  Role role = Role::kSupporter;
  int marks = -1;
  int rank = 0;  // number among the supporters, from 0
};

// The roles of the team's own robots, by their index in the view.
struct RoleAssignment {
  std::array<AssignedRole, kMaxRobots> roles;
  int attacker = -1;          // index in the view; -1 if there is none
  Interception interception;  // where and when the attacker reaches the ball
};

// Assigns the roles. The robot with the lowest number keeps the goal, unless it is the only robot.
// The robot that can reach the ball first attacks. If `former_attacker`, a robot number, attacked
// before, it remains the attacker unless another robot is clearly faster. The robot nearest to the
// team's own goal forms the wall; with five or more robots, the second-nearest joins it. One robot
// supports. Each of the remaining robots marks an opponent in the team's own half, or supports if
// no opponent is left. The robot with the number `barred` does not attack; -1 bars no robot.
RoleAssignment assign_roles(const TeamView& view, const Field& field, const Style& style,
                            int former_attacker, int barred = -1);

}  // namespace autoref::strategies::basic
