#include "app/scenario_argument.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <system_error>

#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/words.hpp"

namespace autoref::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScenarios = "scenarios";
constexpr int kMostEntries = 1000;  // maximum number of entries read from a folder

// Adds the names of a folder's *.yaml files as `shown` / name, and returns its subfolders.
std::vector<fs::path> add_scenarios(const fs::path& folder, const fs::path& shown,
                                    std::set<std::string>& names) {
  std::vector<fs::path> folders;
  std::error_code error;
  int entries = 0;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (++entries > kMostEntries) break;
    const fs::path name = entry->path().filename();
    std::error_code none;  // an unreadable entry is neither a file nor a folder
    if (entry->is_directory(none)) folders.push_back(name);
    if (name.extension() == ".yaml" && entry->is_regular_file(none))
      names.insert((shown / name).string());
  }
  return folders;
}

// Does the same for the folder and its subfolders.
void add_all_scenarios(const fs::path& folder, std::set<std::string>& names) {
  for (const fs::path& inner : add_scenarios(folder, kScenarios, names))
    add_scenarios(folder / inner, kScenarios / inner, names);
}

fs::path installed_scenarios(const fs::path& program) {
  return program.parent_path().parent_path() / "share" / "autoref" / kScenarios;
}

// The entries of `known` with file names that may have been meant.
std::vector<std::string> similar_scenarios(const std::string& file,
                                           const std::vector<std::string>& known) {
  std::vector<std::string> names;
  names.reserve(known.size());
  for (const std::string& one : known) names.push_back(fs::path(one).stem().string());
  std::vector<std::string> similar;
  for (const std::string& name : io::suggested_words(fs::path(file).stem().string(), names)) {
    const auto found = std::find(names.begin(), names.end(), name);
    similar.push_back(known[static_cast<std::size_t>(found - names.begin())]);
  }
  return similar;
}

}  // namespace

std::vector<std::string> known_scenarios(const fs::path& folder, const fs::path& program) {
  std::set<std::string> names;
  add_scenarios(".", "", names);
  if (!folder.empty()) add_scenarios(folder, folder, names);
  add_all_scenarios(kScenarios, names);
  if (!program.empty()) add_all_scenarios(installed_scenarios(program), names);
  return {names.begin(), names.end()};
}

std::string found_scenario(const std::string& file, const fs::path& program) {
  std::error_code error;
  if (fs::exists(file, error)) return file;
  const fs::path given = file;
  if (const auto installed = io::installed_file(given, program)) return installed->string();
  const bool leads_up = std::find(given.begin(), given.end(), "..") != given.end();
  if (given.empty() || given.is_absolute() || leads_up) return file;
  const fs::path among = kScenarios / given;
  if (fs::is_regular_file(among, error)) return among.string();
  const auto installed = io::installed_file(among, program);
  return installed ? installed->string() : file;
}

std::string scenario_to_read(const std::string& given) {
  const fs::path program = io::running_program();
  std::string file = found_scenario(given, program);
  if (file != given) io::write_message(stderr, fmt::format("autoref: reading {}\n", file));
  std::error_code error;
  if (given.empty() || fs::exists(file, error)) return file;
  const fs::path folder = fs::path(given).parent_path();
  const std::string hint =
      io::suggestion_text(similar_scenarios(given, known_scenarios(folder, program)));
  if (hint.empty()) return file;
  try {
    io::read_user_file(file);
  } catch (const io::InputError& unreadable) {
    throw io::InputError({}, "", unreadable.what() + hint);
  }
  return file;
}

CLI::Option* add_scenario_argument(CLI::App& verb, std::string& file, const std::string& about) {
  // Checked only after parsing, because a `--help` after the argument has priority over a missing
  // file.
  verb.parse_complete_callback([&file] {
    if (!file.empty()) file = scenario_to_read(file);
  });
  return verb.add_option("SCENARIO", file, about)->required();
}

}  // namespace autoref::app
