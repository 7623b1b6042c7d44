// Results as JSON, for a run's progress output. The keys are the columns of summary.csv and
// standings.csv.
#pragma once

#include <vector>

#include "runner/analysis/groups.hpp"
#include "runner/analysis/scene_groups.hpp"
#include "runner/analysis/sprt_match_state.hpp"
#include "runner/analysis/standings.hpp"
#include "runner/analysis/tuning_state.hpp"
#include "runner/experiments/bracket.hpp"
#include "runner/io/json.hpp"

namespace autoref::runner {

// [{"values": ["1.0"], "games": 24, "void_games": 0, "mean_a": 4.54, "mean_b": 3.33,
//   "mean_diff": 1.21, "wins_a": 14, "draws": 2, "wins_b": 8}, ...]; without games, means are null.
Json json_of(const std::vector<Group>& groups);

// [{"team": "cobalt", "points": 20, "games": 8, "wins": 6, "draws": 2, "losses": 0,
//   "goals_for": 18, "goals_against": 0}, ...], best team first.
Json json_of(const std::vector<Standing>& standings);

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
