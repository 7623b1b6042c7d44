#include "runner/result_folder.hpp"

#include <fmt/format.h>

#include <set>

#include "runner/csv.hpp"
#include "runner/errors.hpp"
#include "runner/files.hpp"
#include "runner/shard.hpp"

namespace autoref::runner {
namespace {

namespace fs = std::filesystem;

Scenario scenario_in(const fs::path& folder) {
  const fs::path file = folder / kEffectiveFile;
  if (!fs::exists(file) || !fs::is_directory(folder / kGamesFolder)) {
    throw InputError({folder.string()}, "",
                     fmt::format("holds no results: expected {} and a folder {}, as autoref run "
                                 "leaves them",
                                 kEffectiveFile, kGamesFolder));
  }
  Scenario scenario = read_scenario(file);
  if (is_experiment(scenario)) return scenario;
  throw InputError({file.string()}, "kind",
                   fmt::format("this is a {}, not an experiment", kind_of(scenario)));
}

// The build that was asked for, or the only one.
std::string chosen_build(const StoredRows& stored, const std::string& wanted,
                         const fs::path& folder) {
  std::set<std::string> builds;
  for (const StoredRow& row : stored.rows) builds.insert(row.build);
  if (wanted.empty() && builds.size() <= 1) return builds.empty() ? "" : *builds.begin();
  if (builds.contains(wanted)) return wanted;
  throw InputError({folder.string()}, "",
                   fmt::format("{}holds games of the builds {}; choose one with --build",
                               wanted.empty() ? "" : fmt::format("has none of {}: ", wanted),
                               fmt::join(builds, ", ")));
}

}  // namespace

int ResultFolder::void_games() const {
  const std::size_t status = format.column("status");
  int count = 0;
  for (const auto& [id, cells] : stock.done) {
    count += cells[status] == name_of(Status::kVoid) ? 1 : 0;
  }
  return count;
}

ResultFolder open_results(const fs::path& path, const std::string& build) {
  const Scenario scenario = scenario_in(path);
  const RowFormat format(value_columns(scenario));
  const StoredRows stored = read_rows(path / kGamesFolder, format);
  ResultFolder folder{path,
                      scenario,
                      format,
                      plan_of(scenario, path / kEffectiveFile),
                      chosen_build(stored, build, path),
                      {},
                      stored.damaged,
                      {}};
  folder.stock = take_stock(stored.rows, folder.games, format, folder.build, true, path, {});
  const std::size_t shard = format.column("shard");
  for (const auto& [id, cells] : folder.stock.done) ++folder.by_shard[cells[shard]];
  return folder;
}

ExperimentResults write_results(const fs::path& folder, const Scenario& scenario,
                                const RowFormat& format, const std::map<std::string, Cells>& rows) {
  std::vector<Cells> cells;
  std::string csv = csv_line(format.reproducible(format.columns())) + "\n";
  for (const auto& [id, row] : rows) {
    csv += csv_line(format.reproducible(row)) + "\n";
    cells.push_back(row);
  }
  ExperimentResults results = results_of(scenario, format, cells);
  replace_file(folder / kResultsFile, csv);
  for (const ResultFile& file : results.files) replace_file(folder / file.name, file.content);
  return results;
}

}  // namespace autoref::runner
