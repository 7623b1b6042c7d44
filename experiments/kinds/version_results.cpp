#include "experiments/kinds/version_results.hpp"

#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "experiments/analysis/version_tables.hpp"

namespace autoref::experiments {

void add_version_ratings(ExperimentResults& results, const TeamVersions& versions,
                         const RowsById& rows, RatedAgainst against) {
  if (!versions.are_followed()) return;
  std::vector<std::string> played;
  for (const Standing& standing : results.standings) played.push_back(standing.team);
  const std::string build = rows.empty() ? "" : rows.begin()->second.circumstances.build;
  VersionRatings ratings = version_ratings(versions, played, results.groups, build, against);
  results.files.push_back(
      {kVersionsFile, "ratings over time, a row per team", versions_csv(ratings.teams)});
  results.files.push_back({kVersionPairsFile, "the same by pair number, for a later experiment",
                           version_pairs_csv(ratings.teams)});
  for (auto& block : versions_table(ratings)) results.table.push_back(std::move(block));
  io::Json json = results.json ? *results.json : io::Json::object();
  json["versions"] = json_of(ratings.teams);
  if (ratings.offset) json["build_offset"] = json_of(*ratings.offset);
  results.json = std::make_shared<io::Json>(std::move(json));
  results.versions = std::move(ratings.teams);
}

}  // namespace autoref::experiments
