// Opponents that hardly show differences between the teams that play them, since the games are too
// one-sided.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/analysis/groups.hpp"
#include "game/settings/game_settings.hpp"

namespace autoref::experiments {

// A note if each group has at least 10 games, and in each of them the same side
//
//   - ended at least half of the games early by its lead in goals: the goal difference then says
//     little about how much better a team was; or
//   - won all games: then only the goal difference tells the teams apart.
//
// The note says what happened and which opponents would show more; `otherwise` is what else the
// user can do, as in "or let the teams play each other". Empty in all other cases. The opponent,
// with the settings `team`, is team b of the groups, one for each team that it plays.
std::string saturation_text(const std::string& opponent, const game::TeamSettings& team,
                            const std::vector<const Group*>& groups, std::string_view otherwise);

}  // namespace autoref::experiments
