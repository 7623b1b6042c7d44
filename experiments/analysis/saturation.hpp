// Opponents that are too strong or too weak for a comparison of the teams that play them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/analysis/groups.hpp"
#include "game/settings/game_settings.hpp"

namespace autoref::experiments {

// A note if each group has at least 10 games, and the same side was so much stronger in all groups
// that
//
//   - at least half of a group's games ended early because of its lead: the goal difference then
//     says little about how much better a team was; or
//   - it won all games of a group: then only the goal difference shows which team is better.
//
// The note says what happened and which opponents to choose; `otherwise` is what else the user can
// do, as in "or let the teams play each other". Empty in all other cases. The opponent, with the
// settings `team`, is team b of the groups, one for each team that it plays.
std::string saturation_text(const std::string& opponent, const game::TeamSettings& team,
                            const std::vector<const Group*>& groups, std::string_view otherwise);

}  // namespace autoref::experiments
