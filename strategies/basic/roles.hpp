// Who does what in `basic`.
#pragma once

#include <array>
#include <cstdint>

#include "soccer/team_view.hpp"
#include "strategies/basic/style.hpp"
#include "strategies/skills/prediction.hpp"

namespace autoref::strategies::basic {

enum class Role : std::uint8_t { kKeeper, kAttacker, kWall, kSupporter, kMarker };

// One robot's part: for markers the opponent (index in the view) they mark.
struct AssignedRole {
  Role role = Role::kSupporter;
  int marks = -1;
  int rank = 0;  // counts the supporters
};

// Parts by index in the view's own robots.
struct RoleAssignment {
  std::array<AssignedRole, kMaxRobots> roles;
  int attacker = -1;          // index in the view; -1 where there is none
  Interception interception;  // the attacker's with the ball
};

// Gives out the parts. The lowest number keeps the goal, except alone. The robot that meets the
// ball first attacks; `former_attacker`, a robot's number, goes on unless another is clearly
// faster. The next nearest to the own goal is the wall. One robot supports; of the others each
// marks an opponent in the own half while there are such, and supports else.
RoleAssignment assign_roles(const TeamView& view, const Field& field, const Style& style,
                            int former_attacker);

}  // namespace autoref::strategies::basic
