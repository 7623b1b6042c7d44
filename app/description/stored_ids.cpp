// Reads the ids of games quickly. Declared in completion.hpp.
#include <algorithm>
#include <cstdint>
#include <fstream>
#include <set>
#include <system_error>

#include "app/description/completion.hpp"
#include "experiments/results/shard.hpp"
#include "io/csv.hpp"

namespace autoref::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostIds = 200;
constexpr std::size_t kMostBytes = 4 << 20;  // of all files
constexpr int kMostFiles = 1000;

// The beginning of a regular file; empty if it cannot be read.
std::string beginning_of(const fs::path& file, std::size_t most) {
  std::error_code none;
  if (!fs::is_regular_file(file, none)) return {};
  const std::uintmax_t size = fs::file_size(file, none);
  if (none) return {};
  most = static_cast<std::size_t>(std::min<std::uintmax_t>(most, size));
  std::string text(most, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(text.data(), static_cast<std::streamsize>(most));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

void add_ids(const std::string& text, const std::string& begun, std::set<std::string>& ids) {
  bool is_header = true;
  for (const std::string_view line : io::lines_as_written(text)) {
    if (ids.size() >= kMostIds) return;
    const std::string id = is_header ? "" : io::first_cell(line);
    is_header = false;
    if (!id.empty() && id.starts_with(begun)) ids.insert(id);
  }
}

}  // namespace

std::vector<std::string> stored_ids(const fs::path& folder, const std::string& begun) {
  std::set<std::string> ids;
  add_ids(beginning_of(folder / experiments::kResultsFile, kMostBytes), begun, ids);
  std::size_t left = ids.empty() ? kMostBytes : 0;
  std::error_code error;
  int files = 0;
  for (fs::directory_iterator entry(folder / experiments::kGamesFolder, error), end;
       left > 0 && !error && entry != end && ++files <= kMostFiles; entry.increment(error)) {
    if (entry->path().extension() != ".csv") continue;
    const std::string text = beginning_of(entry->path(), left);
    left -= text.size();
    add_ids(text, begun, ids);
  }
  return {ids.begin(), ids.end()};
}

}  // namespace autoref::app
