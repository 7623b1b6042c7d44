// The ball is too fast after a robot's kick or touch.
#include <cmath>

#include "judge/truth/crossing.hpp"
#include "judge/truth/ground_truth_rules.hpp"
#include "judge/truth/non_stopping.hpp"
#include "soccer/units.hpp"

namespace autoref::judge::ground_truth {
namespace {

constexpr double kKickMargin_mps = 0.2_mps;
constexpr double kOneKick_s = 0.2;  // touches within this time belong to the same kick

class KickSpeed final : public GroundTruthRule {
 public:
  void watch(const Scene& scene, TrueEvents& all) override {
    // A ball beyond the lines is out of play.
    if (!scene.play.is_on || inside_m(scene.field, scene.before.ball.position_m) < 0) return;
    double former_mps =
        speed_mps(scene, scene.before.ball.velocity_mps, scene.before.ball.vertical_mps);
    for (const sim::Touch& touch : scene.touches) {
      const double after_mps = speed_mps(scene, touch.ball_mps, touch.vertical_mps);
      // A fast ball that only glances off was not accelerated by this robot.
      if (after_mps > former_mps) evaluate(scene, touch, after_mps, all);
      former_mps = after_mps;
    }
    const sim::BallState& ball = scene.now.ball;
    const double now_mps = speed_mps(scene, ball.velocity_mps, ball.vertical_mps);
    if (now_mps <= scene.rules.kick_limit_mps) fast_.clear();
  }

 private:
  static double speed_mps(const Scene& scene, const Vec2& plane_mps, double vertical_mps) {
    if (scene.rules.edition != Edition::kRules2026) return plane_mps.norm();
    return std::sqrt(plane_mps.squaredNorm() + vertical_mps * vertical_mps);
  }

  void evaluate(const Scene& scene, const sim::Touch& touch, double speed_mps, TrueEvents& all) {
    const double excess_mps = speed_mps - scene.rules.kick_limit_mps;
    if (excess_mps <= -kKickMargin_mps || is_same(scene, touch.robot, excess_mps > 0)) return;
    (excess_mps > 0 ? raised_s_ : nearly_s_) = scene.time_s;
    if (excess_mps > 0) kicker_ = touch.robot;
    TrueEvent kick{"bot_kicked_ball_too_fast", scene.time_s, touch.robot.side, touch.robot,
                   touch.ball_m};
    kick.is_in_air = touch.vertical_mps > 0;
    add_measured(all, kick, excess_mps, kKickMargin_mps);
  }

  // Under the Laws, the referee ends play with the kick. Under the 2026 rules play continues:
  // another kick by the same robot counts once the ball has been slow enough, or after 2 s.
  bool is_same(const Scene& scene, RobotId kicker, bool is_foul) {
    const bool is_raised = scene.time_s - raised_s_ < kOneKick_s;
    if (!is_foul) return is_raised || scene.time_s - nearly_s_ < kOneKick_s;
    if (scene.rules.edition != Edition::kRules2026) return is_raised;
    return (is_raised && kicker_ == kicker) || !fast_.is_raised(scene, kicker);
  }

  double raised_s_ = -kOneKick_s;
  double nearly_s_ = -kOneKick_s;  // of the latest near miss
  std::optional<RobotId> kicker_;  // of the latest foul
  NonStopping fast_;               // robots whose kick is still too fast
};

}  // namespace

std::unique_ptr<GroundTruthRule> bot_kicked_ball_too_fast() {
  return std::make_unique<KickSpeed>();
}

}  // namespace autoref::judge::ground_truth
