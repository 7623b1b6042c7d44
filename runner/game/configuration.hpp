// The complete configuration of one game: teams, rules and world. Only the names of the teams'
// strategies remain to be looked up (team_maker.hpp).
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "referee/referee.hpp"
#include "sim/configuration.hpp"
#include "soccer/field.hpp"
#include "soccer/rule_book.hpp"
#include "soccer/side.hpp"

namespace autoref::runner {

struct TeamConfiguration {
  std::string strategy = "basic";
  std::map<std::string, double> params;                     // the strategy's parameters, by name
  sim::TeamSpec::Robots robots = sim::TeamSpec::Robots(6);  // by number, 1 to 16
};

struct MatchConfiguration {
  RuleBook rules;  // includes the length of extra time and the rules in force
  double half_s = 600;
  int halves = 2;
  double break_s = 0;
  bool knockout = false;
  referee::AfterGame after_game = referee::AfterGame::kHalt;
  referee::Control control = referee::Control::kAutoref;
  referee::PlacedBy placement = referee::PlacedBy::kSimulator;
  Side a_plays = Side::kWest;
  Side first_kickoff = Side::kWest;
};

struct GameConfiguration {
  TeamConfiguration a;
  TeamConfiguration b;
  MatchConfiguration match;
  Field field;
  sim::Configuration sim;
  std::uint64_t seed = 42;
};

const TeamConfiguration& team_on(const GameConfiguration& game, Side side);

// The display name of each side's team: its strategy, or "basic (a)" and "basic (b)" if both play
// the same one.
PerSide<std::string> shown_names(const GameConfiguration& game);

// The referee's part of the configuration.
referee::Configuration referee_configuration(const GameConfiguration& game);

// Longest plausible duration of a game, in s; a game that takes longer is stuck.
double longest_s(const MatchConfiguration& match);

}  // namespace autoref::runner
