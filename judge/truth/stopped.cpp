// Offences while play is stopped, under the Laws of 2014.
#include <optional>

#include "judge/truth/grace_timer.hpp"
#include "judge/truth/ground_truth_rules.hpp"
#include "judge/truth/outline.hpp"
#include "soccer/units.hpp"

namespace autoref::judge::ground_truth {
namespace {

// The ball's radius: the rules leave open whether distances end at its centre or its surface.
constexpr double kStopMargin_m = 25_mm;
constexpr double kStopMargin_mps = 0.1_mps;
constexpr double kTooFastFor_s = 0.1;
constexpr double kBallAtTargetFor_s = 2_s;

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
        const double gap_m = hull_to_ball_m(robot, scene.now.ball);
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

}  // namespace

std::unique_ptr<GroundTruthRule> bot_too_fast_in_stop() { return std::make_unique<StopSpeed>(); }
std::unique_ptr<GroundTruthRule> stop_distance() { return std::make_unique<StopDistance>(); }

}  // namespace autoref::judge::ground_truth
