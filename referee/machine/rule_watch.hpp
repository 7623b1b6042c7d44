// The records that rules have kept since play last started or stopped, and the grace timers and
// sets of robots used for them.
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <limits>
#include <optional>

#include "referee/decision.hpp"
#include "referee/referee_input.hpp"
#include "soccer/geometry.hpp"
#include "soccer/side.hpp"
#include "soccer/tracks.hpp"

namespace autoref::referee {

// Timers for offences that are allowed for a grace period. Each robot is reported once per stop.
class GraceTimer {
 public:
  // Records whether the robot is offending in this frame. Returns whether the robot has now been
  // offending for `grace_s` and has not yet been reported.
  bool is_due(RobotId robot, bool offends, double grace_s, double now_s);
  void mark_reported(RobotId robot) { of(robot).is_reported = true; }

 private:
  struct Timer {
    std::optional<double> since_s;
    bool is_reported = false;
  };
  Timer& of(RobotId robot) { return all_[robot.side][static_cast<std::size_t>(robot.number)]; }

  PerSide<std::array<Timer, kMaxRobots>> all_;
};

struct GraceViolation {
  RobotId id;
  Vec2 position_m{0, 0};
  double excess = 0;
};

// Whether `a` is reported before `b`: the larger excess comes first; if they are equal up to
// rounding, the robot nearer to the centre comes first, so that neither side is favoured.
bool goes_before(const GraceViolation& a, const GraceViolation& b);

// Returns the robot with the largest excess among those that have offended for `grace_s` and have
// not been reported, and marks it reported. `excess_of(side, robot)` is the amount by which a robot
// exceeds the limit, in any unit; a robot offends if it is positive.
template <typename ExcessOf>
std::optional<GraceViolation> take_worst(GraceTimer& grace_timer, const RefereeInput& input,
                                         double grace_s, const ExcessOf& excess_of) {
  std::optional<GraceViolation> worst;
  for (const Side side : kSides) {
    for (const TrackedRobot& robot : input.tracks.robots[side]) {
      const RobotId id{side, robot.number};
      const double excess = excess_of(side, robot);
      if (!grace_timer.is_due(id, excess > 0, grace_s, input.time_s())) continue;
      const GraceViolation found{id, robot.position_m, excess};
      if (!worst || goes_before(found, *worst)) worst = found;
    }
  }
  if (worst) grace_timer.mark_reported(worst->id);
  return worst;
}

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
  // Relative velocity just before the collision, along the line between the centres.
  double closing_mps = 0;
  double closing_deviation_mps = 0;  // standard deviation of `closing_mps`
  double lead_mps = 0;               // difference between the robots' speeds
  double angle_rad = 0;   // angle between the robots' velocities; 0 if one robot is standing still
  Vec2 position_m{0, 0};  // midpoint between the robots' centres
  Vec2 faster_m{0, 0};    // centre of the faster robot
};

// The robot numbers of two opponents that may have collided at `met_s`.
struct PairMeeting {
  int west = 0;
  int east = 0;
  double met_s = 0;
};

struct CrashWatch {
  double before_s = kNever_s;  // time of the previous frame
  // The robots that vision saw in each of the most recent frames of play, one bit per robot number.
  // Frame n (FrameHistory) is stored at n modulo the size.
  std::array<PerSide<std::uint32_t>, 64> seen{};
  boost::container::static_vector<PairMeeting, kMaxRobots * kMaxRobots>
      meetings;  // possible collisions, not yet measured; can hold every pair, so that no pair is
                 // favoured
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

// Two opponents close to each other, given by their numbers.
struct PushContact {
  int west = 0;
  int east = 0;
  bool is_near = true;
  bool is_followed = false;  // the pair has been followed for at least one frame
  bool are_in_contact = false;
  PerSide<Vec2> from_m{{Vec2(0, 0), Vec2(0, 0)}};      // where the robots were when contact began
  Vec2 ball_from_m{0, 0};                              // where the ball was when contact began
  PerSide<Vec2> before_mps{{Vec2(0, 0), Vec2(0, 0)}};  // the robots' velocities just before contact
  // Whether a robot that moved back far enough to count as pushed was driving that way by itself.
  PerSide<bool> drove_itself{{false, false}};
};

// Contacts between round robots of two sides form a bipartite planar graph: 32 robots have at most
// 60 pairs in contact, plus a few pairs that are close.
struct PushingWatch {
  boost::container::static_vector<PushContact, 3 * 2 * kMaxRobots> contacts;
  RobotSet with_ball;  // robots in contact with the ball
};

struct DribblingWatch {
  // Where the ball was when the robot gained it; nullopt for robots without the ball.
  PerSide<std::array<std::optional<Vec2>, kMaxRobots>> ball_from_m;
};

struct KeeperHoldingWatch {
  PerSide<std::optional<double>> since_s;
  std::optional<double> last_s;  // when a keeper last had the ball
};

// Robots in forbidden positions, and the value measured for the worst violation.
struct PositionViolation {
  ConcernedRobots robots;
  RobotId worst;
  double worst_m = 0;

  bool any() const { return !robots.empty(); }
  // Adds the robot, unless the list already has as many robots as a decision can name. If
  // `is_worse`, this violation becomes the worst.
  void add(RobotId robot, double measured_m, bool is_worse) {
    if (robots.empty() || is_worse) {
      worst = robot;
      worst_m = measured_m;
    }
    if (robots.size() < robots.capacity()) robots.push_back(robot);
  }
};

// Fouls during a stop and the free kick that follows it (2026).
struct AttackerNearAreaWatch {
  // Start of the grace period: the start of the stop, or the team's first foul.
  PerSide<std::optional<double>> grace_from_s;
  PerSide<int> fouls;

  // Whether a team has committed at least `count` fouls.
  bool has_team_with(int count) const {
    return fouls[Side::kWest] >= count || fouls[Side::kEast] >= count;
  }
};

struct RestartDistanceWatch {
  PositionViolation before;  // opponents too near in the last frame before the ball was in play
  std::optional<double> called_s;  // time of the last call; restarts the kicker's time (2026)
};

// The touch for which a non-stopping foul was called (2026).
struct CalledTouch {
  std::optional<RobotId> robot;  // nullopt if no foul was called
  double ended_s = 0;            // when the touch ended, as far as is known
  double called_s = 0;
};

// Robots that are too fast during a stop.
struct StopSpeedWatch {
  GraceTimer robots;
  PerSide<std::optional<double>> called_s;
};

struct KickoffPositionsWatch {
  PerSide<PositionViolation> before;  // violations in the last frame before the ball was in play
};

struct PenaltyPositionsWatch {
  PerSide<PositionViolation> others;  // robots other than kicker and keeper, in that frame
  PositionViolation keeper;
  bool is_over = false;  // whether the outcome of the kick is known
};

// The highest speed measured for a kick while the ball's height was unknown.
struct KickSpeedWatch {
  std::optional<double> kicked_s;  // when the kicker's touch ended; nullopt if there was no kick
  double speed_mps = 0;
  bool is_in_air = false;
};

// Which robots of a side were offside at its newest touch, and at its previous touch.
struct OffsideWatch {
  struct Pass {
    int touch = 0;       // number of the touch since play began, from 1; 0 means no touch
    double ended_s = 0;  // when that touch ended
    Side side = Side::kWest;
    RobotSet offside;  // the side's robots in an offside position
  };
  Pass newest;
  Pass before;
};

// One member for each rule that keeps data between frames, named after the rule.
struct RuleWatch {
  CrashWatch bot_crash_unique;
  PushingWatch bot_pushed_bot;
  DribblingWatch bot_dribbled_ball_too_far;
  KeeperHoldingWatch keeper_held_ball;
  StopSpeedWatch bot_too_fast_in_stop;
  GraceTimer stop_distance;
  GraceTimer bot_interfered_placement;
  // Whether interference was called during the current placement.
  bool interference_is_called = false;
  // Whether a boundary crossing was called since the ball was last inside the boundary.
  bool boundary_is_crossed = false;
  AttackerNearAreaWatch attacker_too_close_to_defense_area;
  RestartDistanceWatch defender_too_close_to_kick_point;
  KickoffPositionsWatch kickoff_positions;
  PenaltyPositionsWatch penalty_positions;
  KickSpeedWatch bot_kicked_ball_too_fast;
  CalledTouch fast_kick;
  CalledTouch touch_in_area;
  OffsideWatch offside;
};

// The records that are kept when play starts, because the rules for a stop also cover the free kick
// that follows it.
inline RuleWatch kept_at_start(const RuleWatch& watch) {
  RuleWatch kept;
  kept.attacker_too_close_to_defense_area = watch.attacker_too_close_to_defense_area;
  return kept;
}

}  // namespace autoref::referee
