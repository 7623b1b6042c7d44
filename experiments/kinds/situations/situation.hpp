// A situation: the start positions of robots and ball, as numbers or distributions, and the
// settings for playing and scoring its scenes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/kinds/situations/distribution.hpp"
#include "game/loop/start_scene.hpp"
#include "soccer/field.hpp"
#include "soccer/named.hpp"

namespace autoref::experiments {

// Given in the attackers' frame: they defend the goal at -x.
struct DrawnRobot {
  int number = 0;
  Distribution x_m;
  Distribution y_m;
  std::optional<Distribution> heading_deg = {};  // nullopt: facing the ball
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
  kNone,  // play is on
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
  bool is_attackers_restart = true;  // otherwise the defenders take it
  bool is_after_stop = false;        // STOP comes first, and the robots line up on their own
  DrawnBall ball;
  std::vector<DrawnRobot> attackers;  // by number
  std::vector<DrawnRobot> defenders;
  game::Scene scene;
};

// A number of a robot or ball: its key, where it is stored, its range on this field, and its unit.
template <typename Place>
struct DrawnNumber {
  std::string_view key;
  Place* place;
  Range range;
  std::string_view unit;
};

// All numbers of a robot except its heading, and those of the ball. The bodies stay inside the
// walls.
std::array<DrawnNumber<Distribution>, 5> numbers_of(DrawnRobot& robot, const Field& field);
std::array<DrawnNumber<Distribution>, 6> numbers_of(DrawnBall& ball, const Field& field);
std::array<DrawnNumber<const Distribution>, 5> numbers_of(const DrawnRobot& robot,
                                                          const Field& field);
std::array<DrawnNumber<const Distribution>, 6> numbers_of(const DrawnBall& ball,
                                                          const Field& field);
inline constexpr Range kHeading_deg{-360, 360};

// Draws a start state, with the attackers in the west. Each number has its own random stream, which
// depends on `seed`, the situation's name, `scene` (counted from 1) and the number's path, so it
// does not depend on other numbers. If bodies overlap or the ball of a restart is outside the
// field, the state is drawn again, up to 100 times. Throws SettingError naming the situation if
// that does not help.
game::StartState drawn_state(const SituationSetup& situation, const std::string& name,
                             const Field& field, std::uint64_t seed, int scene);

}  // namespace autoref::experiments
