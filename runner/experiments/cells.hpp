// The games that an experiment's varied values make.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "runner/experiments/judge_schedule.hpp"
#include "runner/experiments/scenario.hpp"
#include "runner/settings/game_settings.hpp"

namespace autoref::runner {

// A sweep's base with these values of its factors. Throws SettingError where they do not go
// together.
GameSettings configured(const Sweep& sweep, const std::vector<SettingValue>& values);

// The cell of these values, as in the ids of its games: "b.handicap=0.5+match.rules=2014".
std::string cell_name(const Sweep& sweep, const std::vector<SettingValue>& values);

// A judge's base under a rule book and a camera.
GameSettings configured(const JudgeSchedule& schedule, const std::string& rules,
                        const std::string& camera);

// What presets and handicaps among the varied values set, without what the user has set singly: for
// each value, such as "match.rules=2014", the settings by full path. The values of one key have the
// same paths; the paths of two keys differ, so that a cell plays what its values set.
using SetByValues = std::map<std::string, std::map<std::string, std::string>>;
SetByValues set_by_values(const Sweep& sweep);
SetByValues set_by_values(const JudgeSchedule& schedule);

}  // namespace autoref::runner
