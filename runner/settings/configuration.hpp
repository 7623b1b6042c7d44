// One game as values: who plays, by which rules, in which world.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "referee/referee.hpp"
#include "sim/configuration.hpp"
#include "soccer/field.hpp"
#include "soccer/rule_book.hpp"
#include "soccer/side.hpp"

namespace autoref::runner {

// What some robots have other than the game's: values by path below `sim.`, such as
// "robot.speed_mps", spelt as value_of() spells them (fields.hpp).
using RobotChanges = std::map<std::string, std::string>;

using RobotTypes = std::map<std::string, RobotChanges>;  // by name

inline constexpr const char* kNoType = "none";

// A robot that differs from its team's.
struct PlayerConfiguration {
  std::string type = kNoType;
  RobotChanges changes;              // beside the type's
  double speed_factor = 1.0;         // times the team's, (0, 2]
  double acceleration_factor = 1.0;  // times the team's, (0, 2]
};

struct TeamConfiguration {
  std::string strategy = "basic";
  int robots = 6;                    // 1 to 16
  std::string type = kNoType;        // of its robots
  RobotChanges changes;              // beside the type's
  double speed_factor = 1.0;         // of the robots' top speed, (0, 2]
  double acceleration_factor = 1.0;  // of their acceleration and braking, (0, 2]
  std::map<std::string, double> params;
  std::map<int, PlayerConfiguration> players;  // by number
};

struct MatchConfiguration {
  std::string rules = "paper";             // name of a rule book
  RuleSet in_force = RuleBook{}.in_force;  // of its rules
  double half_s = 600;
  int halves = 2;
  double break_s = 0;
  bool knockout = false;
  double extra_half_s = 300;  // of knockout games
  referee::AfterGame after_game = referee::AfterGame::kHalt;
  Side a_plays = Side::kWest;
  Side first_kickoff = Side::kWest;
};

struct GameConfiguration {
  TeamConfiguration a;
  TeamConfiguration b;
  MatchConfiguration match;
  Field field;
  sim::Configuration sim;
  sim::RobotSpec robot;  // every robot's body, kicker and dribbler unless its type says otherwise
  RobotTypes types;      // that teams and players may name
  std::uint64_t seed = 42;
  // Full paths of the settings that the user has written one by one: no preset changes them.
  std::set<std::string> given;
};

}  // namespace autoref::runner
