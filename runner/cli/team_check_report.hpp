// The result of `autoref team check`, in plain words or as one JSON object.
#pragma once

#include <string>

#include "runner/team_programs/team_check.hpp"

namespace autoref::runner {

std::string text_of(const TeamCheck& check);
std::string json_of(const TeamCheck& check);

}  // namespace autoref::runner
