// The referee's configuration: field, rule book, robots per team, match length and vision noise.
#pragma once

#include <cstdint>

#include "referee/touch_parameters.hpp"
#include "soccer/field.hpp"
#include "soccer/rule_book.hpp"
#include "soccer/side.hpp"
#include "tracking/tracker.hpp"

namespace autoref::referee {

// "At the end of the second half, AutoRef can either signal for a new game to begin or simply
// leave the robots halted" (paper, section 4.2).
enum class AfterGame : std::uint8_t { kHalt, kNewGame };

// Who commands the game. Beside a person, AutoRef follows the person's commands; on its own call it
// sends STOP, and the person decides how play resumes (paper, sections 4.1 and 5). If nobody
// commands, play is on throughout, and calls are only reported. The league's game controller may
// command simulated games; AutoRef follows it like a person.
enum class Control : std::uint8_t { kAutoref, kHuman, kNone, kGameController };

// Who brings the ball to the position of the next free kick or force start: the simulator, or the
// teams' robots (2026, Ball Placement). For kick-offs and penalty kicks it is always the simulator.
enum class PlacedBy : std::uint8_t { kSimulator, kTeams };

struct Configuration {
  Field field;
  RuleBook rules;
  PerSide<int> robots{{kMaxRobots, kMaxRobots}};  // per team, at the start
  double half_s = 600;                            // paper, section 4.2: ten minutes
  int halves = 2;                                 // 1 to 4; the third and fourth are extra time
  double break_s = 0;  // length of each break; 300 s at half-time in the Laws
  Side first_kickoff = Side::kWest;
  bool knockout = false;  // a draw leads to extra time and a shoot-out; allows at most two halves
  AfterGame after_game = AfterGame::kHalt;
  Control control = Control::kAutoref;
  PlacedBy placement = PlacedBy::kSimulator;
  // Fouls of which the referee is less sure than this are not called (machine/confidence.hpp).
  double least_confidence = 0;
  VisionNoise noise;          // noise in the vision frames
  double camera_error_m = 0;  // lasting error of a camera's positions, root mean square
  TouchParameters touch;      // thresholds of the touch detector
};

}  // namespace autoref::referee
