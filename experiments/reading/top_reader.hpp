// Reads the top-level keys shared by several kinds of scenario, and `base:` with the settings of
// all games.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/schedule/schedule.hpp"
#include "game/settings/assignments.hpp"
#include "game/settings/settings_reader.hpp"
#include "game/settings/yaml.hpp"

namespace autoref::experiments {

// Reads the settings in `entries`, in any order. Robot types and rules are read first, because
// teams refer to types and because rules set other branches. Keys that are not settings are
// ignored.
void read_settings(const std::vector<game::YamlEntry>& entries, game::SettingsReader& settings);

// A branch of settings that does not belong in `base`; `remedy` says where it belongs.
struct ForbiddenBranch {
  std::string branch;
  std::string remedy;
};

// Reads `base:`, the settings shared by all games of an experiment.
class BaseReader {
 public:
  // Both arguments must outlive the reader. Records the settings' locations in `locations`.
  BaseReader(const game::YamlFile& file, game::SettingLocations& locations,
             ForbiddenBranch forbidden = {})
      : file_(file), locations_(locations), forbidden_(std::move(forbidden)) {}

  // Throws InputError, for example if `base` contains a setting that the schedule decides.
  void read(const game::YamlEntry& base, game::GameSettings& game) const;

 private:
  void refuse_misplaced(const game::YamlEntry& entry) const;
  void refuse_what_legs_decide(const game::YamlEntry& entry) const;

  const game::YamlFile& file_;
  game::SettingLocations& locations_;
  ForbiddenBranch forbidden_;
};

// All reading functions throw InputError.
class TopReader {
 public:
  // Both arguments must outlive the reader.
  TopReader(const game::YamlFile& file, const game::Assignments& assignments)
      : file_(file), assignments_(assignments), top_(file.top()) {}

  const game::YamlFile& file() const { return file_; }
  const std::vector<game::YamlEntry>& entries() const { return top_; }
  // Locations of settings in the file, which check() reports.
  game::SettingLocations& locations() { return locations_; }

  const game::YamlEntry* find(std::string_view key) const { return game::find_entry(top_, key); }
  const game::YamlEntry& required(std::string_view key) const {
    return game::required_entry(file_, top_, key);
  }

  // Refuses all keys except these and those common to all scenarios. Command-line settings below
  // one of the `branches` are applied when the key of that name is read.
  void allow(const std::vector<std::string>& keys, std::vector<std::string> branches = {});

  std::string word(const game::YamlEntry& entry, std::string_view key,
                   const std::vector<std::string>& known) const;
  // Reads a required whole number and records its location.
  int whole_number(std::string_view key, int low, int high);
  int pairs() { return whole_number("pairs", 1, kMostPairs); }
  std::uint64_t seed() const;

  // Reads `base`, the settings shared by all games, if present. `forbidden` is a branch of settings
  // that does not belong there.
  void read_base(game::GameSettings& game, const ForbiddenBranch& forbidden = {});

  // The command line's settings, which override the file.
  const game::Assignments& assignments() const { return assignments_; }

  // Applies the command line's settings to `game`, except those in the branches `forbidden`.
  void assign_all(game::GameSettings& game, const std::vector<std::string>& forbidden = {}) const;

  // Refuses a command-line setting of `path`, a short path, because the file varies it.
  void refuse_assignment(const std::string& path) const;

  // Refuses command-line settings that would have no effect: those below `branch` if it ends with a
  // dot, otherwise only the setting with exactly this path.
  void refuse_assignments(const std::string& branch, const std::string& message) const;

  // Calls `work` and turns a SettingError into an InputError with the setting's location in the
  // file.
  void check(const std::function<void()>& work) const;

 private:
  template <typename Number>
  Number number(const game::YamlEntry& entry, std::string_view key, const std::string& expected,
                std::optional<Number> (*parse)(std::string_view), Number low, Number high) const;

  const game::YamlFile& file_;
  const game::Assignments& assignments_;
  const std::vector<game::YamlEntry> top_;
  std::vector<std::string> branches_;
  game::SettingLocations locations_;
};

}  // namespace autoref::experiments
