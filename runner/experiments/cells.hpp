// The cells of an experiment: its base combined with each combination of the varied values.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "runner/experiments/judge_schedule.hpp"
#include "runner/experiments/scenario.hpp"
#include "runner/settings/game_settings.hpp"

namespace autoref::runner {

// A sweep's base with its factors set to these values. Throws SettingError if they contradict each
// other.
GameSettings configured(const Sweep& sweep, const std::vector<SettingValue>& values);

// The name of a cell, as used in its games' ids: "b.handicap=0.5+match.rules=2014".
std::string cell_name(const Sweep& sweep, const std::vector<SettingValue>& values);

// The base of a schedule of `kind: judge`, with this rule book and camera.
GameSettings configured(const JudgeSchedule& schedule, const std::string& rules,
                        const std::string& camera);

// The settings implied by presets and handicaps among the varied values, except those the user set
// explicitly. Maps each value, such as "match.rules=2014", to settings by full path. All values of
// one key set the same paths, and no two keys set the same path, so a cell's values never conflict.
using SetByValues = std::map<std::string, std::map<std::string, std::string>>;
SetByValues set_by_values(const Sweep& sweep);
SetByValues set_by_values(const JudgeSchedule& schedule);

}  // namespace autoref::runner
