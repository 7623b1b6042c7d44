// A staged game in which west commits one of the fouls of `rowdy` whenever it can. East stands
// still unless a test says otherwise.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>

#include "tests/support/staged_game.hpp"

namespace autoref::game {

inline constexpr RobotId kKeeper{Side::kWest, 0};
inline constexpr RobotId kFirst{Side::kWest, 1};
inline constexpr RobotId kSecond{Side::kWest, 2};
inline constexpr RobotId kOpponent{Side::kEast, 0};

// A keeper and two field players that commit `kind` whenever possible, and no other foul.
inline StagedTeam only(const std::string& kind) {
  return {"rowdy", 3, {{"otherwise", 0}, {kind, 1}}};
}

struct FoulBehaviour : StagedGame {
  explicit FoulBehaviour(const std::string& kind, const StagedTeam& east = {"dummy", 2, {}},
                         std::uint64_t seed = 1)
      : StagedGame(only(kind), east, {}, seed) {
    put_robot(kKeeper, {-2.9, 0});
    put_robot(kFirst, {-1.0, 0.4});
    put_robot(kSecond, {-1.0, -1.0});
  }
  void start() { command(CommandKind::kForceStart); }
  void restart(CommandKind kind, Side side) { command(kind, side); }

  double to_ball_m(RobotId id) const {
    const sim::RobotState& its = robot(id);
    return distance_to_hull(ball().position_m, its.position_m, its.heading) - kBallRadius_m;
  }
  // Distance from the ball to the nearer of the two field players.
  double nearest_to_ball_m() const { return std::min(to_ball_m(kFirst), to_ball_m(kSecond)); }
  // Distance from a robot's centre to the defence area of `side`; its hull reaches 90 mm farther.
  double to_area_m(Side side, RobotId id) const {
    return distance_to_defence_area(field, side, robot(id).position_m);
  }
  bool touches_ball(RobotId id) const {
    for (const sim::Touch& touch : world.touches()) {
      if (touch.robot == id) return true;
    }
    return false;
  }
  double ball_mps() const { return ball().velocity_mps.norm(); }
};

// Minimum and maximum of `measured` over the seeds 1 to 20.
struct Spread {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
};
inline Spread spread_of(double (*measured)(std::uint64_t seed)) {
  Spread spread;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const double value = measured(seed);
    spread.least = std::min(spread.least, value);
    spread.most = std::max(spread.most, value);
  }
  return spread;
}

}  // namespace autoref::game
