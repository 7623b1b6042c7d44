// A situation: the start positions of robots and ball, as numbers or distributions, and the
// settings for playing and scoring its scenes.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/scenes/distribution.hpp"
#include "game/loop/start_scene.hpp"
#include "soccer/field.hpp"
#include "soccer/named.hpp"

namespace autoref::experiments {

// A robot's start position, as distributions. Coordinates are in the attackers' frame, in which the
// attackers defend the goal at -x.
struct DrawnRobot {
  int number = 0;
  Distribution x_m;
  Distribution y_m;
  std::optional<Distribution> heading_deg = {};  // nullopt: the robot faces the ball
  Distribution vx_mps;
  Distribution vy_mps;
  Distribution turn_radps;
  bool operator==(const DrawnRobot&) const = default;
};

struct DrawnBall {
  Distribution x_m;
  Distribution y_m;
  Distribution vx_mps;
  Distribution vy_mps;
  Distribution height_m;
  Distribution vz_mps;
  bool operator==(const DrawnBall&) const = default;
};

enum class Restart : std::uint8_t {
  kNone,  // no restart: play is on
  kKickoff,
  kDirectFree,
  kIndirectFree,
  kPenalty,
  kForceStart
};

constexpr auto names_of(Restart /*any*/) {
  return std::to_array<Named<Restart>>({{Restart::kNone, "none"},
                                        {Restart::kKickoff, "kickoff"},
                                        {Restart::kDirectFree, "direct_free"},
                                        {Restart::kIndirectFree, "indirect_free"},
                                        {Restart::kPenalty, "penalty"},
                                        {Restart::kForceStart, "force_start"}});
}

struct SituationSetup {
  Restart restart = Restart::kNone;
  // Whether the attackers take the restart; otherwise the defenders do.
  bool is_attackers_restart = true;
  // Whether STOP comes first, in which the robots line up on their own.
  bool is_after_stop = false;
  DrawnBall ball;
  std::vector<DrawnRobot> attackers;  // sorted by robot number
  std::vector<DrawnRobot> defenders;
  game::Scene scene;
};

using SituationsByName = std::map<std::string, SituationSetup>;

// A numeric value of a robot or of the ball: its key, where it is stored, its range on this field,
// and its unit.
template <typename Place>
struct DrawnNumber {
  std::string_view key;
  Place* place;
  Range range;
  std::string_view unit;
};

// All numeric values of a robot except its heading, or all those of the ball. Their ranges keep the
// bodies inside the walls.
std::array<DrawnNumber<Distribution>, 5> numbers_of(DrawnRobot& robot, const Field& field);
std::array<DrawnNumber<Distribution>, 6> numbers_of(DrawnBall& ball, const Field& field);
std::array<DrawnNumber<const Distribution>, 5> numbers_of(const DrawnRobot& robot,
                                                          const Field& field);
std::array<DrawnNumber<const Distribution>, 6> numbers_of(const DrawnBall& ball,
                                                          const Field& field);
inline constexpr Range kHeading_deg{-360, 360};

// Draws a start state, with the attackers in the west. Each value has its own random stream, which
// depends on `seed`, the situation's name, `scene` (counted from 1) and the value's path. No value
// therefore depends on another one. If bodies overlap or the ball of a restart is outside the
// field, the state is drawn again, up to 100 times. If all of these states are invalid, throws
// SettingError naming the situation.
game::StartState drawn_state(const SituationSetup& situation, const std::string& name,
                             const Field& field, std::uint64_t seed, int scene);

}  // namespace autoref::experiments
