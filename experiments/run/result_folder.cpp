#include "experiments/run/result_folder.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/results/game_row.hpp"
#include "experiments/results/shard.hpp"
#include "io/checksum.hpp"
#include "io/csv.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/words.hpp"

namespace autoref::experiments {
namespace {

// Explains what is wrong with a folder without effective.yaml or without its subfolder games, and
// what to do: "holds no results: ...".
std::string missing_results_text(const std::filesystem::path& folder);

namespace fs = std::filesystem;

constexpr int kMostListed = 1000;  // maximum number of entries examined in a folder

// Calls `take` for the entries of a folder.
template <typename Take>
void for_each_entry(const fs::path& folder, const Take& take) {
  std::error_code error;
  int entries = 0;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (++entries > kMostListed) return;
    take(entry->path());
  }
}

struct StoredRowFiles {
  int files = 0;
  std::size_t rows = 0;
};

// The rows of a folder's *.csv files. Each file begins with the names of its columns.
StoredRowFiles row_files_in(const fs::path& folder) {
  StoredRowFiles found;
  for_each_entry(folder, [&found](const fs::path& file) {
    std::error_code none;  // another program may have removed the file
    if (file.extension() != ".csv" || !fs::is_regular_file(file, none)) return;
    std::size_t lines = 0;
    io::read_pieces(file, [&lines](std::string_view piece) {
      lines += static_cast<std::size_t>(std::count(piece.begin(), piece.end(), '\n'));
    });
    ++found.files;
    found.rows += lines == 0 ? 0 : lines - 1;
  });
  return found;
}

// The results folders inside a folder.
std::vector<std::string> results_below(const fs::path& folder) {
  constexpr std::size_t kMost = 3;
  std::vector<std::string> found;
  for_each_entry(folder, [&found](const fs::path& inner) {
    std::error_code none;
    if (fs::exists(inner / kEffectiveFile, none)) found.push_back(inner.string());
  });
  std::sort(found.begin(), found.end());
  if (found.size() > kMost) {
    const std::size_t more = found.size() - kMost;
    found.resize(kMost);
    found.push_back(fmt::format("and {} more", more));
  }
  return found;
}

std::string text_without_scenario(const fs::path& folder, const StoredRowFiles& rows) {
  return fmt::format(
      "{0}/ has {1} row{6} in {2} file{3}, but {4}, which says what experiment they belong to, is "
      "missing. Copy it from where they were played (all shards have the same), or repeat the "
      "command that played them with -o {5}: it writes {4} and keeps the rows",
      kGamesFolder, rows.rows, rows.files, rows.files == 1 ? "" : "s", kEffectiveFile,
      folder.string(), rows.rows == 1 ? "" : "s");
}

std::string missing_results_text(const fs::path& folder) {
  std::error_code none;
  if (!fs::is_directory(folder, none)) {
    return fmt::format("holds no results: it {}",
                       fs::exists(folder, none) ? "is not a folder" : "does not exist");
  }
  const StoredRowFiles rows = row_files_in(folder / kGamesFolder);
  const bool has_scenario = fs::exists(folder / kEffectiveFile, none);
  if (rows.files > 0 && !has_scenario) return text_without_scenario(folder, rows);
  const fs::path whole = fs::absolute(folder / ".", none).lexically_normal().parent_path();
  const fs::path above = whole.parent_path();
  if (whole.filename() == kGamesFolder && fs::exists(above / kEffectiveFile, none))
    return fmt::format("holds only the rows of a results folder, {}; give that folder instead",
                       above.string());
  const std::vector<std::string> below = results_below(folder);
  if (!below.empty())
    return "holds results folders, but is not one itself; give one of them: " + io::listed(below);
  const std::string expected = fmt::format(
      "holds no results: expected {} and a folder {}, as written by autoref run and "
      "autoref judge",
      kEffectiveFile, kGamesFolder);
  const bool has_games = fs::is_directory(folder / kGamesFolder, none);
  return has_scenario && !has_games
             ? fmt::format("{}; the folder {} is missing", expected, kGamesFolder)
             : expected;
}

std::set<std::string> builds_of(const StoredRows& stored) {
  std::set<std::string> builds;
  for (const auto& [id, row] : stored.rows) builds.insert(row.circumstances.build);
  return builds;
}

// Returns `wanted`, or the folder's only build if `wanted` is empty.
std::string chosen_build(const StoredRows& stored, const std::string& wanted,
                         const fs::path& folder) {
  const std::set<std::string> builds = builds_of(stored);
  if (wanted.empty() && builds.size() <= 1) return builds.empty() ? "" : *builds.begin();
  if (builds.contains(wanted)) return wanted;
  throw io::InputError(
      {folder.string()}, "",
      fmt::format("{}holds games of builds {}; choose one with --build",
                  wanted.empty() ? "" : fmt::format("has no games of {}: ", wanted),
                  fmt::join(builds, ", ")));
}

// Ids of the games in results.csv that have no row.
std::vector<std::string> lost_games(const fs::path& folder, const StoredRows& stored) {
  std::vector<std::string> lost;
  if (builds_of(stored).size() > 1) return lost;  // the build of results.csv is unknown
  bool is_header = true;
  io::LinesAsWritten lines([&](std::string_view line) {
    if (std::exchange(is_header, false)) return;
    std::string id = io::first_cell(line);
    if (!id.empty() && !stored.rows.contains(id)) lost.push_back(std::move(id));
  });
  io::read_pieces(folder / kResultsFile, [&lines](std::string_view piece) { lines.add(piece); });
  return lost;
}

}  // namespace

Scenario scenario_in(const fs::path& folder) {
  const fs::path file = folder / kEffectiveFile;
  const std::optional<std::string> text = io::read_file(file);
  if (!text || !fs::is_directory(folder / kGamesFolder)) {
    throw io::InputError({folder.string()}, "", missing_results_text(folder));
  }
  Scenario scenario = read_scenario_text(*text, file.string());
  if (!scenario.is_game()) return scenario;
  throw io::InputError(
      {file.string()}, "kind",
      fmt::format("this file is of kind {}, not an experiment", kind_of(scenario)));
}

int ResultFolder::killed_games() const {
  return static_cast<int>(std::count_if(completed_games.done.begin(), completed_games.done.end(),
                                        [](const auto& entry) { return is_killed(entry.second); }));
}

std::vector<std::size_t> ResultFolder::good_games() const {
  std::vector<std::size_t> good;
  for (std::size_t i = 0; i < games.size(); ++i) {
    const auto row = completed_games.done.find(games[i].id);
    if (row != completed_games.done.end() && row->second.record.status == game::Status::kOk)
      good.push_back(i);
  }
  return good;
}

int ResultFolder::void_games() const {
  return static_cast<int>(
      std::count_if(completed_games.done.begin(), completed_games.done.end(),
                    [](const auto& entry) { return is_void(entry.second.record); }));
}

std::set<std::string> ResultFolder::faults() const {
  constexpr std::size_t kNamed = 3;
  std::set<std::string> faults;
  std::vector<std::string> unexplained = lost;
  for (const DamagedRow& row : damaged) {
    faults.insert(
        fmt::format("{}: the row of {} is damaged and does not count", row.at, row.game_id));
    std::erase(unexplained, row.game_id);
  }
  if (unexplained.empty()) return faults;
  const std::size_t count = unexplained.size();
  if (count > kNamed) {
    unexplained.resize(kNamed);
    unexplained.push_back(fmt::format("and {} more", count - kNamed));
  }
  faults.insert(fmt::format("in {}, but without a row in {}/: {}", kResultsFile, kGamesFolder,
                            fmt::join(unexplained, ", ")));
  return faults;
}

std::set<std::string> builds_in(const fs::path& path) {
  return builds_of(read_rows(path / kGamesFolder, row_format(scenario_in(path).experiment())));
}

ResultFolder open_results(const fs::path& path, const std::string& build) {
  const Scenario scenario = scenario_in(path);
  const RowFormat format = row_format(scenario.experiment());
  StoredRows stored = read_rows(path / kGamesFolder, format);
  const std::string its_build = chosen_build(stored, build, path);
  std::vector<std::string> lost = lost_games(path, stored);
  RowInventory row_inventory =
      take_row_inventory(scenario, std::move(stored.rows), format, its_build, true, path, {});
  RowsById& done = row_inventory.completed_games.done;
  const std::size_t played = done.size();
  done = needed_rows(row_inventory.schedule, std::move(done));
  const auto beyond = static_cast<int>(played - done.size());
  ResultFolder folder{path,
                      scenario,
                      format,
                      std::move(row_inventory.schedule.games),
                      row_inventory.schedule.needed,
                      its_build,
                      std::move(row_inventory.completed_games),
                      beyond,
                      stored.damaged,
                      std::move(lost),
                      {}};
  if (folder.is_complete()) folder.damaged.clear();
  for (const auto& [id, row] : folder.completed_games.done)
    ++folder.by_shard[row.circumstances.shard];
  return folder;
}

std::vector<std::string> files_of_results(const fs::path& path) {
  std::vector<std::string> files;
  std::error_code error;
  for (const fs::path& folder : {path, path / kGamesFolder}) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
      const fs::path name = entry.path().filename();
      if (name == kEffectiveFile || name.extension() == ".csv")
        files.push_back(entry.path().string());
    }
  }
  return files;
}

void refuse_files_without_rows(const fs::path& path) {
  std::error_code none;
  if (fs::exists(path / kGamesFolder, none)) return;
  for (const char* name : {kEffectiveFile, kResultsFile}) {
    if (!fs::exists(path / name, none)) continue;
    throw io::InputError(
        {path.string()}, "",
        fmt::format("has {}, but no folder {} with rows of games: the results would overwrite "
                    "the file; choose another folder with -o, or move the file",
                    name, kGamesFolder));
  }
}

std::string results_csv(const RowFormat& format, const RowsById& rows) {
  std::string csv = io::csv_line(format.reproducible_names()) + "\n";
  for (const auto& [id, row] : rows) csv += io::csv_line(format.reproducible(row)) + "\n";
  return csv;
}

std::string rows_checksum(const ResultFolder& folder) {
  return io::crc_text(results_csv(folder.format, folder.completed_games.done));
}

ExperimentResults write_results(const fs::path& folder, const Scenario& scenario,
                                const RowFormat& format, const RowsById& rows) {
  ExperimentResults results = scenario.experiment().results(rows);
  io::replace_file(folder / kResultsFile, results_csv(format, rows));
  for (const ResultFile& file : results.files) io::replace_file(folder / file.name, file.content);
  for (const ResultDrawing& drawing : results.drawings)
    io::replace_file(folder / drawing.name, drawing.svg);
  return results;
}

}  // namespace autoref::experiments
