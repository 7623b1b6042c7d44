// A game as the user configured it: rule book and robot types by name, and the settings given
// explicitly. The settings are filled from files and `--set`, written to effective.yaml, and
// identified by a hash. resolved() turns them into the configuration that is played.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "game/loop/game_configuration.hpp"
#include "game/settings/setting_value.hpp"
#include "referee/referee_configuration.hpp"
#include "sim/sim_configuration.hpp"
#include "soccer/field.hpp"
#include "soccer/rules/rule_book.hpp"
#include "soccer/side.hpp"

namespace autoref::game {

// Settings of a robot that differ from the game's: values by path below `sim.`, such as
// "robot.speed_mps".
using RobotChanges = std::map<std::string, SettingValue>;

using RobotTypes = std::map<std::string, RobotChanges>;  // changes of each robot type, by name

// The values of a preset from a file, for the ball or the camera (measured_presets.hpp).
struct MeasuredPreset {
  sim::Configuration sim;
};

using MeasuredPresets = std::map<std::string, MeasuredPreset>;  // by name

inline constexpr const char* kNoType = "none";

// A robot that differs from the rest of its team.
struct PlayerSettings {
  std::string type = kNoType;
  RobotChanges changes;              // override those of the type
  double speed_factor = 1.0;         // multiplied by the team's factor
  double acceleration_factor = 1.0;  // multiplied by the team's factor
};

// The strategy name for teams that play over the network (live/).
inline constexpr const char* kNetworkStrategy = "network";

// The laws of a team that obeys only the rules in force.
inline constexpr const char* kEnforcedOnly = "enforced";

struct TeamSettings {
  std::string strategy = "basic";  // unused if the program has a command
  TeamProgram program;             // the program that plays, if it has a command
  // The program's files and folders; empty: those named in the command.
  std::vector<std::string> files;
  // Hash of the files' content (experiments/run/program_versions.hpp).
  std::string files_hash;
  int robots = 6;
  std::string type = kNoType;        // type of the team's robots
  RobotChanges changes;              // override those of the type
  double speed_factor = 1.0;         // scales the robots' top speed
  double acceleration_factor = 1.0;  // scales the robots' acceleration and braking
  std::string laws = kDefaultLaws;   // name of a rule book, or kEnforcedOnly
  std::map<std::string, double> params;
  std::map<int, PlayerSettings> players;  // robots with settings of their own, by number
};

// The name of the team's strategy or program.
std::string name_of(const TeamSettings& team);

struct GameSettings {
  TeamSettings a;
  TeamSettings b;
  referee::Match match;
  Field field;
  sim::Configuration sim;
  sim::RobotSpec robot;  // body, kicker and dribbler of every robot, unless its type overrides them
  RobotTypes types;      // robot types for teams and players
  MeasuredPresets measured_balls;    // for sim.ball.preset
  MeasuredPresets measured_cameras;  // for sim.camera
  std::uint64_t seed = 42;
  // Set by kinds of experiments, not by settings
  // (experiments/kinds/situations/situations.hpp).
  std::optional<StartState> start;
  std::optional<Scene> scene;
  // Full paths of the settings given explicitly; presets do not change these settings.
  std::set<std::string> given;
};

// Applies the rule book of that name: rules, field, number of robots and length of a half. Throws
// std::invalid_argument for an unknown name.
void choose_rules(const std::string& book, GameSettings& game);

// The game that the settings describe: the rule book with the rules switched on or off, and each
// robot with the overrides of its type, team and number. Looks up names but does not check values;
// check_game() (fields.hpp) does that. Throws std::invalid_argument for unknown laws of a team, and
// SettingError for an unknown robot type or for a player number that the team does not have.
GameConfiguration resolved(const GameSettings& settings);

}  // namespace autoref::game
