#include "experiments/reading/top_reader.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <stdexcept>

#include "experiments/reading/factor_reader.hpp"
#include "game/settings/setting_value.hpp"
#include "io/errors.hpp"
#include "io/words.hpp"

namespace autoref::experiments {

void read_settings(const std::vector<game::YamlEntry>& entries, game::SettingsReader& settings) {
  const std::vector<std::string> first = {"types", "measured", "match"};
  const std::vector<std::string> known = settings.names();
  const auto is_in = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const std::string& key : first) {
    if (const game::YamlEntry* entry = game::find_entry(entries, key)) settings.read(*entry, key);
  }
  for (const game::YamlEntry& entry : entries) {
    if (is_in(known, entry.key) && !is_in(first, entry.key)) settings.read(entry, entry.key);
  }
}

void BaseReader::read(const game::YamlEntry& base, game::GameSettings& game) const {
  game::SettingsReader settings(file_, game, locations_);
  settings.hide("seed");
  settings.hide(forbidden_.branch);
  const std::vector<std::string> known = settings.names();
  const std::vector<game::YamlEntry> entries = file_.entries(base, "base", known);
  for (const game::YamlEntry& entry : entries) {
    refuse_misplaced(entry);
    refuse_what_legs_decide(entry);
    if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
    file_.refuse(entry.location, "base", settings.about_unknown(entry.key, known));
  }
  read_settings(entries, settings);
}

void BaseReader::refuse_misplaced(const game::YamlEntry& entry) const {
  if (entry.key != forbidden_.branch) return;
  file_.refuse(entry.location, "base." + entry.key, forbidden_.remedy);
}

void BaseReader::refuse_what_legs_decide(const game::YamlEntry& entry) const {
  if (entry.key != "match" || !entry.value.IsMap()) return;
  for (const game::YamlEntry& key : file_.entries(entry, "match", {})) {
    const std::string path = "match." + key.key;
    if (is_decided_by_schedule(path)) refuse_decided(file_, key.location, path);
  }
}

void TopReader::allow(const std::vector<std::string>& keys, std::vector<std::string> branches) {
  branches_ = std::move(branches);
  std::vector<std::string> known = {"schema", "kind", "about"};
  known.insert(known.end(), keys.begin(), keys.end());
  game::refuse_unknown(file_, top_, known);
}

std::string TopReader::word(const game::YamlEntry& entry, std::string_view key,
                            const std::vector<std::string>& known) const {
  std::string word = file_.scalar(entry, key, "one of " + io::listed(known), false);
  if (std::find(known.begin(), known.end(), word) == known.end()) {
    file_.refuse(game::value_location(entry), key,
                 fmt::format("expected one of {}, found '{}'{}", io::listed(known), word,
                             io::suggestion(word, known)));
  }
  return word;
}

template <typename Number>
Number TopReader::number(const game::YamlEntry& entry, std::string_view key,
                         const std::string& expected,
                         std::optional<Number> (*parse)(std::string_view), Number low,
                         Number high) const {
  const std::string text = file_.scalar(entry, key, expected, true);
  const std::optional<Number> number = parse(text);
  if (!number || *number < low || *number > high) {
    file_.refuse(game::value_location(entry), key,
                 fmt::format("expected {}, found '{}'", expected, text));
  }
  return *number;
}

int TopReader::whole_number(std::string_view key, int low, int high) {
  const game::YamlEntry& entry = required(key);
  locations_[std::string(key)] = entry.location;
  return number<int>(entry, key, fmt::format("a whole number from {} to {}", low, high),
                     io::whole_number_in, low, high);
}

std::uint64_t TopReader::seed() const {
  return number<std::uint64_t>(required("seed"), "seed", "a whole number from 0 to 2^64 - 1",
                               io::seed_in, 0, UINT64_MAX);
}

void TopReader::read_base(game::GameSettings& game, const ForbiddenBranch& forbidden) {
  if (const game::YamlEntry* base = find("base"))
    BaseReader(file_, locations_, forbidden).read(*base, game);
  check([&game] { game::check_game(game); });
  for (const game::Assignment& assignment : assignments_) {
    if (!is_decided_by_schedule(assignment.path)) continue;
    throw io::InputError({assignment.flag}, "", "set automatically for each game; leave it out");
  }
  std::vector<std::string> others = {forbidden.branch};
  others.insert(others.end(), branches_.begin(), branches_.end());
  assign_all(game, others);
}

void TopReader::assign_all(game::GameSettings& game,
                           const std::vector<std::string>& forbidden) const {
  game::Assignments here;
  for (const game::Assignment& assignment : assignments_) {
    const std::string path = game::full_path(assignment.path);
    const std::string branch = path.substr(0, path.find('.'));
    if (std::find(forbidden.begin(), forbidden.end(), branch) != forbidden.end()) continue;
    here.push_back(assignment);
  }
  game::assign_all(here, game);
}

void TopReader::refuse_assignment(const std::string& path) const {
  for (const game::Assignment& assignment : assignments_) {
    if (!game::sets_same_number(game::full_path(assignment.path), game::full_path(path))) continue;
    throw io::InputError({assignment.flag}, "", "the file varies this setting; change it there");
  }
}

void TopReader::refuse_assignments(const std::string& branch, const std::string& message) const {
  for (const game::Assignment& assignment : assignments_) {
    const std::string path = game::full_path(assignment.path);
    if (branch.ends_with('.') ? path.starts_with(branch) : path == branch)
      throw io::InputError({assignment.flag}, "", message);
  }
}

void TopReader::check(const std::function<void()>& work) const {
  try {
    work();
  } catch (const game::SettingError& error) {
    file_.refuse(game::location_in(locations_, error.path()), "", error.what());
  } catch (const std::invalid_argument& error) {
    file_.refuse({}, "", error.what());
  }
}

}  // namespace autoref::experiments
