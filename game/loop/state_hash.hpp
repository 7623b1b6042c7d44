// The hash of a game's states, and the fixed games whose hashes show whether two builds play
// identically.
#pragma once

#include <bit>
#include <cstdint>
#include <string>

#include "game/loop/game_configuration.hpp"
#include "referee/decision.hpp"
#include "sim/world.hpp"
#include "soccer/random.hpp"

namespace autoref::game {

// Hashes fields in order, never the bytes of structs, which may include padding.
class StateHash {
 public:
  void add(std::uint64_t value) { hash_ = std::rotl((hash_ ^ value) * kPrime, 29); }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(const Vec2& v) {
    add(v.x());
    add(v.y());
  }

  // Adds the position and heading of every robot, and the ball's position and height.
  void add(const sim::WorldState& world) {
    for (Side side : kSides) {
      for (const sim::RobotState& robot : world.robots[side]) {
        add(robot.position_m);
        add(robot.heading);
      }
    }
    add(world.ball.position_m);
    add(world.ball.height_m);
  }

  void add(const referee::Decision& decision) {
    add(static_cast<std::uint64_t>(decision.frame));
    add(static_cast<std::uint64_t>(decision.finding.event));
    add(static_cast<std::uint64_t>(decision.to));
    add(static_cast<std::uint64_t>(decision.command ? league_number(*decision.command) + 1 : 0));
    add(decision.finding.position_m.value_or(Vec2(0, 0)));
  }

  std::uint64_t value() const { return mix_bits(hash_); }

 private:
  static constexpr std::uint64_t kPrime = 0x9fb21c651e98df25ULL;  // odd, with well-mixed bits
  std::uint64_t hash_ = 0;
};

// Number of different fixed games. Their seeds are 1, 2, 3 and so on.
inline constexpr int kFixedGames = 5;

inline std::uint64_t fixed_seed(int round) {
  return 1 + static_cast<std::uint64_t>(round % kFixedGames);
}

// A full game with the default configuration between a registered team and itself. After the last
// fixed game, the first one follows again.
inline GameConfiguration fixed_game(int round,
                                    const std::string& team = TeamConfiguration{}.strategy) {
  GameConfiguration game;
  game.a.strategy = game.b.strategy = team;
  game.seed = fixed_seed(round);
  return game;
}

}  // namespace autoref::game
