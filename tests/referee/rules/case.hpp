// A case of the rule book: a short situation on the field, and what the referee must make of it.
//
// Cases are written in cases/*.yaml, one file per rule; cases/README.md says how. Nothing here
// knows how the referee decides: what is expected comes from the rule books.
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

// What play the case begins with. Running play goes back to a force start, so that nobody is known
// to have touched the ball.
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
  std::optional<Vec2> at_m;  // none: its plate a millimetre behind the ball
  double facing_deg = 0;
};

// Something that happens at its time.
struct Cue {
  enum class Kind : std::uint8_t {
    kDrive,      // the robot drives to `to_m` at `speed_mps`, at once at that speed
    kTurn,       // the robot turns to `angle_deg` at `speed_degps`
    kKick,       // the robot, at the ball, kicks it along its front, `angle_deg` upwards
    kCarry,      // from now on the ball stays at the robot's plate once it has come there
    kRoll,       // the ball has the velocity `to_mps`, by nobody
    kRobotSeen,  // whether vision sees the robot
    kBallSeen,   // whether vision sees the ball
    kRequest,    // the side asks for a timeout, or no longer
  };
  double at_s = 0;
  Kind kind = Kind::kDrive;
  RobotId robot;
  Vec2 target{0, 0};  // m, or m/s for a roll
  double speed = 0;   // m/s, or degrees a second for a turn
  double angle_deg = 0;
  bool on = true;
};

// A call that must come. What is not given may be anything.
struct Expected {
  Event event = Event::kBegin;
  double from_s = 0;
  double to_s = 0;
  std::optional<std::vector<RobotId>> robots;  // all that are concerned, in any order
  std::optional<Side> offender;
  std::optional<Card> card;
  std::optional<Command> next;  // what play goes on with
  std::optional<Vec2> ball_m;   // and from where
  double within_m = 1e-3;       // of that place
};

struct Case {
  std::string name;      // a sentence
  std::string rule;      // that it is about
  std::string source;    // the rule book's place it follows from
  std::string location;  // file and line
  std::string error;     // why it cannot be played; empty where it can

  std::string book = "paper";
  std::map<std::string, bool> switches;  // rules by name, on or off
  PerSide<int> keepers;
  PerSide<int> score;  // goals before the case begins

  Opening opening = Opening::kRunning;
  Side taken_by = Side::kWest;
  bool from_the_stop = false;  // begins with the stop before the restart, not with the restart
  Vec2 ball_m{0, 0};
  std::vector<StagedRobot> robots;
  std::vector<Cue> script;  // in the order of time

  double ball_deceleration_mps2 = 0.3;  // rolling
  double placement_mps = 0;             // how fast the ball is placed in a stop; 0: at once
  double noise_m = 0;                   // of vision, standard deviation
  std::uint64_t seed = 0;

  double until_s = 0;
  std::vector<Expected> expected;
  std::vector<Event> never;
  bool others_allowed = false;        // calls that are neither expected nor listed in `never`
  std::optional<PerSide<int>> goals;  // counted since the beginning
  bool is_negative = false;           // expects no call of its rule
};

// How a test's parameter is printed.
inline void PrintTo(const Case& it, std::ostream* out) { *out << it.location; }

}  // namespace autoref::referee
