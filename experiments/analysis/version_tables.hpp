// Ratings of versions as files, JSON and text, and reading the files of an earlier folder.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "experiments/analysis/version_ratings.hpp"
#include "io/json.hpp"
#include "io/table.hpp"

namespace autoref::experiments {

// versions.csv: a row per rated team.
inline constexpr const char* kVersionsFile = "versions.csv";
std::string versions_csv(const std::vector<VersionRating>& teams);

// version_pairs.csv: the ratings of each team by pair number, with all digits. An experiment with
// another build reads both files instead of the folder's rows, whose columns may differ from build
// to build.
inline constexpr const char* kVersionPairsFile = "version_pairs.csv";
std::string version_pairs_csv(const std::vector<VersionRating>& teams);

// A team's rating in the files of a results folder.
struct StoredRating {
  EarlierTeam team;
  bool is_taken_over = false;  // whether that folder took it over from another one
};

// The ratings in the texts of versions.csv and version_pairs.csv, by team. Throws
// std::invalid_argument if a text has not the form of its file.
std::map<std::string, StoredRating> stored_ratings(const std::string& versions,
                                                   const std::string& version_pairs);

// The ratings as a text table, followed by sentences on the offset.
io::TextBlocks versions_table(const VersionRatings& ratings);

// [{"team": "v2", "line": "", "date": "2026-09-01", "rating": 1.5, ...}, ...], with values from the
// columns of versions.csv.
io::Json json_of(const std::vector<VersionRating>& teams);

// {"from": "1.0", "to": "1.1", "anchors": 2, "pairs": 20, "mean": 0.5, "low95": ..., ...}
io::Json json_of(const BuildOffset& offset);

}  // namespace autoref::experiments
