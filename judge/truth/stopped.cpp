// Offences while play is stopped, under the Laws of 2014 and under the 2026 rules.
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "judge/truth/ground_truth_rules.hpp"
#include "judge/truth/outline.hpp"
#include "judge/truth/true_frame.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/side.hpp"
#include "soccer/units.hpp"

namespace autoref::judge::ground_truth {
namespace {

// Detects one kind of offence, at most once per robot and phase. Each restart or stop starts a
// phase.
class GraceTimer {
 public:
  GraceTimer(std::string_view name, double margin) : name_(name), margin_(margin) {}

  // Call for every robot in every frame in which the rule applies. `excess` is how far the robot is
  // beyond the threshold, in the unit of the margin; it commits an offence if it stays beyond the
  // threshold for longer than `grace_s`. Each command starts a phase.
  void watch(const TrueFrame& frame, RobotId id, const sim::RobotState& robot, double excess,
             double grace_s, TrueEvents& all);

 private:
  // Start of the current offence, and the phase in which it was reported.
  struct Timer {
    std::optional<double> since_s;
    int reported = -1;
    bool is_over(double time_s, bool offends, double grace_s, int spell);
  };
  struct Timers {
    int spell = -1;  // current phase
    Timer nearly;
    Timer truly;
    Timer clearly;
  };

  std::string_view name_;
  double margin_;
  PerSide<std::map<int, Timers>> timers_;  // timers by robot number
};

// Returns true in the frame in which the grace period ends.
bool GraceTimer::Timer::is_over(double time_s, bool offends, double grace_s, int spell) {
  if (!offends) {
    since_s.reset();
    return false;
  }
  if (!since_s) since_s = time_s;
  if (reported == spell || time_s - *since_s < grace_s) return false;
  reported = spell;
  return true;
}

void GraceTimer::watch(const TrueFrame& frame, RobotId id, const sim::RobotState& robot,
                       double excess, double grace_s, TrueEvents& all) {
  const int spell = frame.play.count;
  grace_s -= frame.frame_s / 2;  // half a frame of tolerance, since time is quantised to frames
  // Three timers per robot, for the limit and for the limit shifted by the margin either way: a
  // true event is borderline if the strict one has not expired, and there is a near miss if only
  // the lenient one has.
  Timers& timers = timers_[id.side][id.number];
  if (timers.spell != spell) timers = {spell, {}, {}, {}};
  TrueEvent is_due{name_, frame.time_s, id.side, id, robot.position_m};
  timers.clearly.is_over(frame.time_s, excess > margin_, grace_s, spell);
  if (timers.truly.is_over(frame.time_s, excess > 0, grace_s, spell)) {
    is_due.is_borderline = timers.clearly.reported != spell;
    all.push_back(is_due);
  } else if (timers.nearly.is_over(frame.time_s, excess > -margin_, grace_s, spell) &&
             timers.truly.reported != spell) {
    is_due.standing = Standing::kNearMiss;
    all.push_back(is_due);
  }
}

// Measures how long each robot has continuously fulfilled a condition.
class ConditionTimer {
 public:
  // Call for every robot in every frame. Returns how long `does` has been true, or a negative value
  // if it is false.
  double held_s(RobotId id, bool does, double time_s) {
    if (does) return time_s - since_s_.try_emplace(id, time_s).first->second;
    since_s_.erase(id);
    return -1.0;
  }
  void clear() { since_s_.clear(); }

 private:
  std::map<RobotId, double> since_s_;
};

// The ball's radius: the rules leave open whether distances end at its centre or its surface.
constexpr double kStopMargin_m = 25_mm;
constexpr double kStopMargin_mps = 0.1_mps;
constexpr double kTooFastFor_s = 0.1;

class StopSpeed final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    if (!frame.play.is_stop || frame.time_s - frame.play.stopped_s <= frame.rules.stop_grace_s) {
      return;
    }
    for_each_robot(frame.now, [&](RobotId id, const sim::RobotState& robot) {
      const double excess_mps = robot.velocity_mps.norm() - frame.rules.stop_speed_mps;
      fast_.watch(frame, id, robot, excess_mps, kTooFastFor_s, all);
    });
  }

 private:
  GraceTimer fast_{"bot_too_fast_in_stop", kStopMargin_mps};
};

class StopDistance final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    if (!is_ball_at_target(frame)) {
      since_s_.reset();
      return;
    }
    if (!since_s_) since_s_ = frame.time_s;
    if (frame.time_s - *since_s_ >= frame.rules.stop_distance_grace_s - frame.frame_s / 2) {
      for_each_robot(frame.now, [&](RobotId id, const sim::RobotState& robot) {
        const double gap_m = hull_to_ball_m(robot, frame.now.ball);
        near_.watch(frame, id, robot, frame.rules.opponents_to_ball_m - gap_m, 0.0, all);
      });
    }
  }

 private:
  static bool is_ball_at_target(const TrueFrame& frame) {
    if (!frame.play.is_stop || !frame.signal.placement) return false;
    const Vec2 left_m = frame.signal.placement->target_m - frame.now.ball.position_m;
    return left_m.norm() <= frame.rules.ball_in_position_m;
  }

  std::optional<double> since_s_;
  GraceTimer near_{"stop_distance", kStopMargin_m};
};

constexpr double kFastMargin_mps = 0.1_mps;
constexpr double kFastFor_s = 0.1;  // the rules leave open whether a shorter peak counts
constexpr double kLaneMargin_m = 25_mm;

// Selects robots that violate a rule for long enough to be at fault or nearly at fault.
class LongEnough {
 public:
  explicit LongEnough(double margin) : margin_(margin) {}

  void consider(const TrueFrame& frame, RobotId id, const sim::RobotState& robot, double excess,
                double for_s, WorstRobot& worst) {
    for_s -= frame.frame_s / 2;  // half a frame of tolerance, since time is quantised to frames
    const bool is_at_fault = truly_.held_s(id, excess > 0, frame.time_s) >= for_s;
    if (nearly_.held_s(id, excess > -margin_, frame.time_s) < for_s) return;
    worst.consider(id, robot, is_at_fault ? excess : std::min(excess, -margin_ / 2));
  }
  void clear() {
    truly_.clear();
    nearly_.clear();
  }

 private:
  double margin_;
  ConditionTimer truly_;
  ConditionTimer nearly_;
};

// "Robot Stop Speed": applies after the grace period at the start of the stop, but not during ball
// placement. Each robot is counted once per stop.
class StopSpeed2026 final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    const TruePlay& play = frame.play;
    const bool has_grace = frame.time_s - play.stop_began_s <= frame.rules.stop_grace_s;
    if (!play.is_stop || has_grace || frame.is_ball_being_placed()) {
      fast_for_.clear();
      return;
    }
    if (play.stop_count != stop_) counted_.clear();
    stop_ = play.stop_count;
    for (const Side side : kSides) {
      const WorstRobot worst = fastest(frame, side);
      if (fast_.watch(frame, side, worst, all)) counted_.insert(*worst.robot);
    }
  }

 private:
  WorstRobot fastest(const TrueFrame& frame, Side side) {
    WorstRobot worst;
    for_each_robot(frame.now, side, [&](RobotId id, const sim::RobotState& robot) {
      if (counted_.contains(id)) return;
      const double excess_mps = robot.velocity_mps.norm() - frame.rules.stop_speed_mps;
      fast_for_.consider(frame, id, robot, excess_mps, kFastFor_s, worst);
    });
    return worst;
  }

  int stop_ = -1;
  std::set<RobotId> counted_;  // robots counted in this stop
  LongEnough fast_for_{kFastMargin_mps};
  TeamFoul fast_{"bot_too_fast_in_stop", kFastMargin_mps};
};

// "Ball Placement Interference": counts once per placement. Further offences extend the placing
// team's time and are events only if a team places the ball. The interference is a foul of "the
// non-placing team", and it never occurs before kick-offs and penalty kicks: "the referee has to
// place the ball for all kickoffs and all penalty kicks".
class PlacementInterference final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    const std::optional<Side> placer = placer_of(frame);
    if (!frame.is_ball_being_placed() || !placer) {
      near_for_.clear();
      return;
    }
    begin(frame);
    const Side side = opponent_of(*placer);
    WorstRobot worst;
    for_each_robot(frame.now, side, [&](RobotId id, const sim::RobotState& robot) {
      const double excess_m = frame.rules.placement_clearance_m - hull_to_lane_m(frame, robot);
      near_for_.consider(frame, id, robot, excess_m, frame.rules.placement_grace_s, worst);
    });
    if (is_counted_ && !frame.play.placer) return;
    if (!near_.watch(frame, side, worst, all)) return;
    all.back().is_counted = !is_counted_;
    is_counted_ = true;
  }

 private:
  // The simulator places the ball on behalf of the side that takes the free kick.
  static std::optional<Side> placer_of(const TrueFrame& frame) {
    if (frame.play.placer) return frame.play.placer;
    const std::optional<Command>& next = frame.signal.next_command;
    if (!next) return std::nullopt;
    const bool is_free_kick =
        next->kind == CommandKind::kDirectFree || next->kind == CommandKind::kIndirectFree;
    return is_free_kick ? std::optional(next->side) : std::nullopt;
  }

  // A new stop, a new placing team or a new target starts a new placement.
  void begin(const TrueFrame& frame) {
    const Vec2& target_m = frame.signal.placement->target_m;
    const int stop = frame.play.placer ? -frame.play.count : frame.play.stop_count;
    if (stop == stop_ && target_m == target_m_) return;
    stop_ = stop;
    target_m_ = target_m;
    is_counted_ = false;
    near_for_.clear();
  }

  static double hull_to_lane_m(const TrueFrame& frame, const sim::RobotState& robot) {
    const Vec2 nearest_m = nearest_on_segment(robot.position_m, frame.now.ball.position_m,
                                              frame.signal.placement->target_m);
    return distance_to_hull(nearest_m, robot.position_m, robot.heading);
  }

  int stop_ = 0;  // number of the stop, or minus that of the placement command
  Vec2 target_m_{0, 0};
  bool is_counted_ = false;
  LongEnough near_for_{kLaneMargin_m};
  TeamFoul near_{"bot_interfered_placement", kLaneMargin_m};
};

}  // namespace

std::unique_ptr<GroundTruthRule> bot_too_fast_in_stop() { return std::make_unique<StopSpeed>(); }
std::unique_ptr<GroundTruthRule> stop_distance() { return std::make_unique<StopDistance>(); }

std::unique_ptr<GroundTruthRule> bot_too_fast_in_stop_2026() {
  return std::make_unique<StopSpeed2026>();
}
std::unique_ptr<GroundTruthRule> bot_interfered_placement() {
  return std::make_unique<PlacementInterference>();
}

}  // namespace autoref::judge::ground_truth
