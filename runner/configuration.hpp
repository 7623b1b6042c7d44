// One game as values: who plays, by which rules, in which world.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "referee/referee.hpp"
#include "sim/configuration.hpp"
#include "soccer/field.hpp"
#include "soccer/side.hpp"

namespace autoref::runner {

struct TeamConfiguration {
  std::string strategy = "basic";
  int robots = 6;                    // 1 to 16
  double speed_factor = 1.0;         // of the robots' top speed, (0, 2]
  double acceleration_factor = 1.0;  // of their acceleration and braking, (0, 2]
  std::map<std::string, double> params;
};

struct MatchConfiguration {
  std::string rules = "paper";
  double half_s = 600;
  int halves = 2;
  double break_s = 0;
  Side a_plays = Side::kWest;
  Side first_kickoff = Side::kWest;
};

struct GameConfiguration {
  TeamConfiguration a;
  TeamConfiguration b;
  MatchConfiguration match;
  Field field;
  sim::Configuration sim;
  sim::RobotSheet robot;  // every robot's body, kicker and dribbler
  std::uint64_t seed = 42;
};

}  // namespace autoref::runner
