// Offences while play is stopped, under the 2026 rules.
#include <algorithm>
#include <set>

#include "judge/truth/ground_truth_rules.hpp"
#include "judge/truth/lasting.hpp"
#include "judge/truth/outline.hpp"
#include "judge/truth/team_foul.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::judge::ground_truth {
namespace {

constexpr double kFastMargin_mps = 0.1_mps;
constexpr double kFastFor_s = 0.1;  // the rules leave open whether a shorter peak counts
constexpr double kLaneMargin_m = 25_mm;

// Selects robots that violate a rule for long enough to be at fault or nearly at fault.
class LongEnough {
 public:
  explicit LongEnough(double margin) : margin_(margin) {}

  void consider(const Scene& scene, RobotId id, const sim::RobotState& robot, double excess,
                double for_s, WorstRobot& worst) {
    for_s -= scene.frame_s / 2;  // half a frame of tolerance, since time is quantised to frames
    const bool is_at_fault = truly_.lasts_s(id, excess > 0, scene.time_s) >= for_s;
    if (nearly_.lasts_s(id, excess > -margin_, scene.time_s) < for_s) return;
    worst.consider(id, robot, is_at_fault ? excess : std::min(excess, -margin_ / 2));
  }
  void clear() {
    truly_.clear();
    nearly_.clear();
  }

 private:
  double margin_;
  Lasting truly_;
  Lasting nearly_;
};

// "Robot Stop Speed": after the grace period at the start of the stop, not during ball placement;
// each robot once per stop.
class StopSpeed2026 final : public GroundTruthRule {
 public:
  void watch(const Scene& scene, TrueEvents& all) override {
    const Play& play = scene.play;
    const bool has_grace = scene.time_s - play.stop_began_s <= scene.rules.stop_grace_s;
    if (!play.is_stop || has_grace || scene.is_ball_being_placed()) {
      fast_for_.clear();
      return;
    }
    if (play.stop_count != stop_) counted_.clear();
    stop_ = play.stop_count;
    for (const Side side : kSides) {
      const WorstRobot worst = fastest(scene, side);
      if (fast_.watch(scene, side, worst, all)) counted_.insert(*worst.robot);
    }
  }

 private:
  WorstRobot fastest(const Scene& scene, Side side) {
    WorstRobot worst;
    for_each_robot(scene.now, side, [&](RobotId id, const sim::RobotState& robot) {
      if (counted_.contains(id)) return;
      const double excess_mps = robot.velocity_mps.norm() - scene.rules.stop_speed_mps;
      fast_for_.consider(scene, id, robot, excess_mps, kFastFor_s, worst);
    });
    return worst;
  }

  int stop_ = -1;
  std::set<RobotId> counted_;  // in this stop
  LongEnough fast_for_{kFastMargin_mps};
  TeamFoul fast_{"bot_too_fast_in_stop", kFastMargin_mps};
};

// "Ball Placement Interference": counts once per placement. Every further one extends the time of a
// team that places the ball; it is an event only then. It is a foul of "the non-placing team", and
// "the referee has to place the ball for all kickoffs and all penalty kicks": never before those.
class PlacementInterference final : public GroundTruthRule {
 public:
  void watch(const Scene& scene, TrueEvents& all) override {
    const std::optional<Side> placer = placer_of(scene);
    if (!scene.is_ball_being_placed() || !placer) {
      near_for_.clear();
      return;
    }
    begin(scene);
    const Side side = opponent_of(*placer);
    WorstRobot worst;
    for_each_robot(scene.now, side, [&](RobotId id, const sim::RobotState& robot) {
      const double excess_m = scene.rules.placement_clearance_m - hull_to_lane_m(scene, robot);
      near_for_.consider(scene, id, robot, excess_m, scene.rules.placement_grace_s, worst);
    });
    if (is_counted_ && !scene.play.placer) return;
    if (!near_.watch(scene, side, worst, all)) return;
    all.back().is_counted = !is_counted_;
    is_counted_ = true;
  }

 private:
  // The simulator places the ball in place of the side that takes the free kick.
  static std::optional<Side> placer_of(const Scene& scene) {
    if (scene.play.placer) return scene.play.placer;
    const std::optional<Command>& next = scene.signal.next_command;
    if (!next) return std::nullopt;
    const bool is_free_kick =
        next->kind == CommandKind::kDirectFree || next->kind == CommandKind::kIndirectFree;
    return is_free_kick ? std::optional(next->side) : std::nullopt;
  }

  // A new stop, a team's order or another target starts a new placement.
  void begin(const Scene& scene) {
    const Vec2& target_m = scene.signal.placement->target_m;
    const int stop = scene.play.placer ? -scene.play.count : scene.play.stop_count;
    if (stop == stop_ && target_m == target_m_) return;
    stop_ = stop;
    target_m_ = target_m;
    is_counted_ = false;
    near_for_.clear();
  }

  static double hull_to_lane_m(const Scene& scene, const sim::RobotState& robot) {
    const Vec2 nearest_m = nearest_on_segment(robot.position_m, scene.now.ball.position_m,
                                              scene.signal.placement->target_m);
    return distance_to_hull(nearest_m, robot.position_m, robot.heading);
  }

  int stop_ = 0;  // number of the stop, or of the order to place the ball, negative
  Vec2 target_m_{0, 0};
  bool is_counted_ = false;
  LongEnough near_for_{kLaneMargin_m};
  TeamFoul near_{"bot_interfered_placement", kLaneMargin_m};
};

}  // namespace

std::unique_ptr<GroundTruthRule> bot_too_fast_in_stop_2026() {
  return std::make_unique<StopSpeed2026>();
}
std::unique_ptr<GroundTruthRule> bot_interfered_placement() {
  return std::make_unique<PlacementInterference>();
}

}  // namespace autoref::judge::ground_truth
