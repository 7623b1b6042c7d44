// The values that completion can propose. Declared in completion.hpp.
#include <algorithm>
#include <cstdint>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>
#include <system_error>

#include "app/description/completion.hpp"
#include "app/scenario_argument.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/kinds/situations/situations.hpp"
#include "experiments/results/shard.hpp"
#include "game/settings/fields.hpp"
#include "game/team_programs/team_templates.hpp"
#include "io/csv.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/words.hpp"
#include "sim/presets.hpp"
#include "soccer/rules/rule_book.hpp"
#include "strategies/registry.hpp"

namespace autoref::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostIds = 200;
constexpr std::size_t kMostBytes = 4 << 20;  // maximum number of bytes read from all files
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

std::vector<Proposal> words_begun(const std::vector<std::string>& words, const std::string& begun) {
  std::vector<Proposal> proposals;
  for (const std::string& word : words)
    if (word.starts_with(begun)) proposals.push_back({word, ""});
  return proposals;
}

std::vector<Proposal> teams_begun(const ValuePlace& place) {
  std::vector<Proposal> proposals;
  for (const strategies::Entry& team : strategies::all_strategies()) {
    if (team.name.starts_with(place.begun))
      proposals.push_back({std::string(team.name), std::string(team.about)});
  }
  return proposals;
}

// Names of scenarios that begin with the typed text. If there are none, the names are compared
// without their folders.
std::vector<Proposal> scenarios_begun(const ValuePlace& place) {
  const std::vector<std::string> known =
      known_scenarios(fs::path(place.begun).parent_path(), io::running_program());
  std::vector<Proposal> proposals = words_begun(known, place.begun);
  if (!proposals.empty()) return proposals;
  std::vector<std::string> shorter;
  shorter.reserve(known.size());
  for (const std::string& one : known) shorter.push_back(one.substr(one.find('/') + 1));
  return words_begun(shorter, place.begun);
}

// All settings of a game that includes the robot named in `key`, such as "b.players.3.handicap".
std::vector<game::Setting> settings_for(game::GameSettings& game, const std::string& key) {
  try {
    return game::settings_with(game, key);
  } catch (const std::invalid_argument&) {
    return game::settings_of(game);  // the robot's number has not been typed yet
  }
}

std::vector<Proposal> values_of_key(const std::vector<game::Setting>& settings,
                                    const std::string& key, const std::string& begun) {
  try {
    std::vector<Proposal> proposals =
        words_begun(game::setting_at(settings, key).allowed_words, begun);
    for (Proposal& one : proposals) one.word.insert(0, key + "=");
    return proposals;
  } catch (const std::invalid_argument&) {
    return {};  // an unknown key has no known values
  }
}

// Keys completed up to the next dot: "match." for "ma", "match.half_s=" for "match.h".
std::vector<Proposal> keys_begun(const std::vector<game::Setting>& settings,
                                 const std::string& begun) {
  std::vector<Proposal> proposals;
  for (const std::string& path :
       begun.starts_with("teams.") ? game::full_paths(settings) : game::short_paths(settings)) {
    if (!path.starts_with(begun)) continue;
    const std::size_t dot = path.find('.', begun.size());
    const bool is_whole = dot == std::string::npos;
    const std::string word = is_whole ? path + "=" : path.substr(0, dot + 1);
    const auto is_word = [&word](const Proposal& one) { return one.word == word; };
    if (std::any_of(proposals.begin(), proposals.end(), is_word)) continue;
    proposals.push_back(
        {word, is_whole ? std::string(game::setting_at(settings, path).about) : ""});
  }
  return proposals;
}

std::vector<Proposal> assignments_begun(const ValuePlace& place) {
  game::GameSettings game;
  const std::size_t equals = place.begun.find('=');
  const std::string key = place.begun.substr(0, equals);
  const std::vector<game::Setting> settings = settings_for(game, key);
  return equals == std::string::npos ? keys_begun(settings, key)
                                     : values_of_key(settings, key, place.begun.substr(equals + 1));
}

std::vector<Proposal> games_begun(const ValuePlace& place) {
  if (place.positionals.empty()) return {};
  return words_begun(stored_ids(place.positionals.front(), place.begun), place.begun);
}

std::vector<Proposal> situations_begun(const ValuePlace& place) {
  if (place.positionals.empty()) return {};
  const std::string file = found_scenario(place.positionals.front(), io::running_program());
  std::error_code none;
  if (!fs::is_regular_file(file, none)) return {};
  try {
    const experiments::Scenario scenario = experiments::read_scenario(file);
    std::vector<std::string> names;
    if (const auto* situations = scenario.as<experiments::Situations>())
      for (const auto& [name, situation] : situations->situations) names.push_back(name);
    return words_begun(names, place.begun);
  } catch (const io::InputError&) {
    return {};  // no scenario has been typed yet
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

std::vector<Proposal> values_at(const ValuePlace& place) {
  using Values = std::vector<Proposal> (*)(const ValuePlace&);
  static const std::map<std::string_view, Values> kKinds = {
      {"SCENARIO", scenarios_begun},
      {"KEY=VALUE", assignments_begun},
      {"GAME_ID", games_begun},
      {"SITUATION", situations_begun},
      {"TEAM", teams_begun},
      {"BOOK", [](const ValuePlace& at) { return words_begun(rule_book_names(), at.begun); }},
      {"PRESET",
       [](const ValuePlace& at) { return words_begun(sim::camera_preset_names(), at.begun); }},
      {"LANGUAGE",
       [](const ValuePlace& at) { return words_begun(game::template_languages(), at.begun); }}};
  const auto found = kKinds.find(place.kind);
  return found == kKinds.end() ? std::vector<Proposal>() : found->second(place);
}

}  // namespace autoref::app
