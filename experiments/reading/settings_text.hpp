// Writes settings as YAML, for effective.yaml.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/reading/named_teams_reader.hpp"
#include "experiments/schedule/factor.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "game/settings/fields.hpp"

namespace autoref::experiments {

// The settings, each with a comment, nested below `depth` other keys.
std::string text_of(const std::vector<game::Setting>& settings, int depth = 0);

// `base:` without the settings decided by the schedule or by factors, and, unless `elsewhere` is
// empty, without settings whose paths start with it.
std::string base_text(const game::GameSettings& base, std::string_view elsewhere,
                      const SetByValues& set_by_values);

// The settings of the teams, below the key `branch`. `more` returns those that follow a team's own.
std::string teams_text(const Teams& teams, std::string_view branch, const game::RobotTypes& types,
                       const MoreTeamSettings& more = {});

}  // namespace autoref::experiments
