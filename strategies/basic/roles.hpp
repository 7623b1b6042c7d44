// Role assignment of `basic`.
#pragma once

#include <array>
#include <cstdint>

#include "soccer/team_view.hpp"
#include "strategies/basic/style.hpp"
#include "strategies/skills/prediction.hpp"

namespace autoref::strategies::basic {

enum class Role : std::uint8_t { kKeeper, kAttacker, kWall, kSupporter, kMarker };

// One robot's role. For markers, also the opponent (index in the view).
struct AssignedRole {
  Role role = Role::kSupporter;
  int marks = -1;
  int rank = 0;  // number among the supporters, from 0
};

// Roles by index in the view's own robots.
struct RoleAssignment {
  std::array<AssignedRole, kMaxRobots> roles;
  int attacker = -1;          // index in the view; -1 if there is none
  Interception interception;  // where and when the attacker reaches the ball
};

// Assigns the roles. The lowest number keeps the goal, unless it is alone. The robot that meets the
// ball first attacks; `former_attacker`, a robot's number, continues unless another is clearly
// faster. The robot nearest to the team's own goal forms the wall, with five or more robots also
// the second-nearest. One robot supports. Each of the others marks an opponent in the team's own
// half, or supports if no opponent is left. The robot with the number `barred` does not attack; -1:
// all may.
RoleAssignment assign_roles(const TeamView& view, const Field& field, const Style& style,
                            int former_attacker, int barred = -1);

}  // namespace autoref::strategies::basic
