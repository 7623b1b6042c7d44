// The cameras in the log of a simulated game.
#pragma once

#include <vector>

#include "game/loop/configuration.hpp"
#include "soccer/frame.hpp"

namespace autoref::logs {

// The cameras that saw the game. Four cameras that report the ball's height see everything, so the
// frames do not depend on them; a log then has the cameras that the league uses: one above a field
// of Division B (from 9 m long), two above a field of Division A (from 12 m), else four.
std::vector<CameraPosition> logged_cameras(const game::GameConfiguration& game);

}  // namespace autoref::logs
