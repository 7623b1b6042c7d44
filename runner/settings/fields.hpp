// The list of everything a user can set: the one source of the scenario reader, of the writer of
// effective configurations and of `--set`.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "runner/settings/configuration.hpp"

namespace autoref::runner {

// `handicap`: one number for a team's speed_factor and acceleration_factor.
struct BothFactors {
  double* speed = nullptr;
  double* acceleration = nullptr;
};

// `preset`: one word for the numbers of a known ball (sim/ball_presets.hpp).
struct BallPreset {
  sim::BallParameters* ball = nullptr;
};

// `camera`: one word for how a known league's vision and radio are (sim/camera_presets.hpp).
struct CameraPreset {
  sim::Configuration* sim = nullptr;
};

// `preset`: one word for the numbers of a known dribbler (sim/dribbler_presets.hpp).
struct DribblerPreset {
  sim::DribblerParameters* dribbler = nullptr;
};

// `match.rules`: the name of a rule book, and with it its rules, field, robots and length.
struct RulesChoice {
  GameConfiguration* game = nullptr;
};

// `type`: the name of one of the game's types of robots, or none.
struct TypeName {
  std::string* name = nullptr;
  const RobotTypes* types = nullptr;
};

// `robot`, `kicker` or `dribbler` of some robots: what differs from the game's, by name.
struct ChangesOf {
  RobotChanges* changes = nullptr;
  std::string branch;
};

// One of these.
struct Change {
  RobotChanges* changes = nullptr;
  std::string path;  // such as "robot.speed_mps"
};

using Params = std::map<std::string, double>;
using Players = std::map<int, PlayerConfiguration>;

// Where a setting lives in a GameConfiguration.
using Target =
    std::variant<double*, int*, bool*, std::uint64_t*, std::string*, Side*, DefenceArea::Shape*,
                 referee::AfterGame*, BothFactors, BallPreset, CameraPreset, DribblerPreset,
                 RulesChoice, TypeName, Change, ChangesOf, Params*, Players*, RobotTypes*>;

struct Range {
  double low = 0;
  double high = 0;
  bool above_low = false;  // `low` itself is not allowed
};

struct Setting {
  std::string path;  // such as "teams.a.robots"
  Target target;
  Range range;                     // of numbers
  std::vector<std::string> words;  // allowed, where the target is no number
  std::string_view unit;
  std::string_view about;  // one sentence
};

// Every setting of `game`, ordered so that settings of one branch stand together. Of players and
// types it has those that the game has.
std::vector<Setting> settings_of(GameConfiguration& game);

// Those of one team below `prefix`, such as "teams.a.".
std::vector<Setting> settings_of(TeamConfiguration& team, const RobotTypes& types,
                                 const std::string& prefix);

// Those of the world, below "sim.".
std::vector<Setting> settings_of(sim::Configuration& sim, sim::RobotSpec& robot);

// The settings of one robot below `prefix` ("" or "sim."), and those of what differs in some.
std::vector<Setting> settings_of(sim::RobotSpec& robot, const std::string& prefix);
std::vector<Setting> settings_of(RobotChanges& changes);

// The full path: "b.robots" is "teams.b.robots", others stay. And the short one, the reverse.
std::string full_path(std::string_view path);
std::string short_path(std::string_view path);

// Whether two full or two short paths set the same number: they are equal, or one is a handicap and
// the other one of its two factors. (A preset leaves single settings alone.)
bool sets_same_number(std::string_view path, std::string_view other);

// The path without its last name.
std::string_view branch_of(std::string_view path);

// The setting at exactly that path; null where there is none.
const Setting* find_setting(const std::vector<Setting>& settings, std::string_view path);

// What a value must look like, such as "a whole number from 1 to 16".
std::string expected_of(const Setting& setting);

// Reads `text` into the setting. Throws std::invalid_argument that says what was expected.
void assign(const Setting& setting, std::string_view text);

// The value as assign() reads it, always spelt the same; of what holds others, a mapping.
std::string value_of(const Setting& setting);

// Whether it has no value of its own but others by name, such as a strategy's parameters.
bool holds_others(const Setting& setting);

// The names that such a setting may hold; none where every name will do.
std::vector<std::string> names_in(const Setting& setting);

// One of those it holds, none where it may hold no such name.
std::optional<Setting> setting_in(const Setting& setting, const std::string& name);

// Whether the values are numbers.
bool is_number(const Setting& setting);

// Whether it only sets other settings, which speak for themselves.
bool is_alias(const Setting& setting);

// Whether it is one word for several other settings: a rule book, or a preset of a camera, a ball
// or a dribbler.
bool is_preset(const Setting& setting);

// The settings or branches one step below `branch` ("" is the root).
std::vector<std::string> names_below(const std::vector<Setting>& settings, std::string_view branch);

// "unknown key 'robot'; did you mean 'robots'? Known here: ..."
std::string unknown_key_message(std::string_view key, const std::vector<std::string>& known);

// Makes sure that a team has a player with a number. Throws std::invalid_argument where `number` is
// none from 0 to 15.
PlayerConfiguration& player_of(Players& players, std::string_view number);

// Sets the value at a full or short path of `settings` as a user does: a preset leaves alone what
// is in `given`, a single setting joins it. So the order of the two does not matter. Throws
// std::invalid_argument.
void set_given(const std::vector<Setting>& settings, std::string_view path, std::string_view text,
               std::set<std::string>& given);

// set_given() for a whole game; `a.params.NAME` names one of the team's parameters,
// `a.robot.NAME` a number of its robots, `a.players.3.` what differs in one of them. Throws
// std::invalid_argument for an unknown path (naming the nearest known) or a wrong value.
void set_by_path(GameConfiguration& game, std::string_view path, std::string_view text);

// Whether a preset is at a path that set_by_path() takes.
bool is_preset_at(const GameConfiguration& game, std::string_view path);

// The value at a path that set_by_path() takes; 0 for a parameter that is not given.
std::string value_at(const GameConfiguration& game, std::string_view path);

// Checks what no setting can tell alone: that a team's parameters belong to its strategy and are
// in their ranges, that goals fit the field. Throws std::invalid_argument.
void check_game(const GameConfiguration& game);

// The part of it that concerns one team, which plays in such a game; `path` is where the team's
// settings are, such as "teams.a", and the message begins with that of the wrong one.
void check_team(const GameConfiguration& game, const TeamConfiguration& team,
                std::string_view path);

// One number over every setting; two games of one build with equal hashes are the same game.
std::uint64_t configuration_hash(const GameConfiguration& game);

}  // namespace autoref::runner
