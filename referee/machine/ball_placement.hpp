// Ball placement by the teams' robots (2026, Ball Placement).
//
// After the STOP of a free kick or a force start, the team due is ordered to place the ball. If it
// fails, the opponents get a free kick and place the ball; if they fail, too, the ball is placed by
// hand (by the simulator) for the original restart.
#pragma once

#include <optional>

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

// Leaves the placement for the finding's restart to a team: the one that takes it, or, before a
// force start, one drawn by lot. The restart is the finding's, unless the team has failed too often
// in this half and the ball went out: then the opponents get it. No effect before kick-offs and
// penalty kicks.
void leave_to_team(RefereeState& state, const RuleBook& rules, const Finding& finding);

// Whether a team places the ball before this restart: before free kicks and force starts. "The
// referee has to place the ball for all kickoffs and all penalty kicks."
bool is_placed_by_team(CommandKind kind);

// Whether a team is due to place the ball, but has not been ordered to.
bool is_placement_due(const RefereeState& state);

// In WAIT_STOP, while a placement is due: decides how the ball gets to its position and reports
// kSignalled, a second after the STOP or once the ball has come to rest nearby.
std::optional<Finding> find_placement_step(RefereeState& state, const RefereeInput& input);

// In PLACEMENT: kPlacementSucceeded, kPlacementFailed, or kSignalled once the ball has come to rest
// out of the robots' reach.
std::optional<Finding> find_placement_outcome(RefereeState& state, const RefereeInput& input);

}  // namespace autoref::referee
