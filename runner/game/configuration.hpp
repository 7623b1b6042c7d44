// One game as values: who plays, by which rules, in which world. Nothing in it has to be looked up
// or read once more, except for the names of the teams' strategies (team_maker.hpp).
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
  std::map<std::string, double> params;                     // the strategy's own numbers, by name
  sim::TeamSpec::Robots robots = sim::TeamSpec::Robots(6);  // by number, 1 to 16
};

struct MatchConfiguration {
  RuleBook rules;  // with the length of extra time, and the rules that are in force
  double half_s = 600;
  int halves = 2;
  double break_s = 0;
  bool knockout = false;
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
  std::uint64_t seed = 42;
};

const TeamConfiguration& team_on(const GameConfiguration& game, Side side);

// How people call each side's team: by its strategy, and where both have the same one, "basic (a)"
// and "basic (b)".
PerSide<std::string> shown_names(const GameConfiguration& game);

// What the referee has to know of the game.
referee::Configuration referee_configuration(const GameConfiguration& game);

// A game that takes longer will not come to its end.
double longest_s(const MatchConfiguration& match);

}  // namespace autoref::runner
