// A tuning's results as files and text.
#pragma once

#include <string>
#include <vector>

#include "experiments/kinds/tune/tuning_state.hpp"
#include "io/csv.hpp"
#include "io/json.hpp"
#include "io/table.hpp"

namespace autoref::experiments {

// tune.csv: a row for the start and for each iteration. A row contains each parameter's value at
// the centre of the search, its best value known at that time, the mean score of the candidates,
// and the difference between their scores.
std::string tuning_csv(const Tuning& tuning, const TuningState& state);

// summary.csv: the test that compares the result with the start.
std::string tuning_test_csv(const Tuning& tuning, const TuningState& state);

// result.yaml: the tuned team as written in a scenario, with comments on how much better it is than
// the start.
std::string result_yaml(const Tuning& tuning, const TuningState& state);

// Table of the parameters: start, current value, range.
std::vector<io::Cells> parameter_rows(const Tuning& tuning, const TuningState& state);
inline const std::vector<io::Align> kParameterColumns = {io::Align::kLeft};

// The result of the test in plain words, or the progress of the search.
std::string comparison_text(const Tuning& tuning, const TuningState& state);

// The table of parameters and comparison_text(), as lines of text.
io::TextBlocks tuning_table(const Tuning& tuning, const TuningState& state);

// {"iteration": 12, "iterations": 100, "parameters": [{"name": "pass_risk", "start": 0.5,
//  "best": 0.53}], "verdict": "none", "gain": null, "low95": null, "high95": null, "pairs": 0}.
io::Json json_of(const Tuning& tuning, const TuningState& state);

// The path of the search, for its plot.
SearchPath search_path(const Tuning& tuning, const TuningState& state);

}  // namespace autoref::experiments
