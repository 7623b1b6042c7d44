// The list of all settings. The scenario reader, the writer of effective configurations and `--set`
// are all based on it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "game/settings/game_settings.hpp"
#include "soccer/parameters.hpp"

namespace autoref::game {

// `handicap`: sets both speed_factor and acceleration_factor.
struct BothFactors {
  double* speed = nullptr;
  double* acceleration = nullptr;
};

// `preset`: selects the parameters of a known ball by name (sim/presets.hpp). In a game, it can
// also be one of the game's presets from files (measured_presets.hpp), which set the contacts as
// well.
struct BallPreset {
  sim::BallParameters* ball = nullptr;
  sim::ContactParameters* contacts = nullptr;  // null outside a game
  MeasuredPresets* measured = nullptr;         // null outside a game
};

// `camera`: selects the vision and radio of a known league by name (sim/presets.hpp). In a game, it
// can also be one of the game's presets from files (measured_presets.hpp).
struct CameraPreset {
  sim::Configuration* sim = nullptr;
  MeasuredPresets* measured = nullptr;  // null outside a game
};

// `preset`: selects the parameters of a known dribbler or kicker by name (sim/presets.hpp).
struct DribblerPreset {
  sim::DribblerParameters* dribbler = nullptr;
};
struct KickerPreset {
  sim::KickerParameters* kicker = nullptr;
};

// `match.rules`: the name of a rule book, which also sets its rules, field, robots with their
// kickers and dribblers, the teams' latency error and the length of a half.
struct RulesChoice {
  GameSettings* game = nullptr;
};

// `type`: the name of one of the game's robot types, or none.
struct TypeName {
  std::string* name = nullptr;
  const RobotTypes* types = nullptr;
};

// `robot`, `kicker` or `dribbler` of some robots: the values that differ from those of the game, by
// name.
struct ChangesOf {
  RobotChanges* changes = nullptr;
  std::string branch;
};

// One of the values in ChangesOf.
struct Change {
  RobotChanges* changes = nullptr;
  std::string path;  // such as "robot.speed_mps"
  bool is_preset = false;
};

// An enumeration, set by the name of a value (soccer/named.hpp).
struct EnumerationName {
  void* value = nullptr;
  std::string_view (*name)(const void* value) = nullptr;
  void (*set)(void* value, std::string_view name) = nullptr;
};

// Any text.
struct FreeText {
  std::string* text = nullptr;
};

// The words of a command, as one line of text (command_text.hpp).
struct CommandWords {
  std::vector<std::string>* words = nullptr;
};

// The words for yes or no.
inline constexpr const char* kNo = "false";
inline constexpr const char* kYes = "true";

// The last name of the path of a branch's preset, which a word in place of the branch selects.
inline constexpr const char* kPresetName = "preset";

// Precedes the paths of the game's presets from files.
inline constexpr std::string_view kMeasuredBranch = "measured.";

using Params = std::map<std::string, double>;
using Players = std::map<int, PlayerSettings>;

// Location of a setting's value in a GameSettings.
using Target = std::variant<double*, int*, bool*, std::uint64_t*, std::string*, EnumerationName,
                            BothFactors, BallPreset, CameraPreset, DribblerPreset, KickerPreset,
                            RulesChoice, TypeName, FreeText, CommandWords, Change, ChangesOf,
                            Params*, Players*, RobotTypes*, MeasuredPresets*>;

struct Setting {
  std::string path;  // such as "teams.a.robots"
  Target target;
  Range range;                             // permitted range, for numbers
  std::vector<std::string> allowed_words;  // permitted words, if the target is not a number
  std::string_view unit;
  std::string_view about;  // description in one sentence
};

// All settings of `game`, grouped by branch. Includes the settings of the game's players and types.
std::vector<Setting> settings_of(GameSettings& game);

// The settings of one team below `prefix`, such as "teams.a.".
std::vector<Setting> settings_of(TeamSettings& team, const RobotTypes& types,
                                 const std::string& prefix);

// The settings of a robot below `prefix` ("" or "sim."), and the settings that overrides can
// change.
std::vector<Setting> settings_of(sim::RobotSpec& robot, const std::string& prefix);
std::vector<Setting> settings_of(RobotChanges& changes);

// The settings of `sim` that a preset from a file sets for the ball or the camera, below `prefix`.
std::vector<Setting> ball_settings(sim::Configuration& sim, const std::string& prefix);
std::vector<Setting> camera_settings(sim::Configuration& sim, const std::string& prefix);

// Returns the full path: "teams.b.robots" for "b.robots"; other paths are unchanged. short_path()
// is the inverse.
std::string full_path(std::string_view path);
std::string short_path(std::string_view path);

// The paths of all settings that have a value, including nested ones.
std::vector<std::string> full_paths(const std::vector<Setting>& settings);
std::vector<std::string> short_paths(const std::vector<Setting>& settings);

// At most three of `paths`: those in which `end` follows a dot and is the end of the path, such as
// "match.half_s" for "half_s".
std::vector<std::string> paths_ending_in(std::string_view end,
                                         const std::vector<std::string>& paths);

// Returns whether two full or two short paths set the same value: they are equal, one of them is a
// handicap and the other is one of its two factors, or one of them is a branch and the other is its
// preset. (Presets do not override single settings.)
bool sets_same_number(std::string_view path, std::string_view other);

// Returns the path without its last name.
std::string_view branch_of(std::string_view path);

// Returns the setting with exactly this path, or null.
const Setting* find_setting(const std::vector<Setting>& settings, std::string_view path);

// Returns the preset that a word in place of the branch at `path` selects: "sim.ball.preset" for
// "sim.ball". Returns null if the branch does not have one.
const Setting* preset_of_branch(const std::vector<Setting>& settings, std::string_view path);

// The same for the overrides of a robot's kicker or dribbler; nullopt for other settings.
std::optional<Setting> preset_in(const Setting& setting);

// Returns the setting at a full or short path, including settings inside another one. For a branch
// with a preset, such as "sim.ball", returns the preset. Throws std::invalid_argument if the path
// is unknown, naming up to three paths that may have been meant: "match.half_s" for
// "half_s".
Setting setting_at(const std::vector<Setting>& settings, std::string_view path);

// Describes a valid value, such as "a whole number from 1 to 16".
std::string expected_of(const Setting& setting);

// Parses `text` as a value of the setting. Throws std::invalid_argument saying what was expected.
SettingValue value_in(std::string_view text, const Setting& setting);

// Sets a value that value_in() or current_value() returned for this setting.
void set_value(const Setting& setting, const SettingValue& value);

// Parses `text` into the setting. Throws like value_in().
void assign(const Setting& setting, std::string_view text);

// Returns the value of a setting that contains no other settings. The value of a preset is "other"
// if the settings it stands for match no known preset.
SettingValue current_value(const Setting& setting);

// The value in the canonical form that assign() reads; a mapping for a setting that contains
// others.
std::string value_of(const Setting& setting);

// Returns whether the setting has no value itself but contains others by name, such as a strategy's
// parameters.
bool holds_others(const Setting& setting);

// Names allowed inside a setting that contains others; nullopt if any name is allowed.
std::vector<std::string> names_in(const Setting& setting);

// The setting of that name inside `setting`; nullopt if the name is not allowed.
std::optional<Setting> setting_in(const Setting& setting, const std::string& name);

// Returns whether the values are numbers.
bool is_number(const Setting& setting);

// Returns whether the setting only sets other settings, which are listed themselves.
bool is_alias(const Setting& setting);

// Returns whether the setting's value stands for several other settings: a rule book, or a preset
// of a camera, a ball or a dribbler.
bool is_preset(const Setting& setting);

// The names of the settings or branches one level below `branch` ("" is the root).
std::vector<std::string> names_below(const std::vector<Setting>& settings, std::string_view branch);

// "unknown key 'robot'; did you mean 'robots'? Known here: ..."
std::string unknown_key_message(std::string_view key, const std::vector<std::string>& known);

// Returns the team's player with this number, creating it if necessary. Throws
// std::invalid_argument unless `number` is from 0 to 15.
PlayerSettings& player_of(Players& players, std::string_view number);

// Sets one of `settings` on behalf of the user. The order of such calls does not matter: a preset
// leaves the settings in `given` unchanged, and a single setting is added to `given`.
void set_given(const std::vector<Setting>& settings, const Setting& setting,
               const SettingValue& value, std::set<std::string>& given);

// The root of paths: a whole game or one team of an experiment.
struct SettingsRoot {
  // NOLINTNEXTLINE(google-explicit-constructor): the usual root is a game
  SettingsRoot(GameSettings& whole) : game(whole) {}
  // `its_prefix` precedes the team's settings, such as "teams.bold.". The types and the given
  // settings are kept in `base`.
  SettingsRoot(GameSettings& base, TeamSettings& one, std::string its_prefix)
      : game(base), team(&one), prefix(std::move(its_prefix)) {}

  GameSettings& game;
  TeamSettings* team = nullptr;
  std::string prefix;
};

// Returns the settings below `root`. If `path` names a player's setting, such as
// "b.players.3.handicap", adds that player first.
std::vector<Setting> settings_with(const SettingsRoot& root, std::string_view path);

// set_given() for a path. `a.params.NAME` is a parameter of the team, `a.robot.NAME` a value of its
// robots, `a.players.3.` an override for one robot; a type, or a preset of ball or camera, may also
// be a file, relative to `folder`. Returns the value. Throws std::invalid_argument for an unknown
// path (naming the nearest known one) or an invalid value.
SettingValue set_by_path(const SettingsRoot& root, std::string_view path, std::string_view text,
                         const std::filesystem::path& folder = {});

// Like set_by_path(), but with a value that value_in() has already parsed.
void set_value_at(GameSettings& game, std::string_view path, const SettingValue& value);

// The value at a path that set_by_path() accepts; 0 for a strategy's parameter that is not given.
std::string value_at(const GameSettings& game, std::string_view path);

// Checks conditions that involve several settings, for example that a team's parameters belong to
// its strategy and are in range, and that goals fit the field. Throws SettingError
// (setting_value.hpp).
void check_game(const GameSettings& game);

// check_game() for a single team of the game. `path` is the path of the team's settings, such as
// "teams.a".
void check_team(const GameSettings& game, const TeamSettings& team, std::string_view path);

// check_game() for the numbers of the rule book (check_rules()).
void check_rule_numbers(const GameSettings& game);

// A hash over all settings. In one build, games with equal hashes are identical.
std::uint64_t configuration_hash(const GameSettings& game);

}  // namespace autoref::game
