// The ball is faster than allowed after a robot's kick or touch.
#include <cmath>

#include "runner/judge/truth/truths.hpp"
#include "soccer/units.hpp"

namespace autoref::runner::truth {
namespace {

constexpr double kMargin_mps = 0.2_mps;
constexpr double kOneKick_s = 0.2;  // a kick that is still at the hull is not a second one

class KickSpeed final : public Truth {
 public:
  void watch(const Scene& scene, Happenings& all) override {
    if (!scene.play.is_on) return;
    double former_mps =
        speed_mps(scene, scene.before.ball.velocity_mps, scene.before.ball.vertical_mps);
    for (const sim::Touch& touch : scene.touches) {
      const double after_mps = speed_mps(scene, touch.ball_mps, touch.vertical_mps);
      // A fast ball that merely glances off was made fast by somebody else.
      if (after_mps > former_mps) judge(scene, touch, after_mps, all);
      former_mps = after_mps;
    }
  }

 private:
  static double speed_mps(const Scene& scene, const Vec2& plane_mps, double vertical_mps) {
    if (scene.rules.edition != Edition::kRules2026) return plane_mps.norm();
    return std::sqrt(plane_mps.squaredNorm() + vertical_mps * vertical_mps);
  }

  void judge(const Scene& scene, const sim::Touch& touch, double speed_mps, Happenings& all) {
    const double excess_mps = speed_mps - scene.rules.kick_limit_mps;
    if (excess_mps <= -kMargin_mps || scene.time_s - told_s_ < kOneKick_s) return;
    told_s_ = scene.time_s;
    Happening kick{"kick_speed", scene.time_s, touch.robot.side, touch.robot, touch.ball_m};
    kick.is_in_air = touch.vertical_mps > 0;
    add_measured(all, kick, excess_mps, kMargin_mps);
  }

  double told_s_ = -kOneKick_s;
};

}  // namespace

std::unique_ptr<Truth> kick_speed() { return std::make_unique<KickSpeed>(); }

}  // namespace autoref::runner::truth
