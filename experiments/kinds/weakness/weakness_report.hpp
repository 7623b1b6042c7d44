// The results of a search for weaknesses as files, drawings and text.
#pragma once

#include <string>
#include <vector>

#include "experiments/kinds/results.hpp"
#include "experiments/kinds/weakness/weakness_state.hpp"
#include "io/csv.hpp"
#include "io/json.hpp"
#include "io/table.hpp"

namespace autoref::experiments {

// weaknesses.csv: a row per search, with its score in the search, on new scenes and with the fewest
// robots.
std::string weaknesses_csv(const WeaknessState& state);

// search.csv: a row per search and iteration.
std::string search_csv(const WeaknessState& state);

// A scenario of kind situations with each confirmed weakness and, as NAME-reduced, the same with
// the fewest robots. It plays on the scenario's settings with the same teams.
inline constexpr const char* kWeaknessesFile = "weaknesses.yaml";
std::string weaknesses_yaml(const Weakness& weakness, const WeaknessState& state);

// The start of one scene of each confirmed weakness, with the fewest robots that show it.
std::vector<ResultDrawing> weakness_drawings(const Weakness& weakness, const WeaknessState& state);

// Table of the searches; empty until their results have been tested.
std::vector<io::Cells> weakness_rows(const WeaknessState& state);
inline const std::vector<io::Align> kWeaknessColumns = {io::Align::kLeft};

// "12 of 30 iterations" or "testing", ...
std::string progress_text(const Weakness& weakness, const WeaknessState& state);

// The table with a sentence about each confirmed weakness.
io::TextBlocks weaknesses_table(const Weakness& weakness, const WeaknessState& state);

// [{"search": "midfield.2", "searched": 0.8, "score": 0.62, "usual": 0.08, "excess": 0.54,
//   "confirmed": 1, "left_out": "attackers.3", "reduced_score": 0.7, ...}, ...].
io::Json json_of(const WeaknessState& state);

}  // namespace autoref::experiments
