// A tuning's results as files and text.
#pragma once

#include <string>
#include <vector>

#include "experiments/kinds/tune/tuning_state.hpp"
#include "io/csv.hpp"
#include "io/json.hpp"
#include "io/table.hpp"

namespace autoref::experiments {

// tune.csv: a row for the start and for each iteration. It contains each parameter at the centre of
// the search and its best value known then, the mean score of the candidates, and their difference.
std::string tuning_csv(const Tuning& tuning, const TuningState& state);

// summary.csv: the test of the result against the start.
std::string tuning_test_csv(const Tuning& tuning, const TuningState& state);

// result.yaml: the tuned team as written in a scenario, with comments on how good it is.
std::string result_yaml(const Tuning& tuning, const TuningState& state);

// Table of the parameters: start, current value, range.
std::vector<io::Cells> parameter_rows(const Tuning& tuning, const TuningState& state);
inline const std::vector<io::Align> kParameterColumns = {io::Align::kLeft};

// The result of the test in plain words, or the progress of the search.
std::string comparison_text(const Tuning& tuning, const TuningState& state);

// Both as text.
io::TextBlocks tuning_table(const Tuning& tuning, const TuningState& state);

// {"iteration": 12, "iterations": 100, "parameters": [{"name": "pass_risk", "start": 0.5,
//  "best": 0.53}], "verdict": "none", "gain": null, "low95": null, "high95": null, "pairs": 0}.
io::Json json_of(const Tuning& tuning, const TuningState& state);

// For the plot of the search.
SearchPath search_path(const Tuning& tuning, const TuningState& state);

}  // namespace autoref::experiments
