// Ball placement by the teams' robots (2026, Ball Placement).
//
// After the STOP of a free kick or a force start, the team whose turn it is has to place the ball.
// If it fails, the opponents get a free kick and place the ball; if they also fail, the ball is
// placed by hand (by the simulator) for the original restart.
#pragma once

#include <optional>

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

// Leaves the ball placement for the finding's restart to the team that takes the restart or, for a
// force start, to a team drawn by lot. If the ball went out and the team has failed to place it too
// often in this half, the opponents get the restart instead. For kick-offs and penalty kicks, this
// has no effect.
void leave_to_team(RefereeState& state, const RuleBook& rules, const Finding& finding);

// Whether a team places the ball before this restart. Teams place it before free kicks and force
// starts. "The referee has to place the ball for all kickoffs and all penalty kicks."
bool is_placed_by_team(CommandKind kind);

// Whether a team has to place the ball but has not yet been ordered to.
bool is_placement_due(const RefereeState& state);

// In WAIT_STOP, while a placement is pending: decides how the ball gets to its position and reports
// kSignalled. This happens a second after the STOP. If the ball is then still rolling near its
// position or out of the robots' reach, this happens once the ball has come to rest, but near its
// position at the latest 3 s after the STOP.
std::optional<Finding> find_placement_step(RefereeState& state, const RefereeInput& input);

// In PLACEMENT: returns kPlacementSucceeded, kPlacementFailed, or kSignalled once the ball has come
// to rest out of the robots' reach.
std::optional<Finding> find_placement_outcome(RefereeState& state, const RefereeInput& input);

}  // namespace autoref::referee
