// The results of situations as CSV files, JSON and text tables.
#pragma once

#include <string>
#include <vector>

#include "experiments/kinds/situations/scene_groups.hpp"
#include "experiments/kinds/situations/situations.hpp"
#include "io/csv.hpp"
#include "io/json.hpp"
#include "io/table.hpp"

namespace autoref::experiments {

// summary.csv: one row per situation and teams.
std::string scenes_csv(const std::vector<SceneGroup>& groups);

// differences.csv: one row per situation, defenders and two attacking teams.
std::string scene_differences_csv(const std::vector<SceneDifference>& differences);

// The rows of the text table of scenes; the first row is the header.
std::vector<io::Cells> scenes_rows(const std::vector<SceneGroup>& groups);

// Alignment of the columns of scenes_rows().
inline const std::vector<io::Align> kScenesColumns = {io::Align::kLeft, io::Align::kLeft,
                                                      io::Align::kLeft};

// The tables of scenes and of differences as lines of text.
io::TextBlocks scenes_table(const std::vector<SceneGroup>& groups,
                            const std::vector<SceneDifference>& differences);

// [{"situation": "corner", "attackers": "cobalt", "defenders": "zone", "scenes": 200,
//   "void_scenes": 0, "goals": 31, "mean_score": 0.155}, ...]; without scenes, the mean is null.
io::Json json_of(const std::vector<SceneGroup>& groups);

}  // namespace autoref::experiments
