// What the rules about robots have seen of them in earlier frames.
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <limits>
#include <optional>

#include "soccer/geometry.hpp"
#include "soccer/side.hpp"
#include "soccer/tracks.hpp"

namespace autoref::referee {

inline constexpr double kNever_s = -std::numeric_limits<double>::infinity();

// Two robots of different sides that met.
struct Collision {
  RobotId faster;
  RobotId slower;
  double closing_mps = 0;  // along the line of their centres, just before
  double lead_mps = 0;     // by how much the one was faster than the other
  Vec2 position_m{0, 0};   // half-way between their centres
  Vec2 faster_m{0, 0};     // the faster one's centre
};

struct CrashWatch {
  PerSide<TrackedRobots> before;  // in the frame before
  double before_s = kNever_s;
  // When west robot [i] and east robot [j] were in contact last.
  std::array<std::array<double, kMaxRobots>, kMaxRobots> met_s = never_met();
  boost::container::static_vector<Collision, 8> unreported;

 private:
  static constexpr std::array<std::array<double, kMaxRobots>, kMaxRobots> never_met() {
    std::array<std::array<double, kMaxRobots>, kMaxRobots> all{};
    for (auto& row : all) row.fill(kNever_s);
    return all;
  }
};

// Two opponents that are near each other, by their numbers.
struct PushContact {
  int west = 0;
  int east = 0;
  bool is_near = true;
  bool is_followed = false;  // for a frame or more
  bool are_in_contact = false;
  PerSide<Vec2> from_m{{Vec2(0, 0), Vec2(0, 0)}};      // where they were when that began
  PerSide<Vec2> before_mps{{Vec2(0, 0), Vec2(0, 0)}};  // their velocities before it
};

// Round robots of two sides that touch make a planar graph without triangles: among 32 robots there
// are at most 60 pairs in contact, and a few more that are near.
struct PushingWatch {
  boost::container::static_vector<PushContact, 3 * 2 * kMaxRobots> contacts;
};

struct DribblingWatch {
  // Where the ball was when each robot that has it got it; none for the others.
  PerSide<std::array<std::optional<Vec2>, kMaxRobots>> ball_from_m;
};

struct KeeperHoldingWatch {
  PerSide<std::optional<double>> since_s;
};

}  // namespace autoref::referee
