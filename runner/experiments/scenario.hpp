// Scenarios: a single game, a sweep of factors, a round robin, gauntlet, knockout or SPRT match
// between teams, scenes of situations, a set of games to evaluate the referee, or the tuning of a
// team.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "runner/experiments/factor.hpp"
#include "runner/experiments/gauntlet.hpp"
#include "runner/experiments/judge_schedule.hpp"
#include "runner/experiments/knockout.hpp"
#include "runner/experiments/roundrobin.hpp"
#include "runner/experiments/situations.hpp"
#include "runner/experiments/sprt_match.hpp"
#include "runner/experiments/tuning.hpp"
#include "runner/settings/game_settings.hpp"

namespace autoref::runner {

// Plays every combination of the factors' values for `pairs` pairs of legs.
struct Sweep {
  GameSettings base;  // its seed, a_plays and first_kickoff are set by the schedule
  std::vector<Factor> factors;
  int pairs = 1;           // pairs of legs per combination, 1 to 9999
  std::uint64_t seed = 1;  // master seed of the sweep
};

struct Scenario {
  std::string about;
  std::variant<GameSettings, Sweep, JudgeSchedule, RoundRobin, SprtMatch, Gauntlet, Knockout,
               Situations, Tuning>
      content;
};

// All values of `kind:`.
const std::vector<std::string>& kinds();

// The scenario's value of `kind:`.
std::string_view kind_of(const Scenario& scenario);

// The verb of `autoref` that runs the scenario.
std::string_view verb_of(const Scenario& scenario);

}  // namespace autoref::runner
