// A case of the rule book: a short situation on the field, and the calls the referee must make.
//
// Cases are written in cases/*.yaml, one file per rule; cases/README.md describes the format.
// Nothing here depends on how the referee decides: the expectations come from the rule books.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "referee/decision.hpp"
#include "soccer/field.hpp"
#include "soccer/geometry.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

// The state of play at the start of the case. Running play follows a force start, so that the last
// touch is unknown.
enum class Opening : std::uint8_t {
  kRunning,
  kKickoff,
  kThrowIn,
  kGoalKick,
  kCornerKick,
  kPenalty,
};

struct StagedRobot {
  RobotId id;
  std::optional<Vec2> at_m;  // nullopt: its plate is a millimetre behind the ball
  double facing_deg = 0;
};

// An action at a given time.
struct Cue {
  enum class Kind : std::uint8_t {
    kDrive,      // the robot drives to `to_m` at constant `speed_mps`
    kTurn,       // the robot turns to `angle_deg` at `speed_degps`
    kKick,       // the robot kicks the ball at its front, `angle_deg` upwards
    kCarry,      // from now on the ball sticks to the robot's plate on contact
    kRoll,       // sets the ball's velocity to `to_mps` without a touch
    kRobotSeen,  // whether vision sees the robot
    kBallSeen,   // whether vision sees the ball
    kRequest,    // the side requests a timeout, or withdraws the request
  };
  double at_s = 0;
  Kind kind = Kind::kDrive;
  RobotId robot;
  Vec2 target{0, 0};  // m, or m/s for a roll
  double speed = 0;   // m/s, or degrees per second for a turn
  double angle_deg = 0;
  bool on = true;
};

// A call that must be made. Members that are not set match any value.
struct Expected {
  Event event = Event::kBegin;
  double from_s = 0;
  double to_s = 0;
  std::optional<std::vector<RobotId>> robots;  // all robots involved, in any order
  std::optional<Side> offender;
  std::optional<Card> card;
  std::optional<Command> next;  // the restart
  std::optional<Vec2> ball_m;   // where the restart is taken
  double within_m = 1e-3;       // tolerance of that position
};

struct Case {
  std::string name;      // a sentence
  std::string rule;      // the rule under test
  std::string source;    // the section of the rule book that it follows from
  std::string location;  // file and line
  std::string error;     // why the case cannot be played; empty if it can

  std::string book = "paper";
  std::map<std::string, bool> switches;  // rules by name, on or off
  PerSide<int> keepers;
  PerSide<int> score;  // goals before the case starts

  Opening opening = Opening::kRunning;
  Side taken_by = Side::kWest;
  bool from_the_stop = false;  // starts with the stop before the restart, not with the restart
  Vec2 ball_m{0, 0};
  std::vector<StagedRobot> robots;
  std::vector<Cue> script;  // in order of time

  double ball_deceleration_mps2 = 0.3;  // deceleration of a rolling ball
  double placement_mps = 0;             // speed of ball placement; 0: instantly
  double noise_m = 0;                   // standard deviation of vision noise
  std::uint64_t seed = 0;

  double until_s = 0;
  std::vector<Expected> expected;
  std::vector<Event> never;
  bool others_allowed = false;  // allows calls that are neither expected nor listed in `never`
  std::optional<PerSide<int>> goals;  // scored since the start
  bool is_negative = false;           // expects its rule to make no call
};

// Prints the test parameter.
inline void PrintTo(const Case& it, std::ostream* out) { *out << it.location; }

}  // namespace autoref::referee
