// Results as JSON, for a run's progress output. Those of groups and standings are in
// runner/analysis/, beside their columns.
#pragma once

#include <vector>

#include "runner/analysis/scene_groups.hpp"
#include "runner/analysis/sprt_match_state.hpp"
#include "runner/analysis/tuning_state.hpp"
#include "runner/experiments/bracket.hpp"
#include "runner/io/json.hpp"

namespace autoref::runner {

// {"verdict": "none", "test_pairs": 12, "log_likelihood_ratio": 0.5}.
Json json_of(const SprtMatchState& state);

// {"iteration": 12, "iterations": 100, "parameters": [{"name": "pass_risk", "start": 0.5,
//  "best": 0.53}], "verdict": "none", "gain": null, "low95": null, "high95": null, "pairs": 0}.
Json json_of(const Tuning& tuning, const TuningState& state);

// [{"tie": "final", "team_a": "cobalt", "team_b": null, "games": 1, "decided_by": "goals",
//   "winner": "cobalt"}, ...]; unknown teams and winners are null.
Json json_of(const std::vector<Tie>& ties);

// [{"situation": "corner", "attackers": "cobalt", "defenders": "zone", "scenes": 200,
//   "void_scenes": 0, "goals": 31, "mean_score": 0.155}, ...]; without scenes, the mean is null.
Json json_of(const std::vector<SceneGroup>& groups);

}  // namespace autoref::runner
