#include "experiments/run/missing_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <vector>

#include "experiments/results/shard.hpp"
#include "io/files.hpp"
#include "io/words.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;

constexpr int kMostListed = 1000;  // entries of a folder

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

// The rows of a folder's files *.csv, each of which begins with the names of its columns.
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

}  // namespace

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
    return fmt::format("holds only the rows of a results folder, {}; give that one",
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

}  // namespace autoref::experiments
