// The complete configuration of one game: teams, rules and world. Only the teams' strategies are
// still given by name (team_controller.hpp).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "game/loop/start_scene.hpp"
#include "referee/referee.hpp"
#include "sim/sim_configuration.hpp"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/rules/rule_book.hpp"
#include "soccer/side.hpp"

namespace autoref::game {

// A team that runs as a separate program (game/team_programs/).
struct TeamProgram {
  std::vector<std::string> command;      // the program, sought in PATH, and its arguments; no shell
  std::string directory;                 // working directory; empty: AutoRef's
  std::vector<std::string> environment;  // "NAME=value", in addition to AutoRef's environment
  double answer_s = 10;                  // wall-clock limit for an answer; only to detect hangs
  int memory_mb = 4096;                  // memory limit per process
};

// The laws that teams obey by default.
inline constexpr const char* kDefaultLaws = "2014";

struct TeamConfiguration {
  std::string strategy = "basic";                           // unused if there is a program
  std::map<std::string, double> params;                     // the strategy's parameters, by name
  sim::TeamSpec::Robots robots = sim::TeamSpec::Robots(6);  // indexed by number; 1 to 16 robots
  std::optional<TeamProgram> program = {};
  bool on_network = false;  // whether the team is commanded over the network (live/)
  // The laws that the team obeys in addition to the rules in force. If nullopt, it obeys only the
  // rules in force.
  std::optional<RuleBook> laws = find_rule_book(kDefaultLaws);
};

struct GameConfiguration {
  TeamConfiguration a;
  TeamConfiguration b;
  referee::Match match;
  Field field;
  sim::Configuration sim;
  std::uint64_t seed = 42;
  std::optional<StartState> start = {};  // nullopt: the game starts with the first kick-off
  std::optional<Scene> scene = {};       // nullopt: the game is not a scene
  // Longest duration in s; nullopt: longest_s(match).
  std::optional<double> longest_s = {};
  std::string id = {};  // id of the game in an experiment; empty for a single game
};

// The rules that the team obeys.
RuleBook obeyed_rules(const GameConfiguration& game, const TeamConfiguration& team);

const TeamConfiguration& team_on(const GameConfiguration& game, Side side);

// The name of a command's program or script, without folder and extension, such as "mine" for
// [python3, teams/mine.py].
std::string program_name(const std::vector<std::string>& command);

// The name of the team's strategy or program.
std::string name_of(const TeamConfiguration& team);

// The display name of each side's team: its strategy, or "basic (a)" and "basic (b)" if both play
// the same one.
PerSide<std::string> shown_names(const GameConfiguration& game);

// How the game's rules differ from the official ones, as a list (soccer/rules/rule_changes.hpp);
// empty for official rules.
std::string rule_changes_in(const GameConfiguration& game);

// The referee's part of the configuration.
referee::Configuration referee_configuration(const GameConfiguration& game);

// Longest plausible duration of a game, in s. A game that takes longer must be stuck.
double longest_s(const referee::Match& match);

// The cameras that saw the game, for its log. Four cameras that report the ball's height see
// everything, so the frames do not depend on them. In that case, the log names the cameras that the
// league would use: one above a field of Division B (from 9 m long), two above a field of Division
// A (from 12 m), and otherwise four.
std::vector<CameraPosition> logged_cameras(const GameConfiguration& game);

}  // namespace autoref::game
