// The result of `autoref team check`, in plain words or as one JSON object.
#pragma once

#include <string>

#include "game/team_programs/team_check.hpp"

namespace autoref::app {

std::string text_of(const game::TeamCheck& check);
std::string json_of(const game::TeamCheck& check);

}  // namespace autoref::app
