// Collisions of two opponents at too high a relative speed.
#include <cmath>

#include "judge/truth/ground_truth_rules.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::judge::ground_truth {
namespace {

constexpr double kCrashMargin_mps = 0.2_mps;
constexpr double kDrawnMargin_mps = 0.1_mps;
// If the hulls of two robots come this close, it is a near miss.
constexpr double kNearlyMet_m = 8_mm;
// If robots would have collided within this time after the end of play, the call was early.
constexpr double kCrashLead_s = 0.05;

class Crash final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    // 2026 rules, appendix C: "always".
    if (!frame.play.is_on && frame.rules.edition != Edition::kRules2026) return;
    for (const sim::RobotCollision& met : frame.collisions) {
      if (met.robots[0].side != met.robots[1].side) evaluate(frame, met, Standing::kTrue, all);
    }
    for_each_robot(frame.now, Side::kWest, [&](RobotId west, const sim::RobotState& a) {
      for_each_robot(frame.now, Side::kEast, [&](RobotId east, const sim::RobotState& b) {
        foresee(frame,
                {frame.now.frame,
                 0,
                 {west, east},
                 {a.velocity_mps, b.velocity_mps},
                 {a.position_m, b.position_m}},
                all);
      });
    });
  }

 private:
  static double closing_mps(const sim::RobotCollision& met) {
    const Vec2 line = direction_of(met.centres_m[1] - met.centres_m[0], Vec2(1.0, 0.0));
    return (met.velocities_mps[0] - met.velocities_mps[1]).dot(line);
  }

  // Reports robots that are about to collide.
  static void foresee(const TrueFrame& frame, const sim::RobotCollision& met, TrueEvents& all) {
    const double gap_m = (met.centres_m[1] - met.centres_m[0]).norm() - 2 * kRobotRadius_m;
    const double closes_mps = closing_mps(met);
    if (gap_m <= 0 || closes_mps < frame.rules.crash_mps - kCrashMargin_mps) return;
    if (frame.play.ends_now && gap_m < kCrashLead_s * closes_mps) {
      evaluate(frame, met, Standing::kPrevented, all);
    } else if (gap_m < kNearlyMet_m) {
      evaluate(frame, met, Standing::kNearMiss, all);
    }
  }

  static void evaluate(const TrueFrame& frame, const sim::RobotCollision& met, Standing standing,
                       TrueEvents& all) {
    const double faster_mps = met.velocities_mps[0].norm() - met.velocities_mps[1].norm();
    const double lead_mps = std::abs(faster_mps) - frame.rules.crash_drawn_mps;
    const double excess_mps = closing_mps(met) - frame.rules.crash_mps;
    if (excess_mps <= -kCrashMargin_mps) return;
    TrueEvent crash;
    crash.time_s = frame.time_s;
    crash.position_m = (met.centres_m[0] + met.centres_m[1]) / 2.0;
    crash.is_borderline = excess_mps <= kCrashMargin_mps || std::abs(lead_mps) < kDrawnMargin_mps;
    crash.robot = met.robots[faster_mps > 0 ? 0 : 1];
    const bool is_drawn = lead_mps < 0;
    crash.standing = excess_mps > 0 ? standing : Standing::kNearMiss;
    if (!is_drawn || std::abs(lead_mps) < kDrawnMargin_mps) {
      add_crash(crash, is_drawn, all);
    }
    if (frame.rules.edition != Edition::kRules2026) return;
    if (is_drawn || lead_mps < kDrawnMargin_mps) add_drawn(crash, is_drawn, all);
  }

  // A crash close to the limit between unique and drawn is reported as one of them, and as a near
  // miss of the other.
  static void add_crash(TrueEvent crash, bool is_drawn, TrueEvents& all) {
    crash.name = "bot_crash_unique";
    crash.offender = crash.robot->side;
    if (is_drawn) crash.standing = Standing::kNearMiss;
    all.push_back(crash);
  }
  static void add_drawn(TrueEvent crash, bool is_drawn, TrueEvents& all) {
    crash.name = "bot_crash_drawn";
    crash.robot.reset();
    if (!is_drawn) crash.standing = Standing::kNearMiss;
    all.push_back(crash);
  }
};

}  // namespace

std::unique_ptr<GroundTruthRule> bot_crash_unique() { return std::make_unique<Crash>(); }

}  // namespace autoref::judge::ground_truth
