// The key `situations` of scenario files, and what the kinds of experiments that play scenes share.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "experiments/kinds/keys.hpp"
#include "experiments/scenes/situation.hpp"
#include "experiments/schedule/matchup_schedule.hpp"

namespace autoref::experiments {

// The situations of an experiment, and the settings that they depend on.
struct SituationsOfTeams {
  SituationsByName* situations = nullptr;
  const game::GameSettings* base = nullptr;
  const Teams* attackers = nullptr;
  const Teams* defenders = nullptr;
};

// The key `base` of scenes; teams are listed under `attackers` and `defenders`.
Key base_of_scenes_key(game::GameSettings& base);

// The key `situations`, which is read after the base and the teams. `scene` contains the defaults
// for keys that a situation does not set.
Key situations_key(const SituationsOfTeams& all, std::shared_ptr<const game::Scene> scene);

// The key `situations` of effective.yaml, with every value written out.
std::string situations_text(const SituationsByName& situations, const Field& field);

// Throws std::invalid_argument if a setting of the base or of a team is invalid, or if a team lacks
// a robot of a situation.
void check_scenes(const game::GameSettings& base, const Teams& attackers, const Teams& defenders,
                  const SituationsByName& situations);

}  // namespace autoref::experiments
