// What the rules on robots record from earlier frames.
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <limits>
#include <optional>

#include "soccer/geometry.hpp"
#include "soccer/side.hpp"
#include "soccer/tracks.hpp"

namespace autoref::referee {

inline constexpr double kNever_s = -std::numeric_limits<double>::infinity();

// A set of robots.
class RobotSet {
 public:
  bool has(RobotId robot) const { return (bits_[robot.side] >> robot.number & 1U) != 0; }
  void add(RobotId robot) { bits_[robot.side] |= 1U << robot.number; }

 private:
  PerSide<std::uint32_t> bits_;
};

// A collision of two opponents.
struct Collision {
  RobotId faster;
  RobotId slower;
  double closing_mps = 0;  // relative velocity just before, along the line of their centres
  double closing_deviation_mps = 0;  // its standard deviation
  double lead_mps = 0;               // difference between their speeds
  double angle_rad = 0;              // between their velocities; 0 if one of them stands
  Vec2 position_m{0, 0};             // midpoint of their centres
  Vec2 faster_m{0, 0};               // the faster one's centre
};

// Two opponents that may have collided at `met_s`, by number.
struct PairMeeting {
  int west = 0;
  int east = 0;
  double met_s = 0;
};

struct CrashWatch {
  double before_s = kNever_s;  // time of the previous frame
  // The robots that vision saw in each of the most recent frames of play, one bit per number. Frame
  // n (FrameHistory) is at n modulo the size.
  std::array<PerSide<std::uint32_t>, 64> seen{};
  boost::container::static_vector<PairMeeting, kMaxRobots * kMaxRobots>
      meetings;  // not yet measured; holds every pair, so that none is favoured
  // When west robot [i] and east robot [j] were last in contact.
  std::array<std::array<double, kMaxRobots>, kMaxRobots> met_s = never_met();
  boost::container::static_vector<Collision, 32> unreported;

 private:
  static constexpr std::array<std::array<double, kMaxRobots>, kMaxRobots> never_met() {
    std::array<std::array<double, kMaxRobots>, kMaxRobots> all{};
    for (auto& row : all) row.fill(kNever_s);
    return all;
  }
};

// Two opponents close to each other, by number.
struct PushContact {
  int west = 0;
  int east = 0;
  bool is_near = true;
  bool is_followed = false;  // for at least one frame
  bool are_in_contact = false;
  PerSide<Vec2> from_m{{Vec2(0, 0), Vec2(0, 0)}};      // where they were when contact began
  Vec2 ball_from_m{0, 0};                              // where the ball was then
  PerSide<Vec2> before_mps{{Vec2(0, 0), Vec2(0, 0)}};  // their velocities just before
  // Whether a robot that was driven back far enough to be pushed had driven that way itself.
  PerSide<bool> drove_itself{{false, false}};
};

// Contacts between round robots of two sides form a bipartite planar graph: 32 robots have at most
// 60 pairs in contact, plus a few that are close.
struct PushingWatch {
  boost::container::static_vector<PushContact, 3 * 2 * kMaxRobots> contacts;
  RobotSet with_ball;  // in contact with the ball
};

struct DribblingWatch {
  // Where the ball was when the robot gained it; nullopt for robots without the ball.
  PerSide<std::array<std::optional<Vec2>, kMaxRobots>> ball_from_m;
};

struct KeeperHoldingWatch {
  PerSide<std::optional<double>> since_s;
  std::optional<double> last_s;  // when a keeper last had the ball
};

}  // namespace autoref::referee
