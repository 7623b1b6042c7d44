// A hash of the course of a game, equal for two games only if they are identical bit for bit.
#pragma once

#include <bit>
#include <cstdint>

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

}  // namespace autoref::game
