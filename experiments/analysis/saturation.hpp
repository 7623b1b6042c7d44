// Opponents that hardly show differences between the teams that play them, since the games are too
// one-sided.
#pragma once

#include <string>
#include <vector>

#include "experiments/analysis/groups.hpp"
#include "game/settings/game_settings.hpp"

namespace autoref::experiments {

// A sentence if at least half of the games against the opponent ended early by the lead in goals
// (then the goal difference says little about how much better a team was), or if one side won all
// of them: what happened, and which opponents would show more. Empty otherwise, and for fewer than
// 10 games. The opponent is team b of `games`; `its` are its settings.
std::string saturation_text(const std::string& opponent, const game::TeamSettings& its,
                            const std::vector<const Group*>& games);

}  // namespace autoref::experiments
