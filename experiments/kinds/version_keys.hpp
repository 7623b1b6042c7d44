// The keys of experiments that rate the versions of a team over time.
#pragma once

#include <string>
#include <vector>

#include "experiments/kinds/keys.hpp"
#include "experiments/schedule/team_versions.hpp"

namespace autoref::experiments {

// teams_key() for teams that can be versions.
Key versioned_teams_key(const std::string& name, std::string about, Teams& teams,
                        game::GameSettings& base, TeamCount count, TeamVersions& versions);

// The keys `anchors`, `earlier` and `taken_over`.
std::vector<Key> earlier_keys(TeamVersions& versions);

}  // namespace autoref::experiments
