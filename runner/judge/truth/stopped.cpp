// What robots must not do while play is stopped, or until a restart is taken.
#include <algorithm>
#include <optional>

#include "runner/judge/truth/grace_timer.hpp"
#include "runner/judge/truth/ground_truth_rules.hpp"
#include "runner/judge/truth/outline.hpp"
#include "soccer/field.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::runner::ground_truth {
namespace {

// Also the ball's radius: whether distances end at its centre or its surface is open to reading.
constexpr double kStopMargin_m = 25_mm;
constexpr double kStopMargin_mps = 0.1_mps;
constexpr double kTooFastFor_s = 0.1;
constexpr double kBallAtTargetFor_s = 2_s;

// From the hull to the ball's centre: what a rule calls the distance to the ball.
double to_ball_m(const Scene& scene, const sim::RobotState& robot) {
  return distance_to_hull(scene.now.ball.position_m, robot.position_m, robot.heading);
}

class StopSpeed final : public GroundTruthRule {
 public:
  void watch(const Scene& scene, TrueEvents& all) override {
    if (!scene.play.is_stop || scene.time_s - scene.play.stopped_s <= scene.rules.stop_grace_s) {
      return;
    }
    for_each_robot(scene.now, [&](RobotId id, const sim::RobotState& robot) {
      const double excess_mps = robot.velocity_mps.norm() - scene.rules.stop_speed_mps;
      fast_.watch(scene, id, robot, excess_mps, kTooFastFor_s, all);
    });
  }

 private:
  GraceTimer fast_{"bot_too_fast_in_stop", kStopMargin_mps};
};

class StopDistance final : public GroundTruthRule {
 public:
  void watch(const Scene& scene, TrueEvents& all) override {
    if (!is_ball_at_target(scene)) {
      since_s_.reset();
      return;
    }
    if (!since_s_) since_s_ = scene.time_s;
    if (scene.time_s - *since_s_ >= kBallAtTargetFor_s - scene.frame_s / 2) {
      for_each_robot(scene.now, [&](RobotId id, const sim::RobotState& robot) {
        const double gap_m = to_ball_m(scene, robot);
        near_.watch(scene, id, robot, scene.rules.opponents_to_ball_m - gap_m, 0.0, all);
      });
    }
  }

 private:
  static bool is_ball_at_target(const Scene& scene) {
    if (!scene.play.is_stop || !scene.signal.placement) return false;
    const Vec2 left_m = scene.signal.placement->target_m - scene.now.ball.position_m;
    return left_m.norm() <= scene.rules.ball_in_position_m;
  }

  std::optional<double> since_s_;
  GraceTimer near_{"stop_distance", kStopMargin_m};
};

// Rules of 2026: during stop and free kicks. A stop and the free kick after it are one spell, in
// which a robot has its grace and its foul once. Kick-offs and penalty kicks have places of their
// own for everybody.
class AttackerStays final : public GroundTruthRule {
 public:
  void watch(const Scene& scene, TrueEvents& all) override {
    const Play& play = scene.play;
    const bool is_free_kick =
        play.is_on && !play.in_play && play.taker && !play.is_kickoff() && !play.is_penalty();
    if (!play.is_stop && !is_free_kick) return;
    for_each_robot(scene.now, [&](RobotId id, const sim::RobotState& robot) {
      const Reach reach = reach_to_area(scene.field, opponent_of(id.side), robot);
      near_.watch(scene, play.stops, id, robot, scene.rules.attacker_to_area_m - reach.nearest_m,
                  scene.rules.attacker_grace_s, all);
    });
  }

 private:
  GraceTimer near_{"attacker_stays_near_area", kStopMargin_m};
};

class OpponentsNearRestart final : public GroundTruthRule {
 public:
  void watch(const Scene& scene, TrueEvents& all) override {
    const Play& play = scene.play;
    if (!play.is_on || play.in_play || !play.taker || play.is_penalty()) return;
    for_each_robot(scene.now, opponent_of(*play.taker), [&](RobotId id, const auto& robot) {
      const double gap_m = to_ball_m(scene, robot);
      near_.watch(scene, id, robot, scene.rules.opponents_to_ball_m - gap_m,
                  scene.rules.foul_repeat_s, all);
    });
  }

 private:
  GraceTimer near_{"defender_too_close_to_kick_point", kStopMargin_m};
};

class PlacementInterference final : public GroundTruthRule {
 public:
  void watch(const Scene& scene, TrueEvents& all) override {
    const auto& placement = scene.signal.placement;
    const auto& next = scene.signal.next_command;
    if (!scene.play.is_stop || !placement || !next || !is_for_one_side(next->kind)) return;
    const Vec2& ball_m = scene.now.ball.position_m;
    const Vec2& target_m = placement->target_m;
    if ((target_m - ball_m).norm() <= scene.rules.ball_in_position_m) return;
    for_each_robot(scene.now, opponent_of(next->side), [&](RobotId id, const auto& robot) {
      const double gap_m = hull_to_lane_m(robot, ball_m, target_m);
      near_.watch(scene, id, robot, scene.rules.placement_clearance_m - gap_m,
                  scene.rules.placement_grace_s, all);
    });
  }

 private:
  static double hull_to_lane_m(const sim::RobotState& robot, const Vec2& a_m, const Vec2& b_m) {
    const Vec2 nearest_m = nearest_on_segment(robot.position_m, a_m, b_m);
    return distance_to_hull(nearest_m, robot.position_m, robot.heading);
  }

  GraceTimer near_{"bot_interfered_placement", kStopMargin_m};
};

class TooManyRobots final : public GroundTruthRule {
 public:
  void watch(const Scene& scene, TrueEvents& all) override {
    for (const Side side : kSides) {
      int on_field = 0;
      for_each_robot(scene.now, side, [&](RobotId, const sim::RobotState& robot) {
        on_field += is_on_field(scene.field, robot.position_m) ? 1 : 0;
      });
      if (on_field <= scene.signal.robots_allowed[side]) {
        since_s_[side] = scene.time_s;
        is_reported_[side] = false;
      } else if (!is_reported_[side] && scene.time_s - since_s_[side] >= scene.rules.too_many_s) {
        is_reported_[side] = true;
        all.push_back({"too_many_robots", scene.time_s, side});
      }
    }
  }

 private:
  PerSide<double> since_s_;
  PerSide<bool> is_reported_;
};

}  // namespace

std::unique_ptr<GroundTruthRule> bot_too_fast_in_stop() { return std::make_unique<StopSpeed>(); }
std::unique_ptr<GroundTruthRule> stop_distance() { return std::make_unique<StopDistance>(); }
std::unique_ptr<GroundTruthRule> attacker_stays() { return std::make_unique<AttackerStays>(); }
std::unique_ptr<GroundTruthRule> opponents_near_restart() {
  return std::make_unique<OpponentsNearRestart>();
}
std::unique_ptr<GroundTruthRule> bot_interfered_placement() {
  return std::make_unique<PlacementInterference>();
}
std::unique_ptr<GroundTruthRule> too_many_robots() { return std::make_unique<TooManyRobots>(); }

}  // namespace autoref::runner::ground_truth
