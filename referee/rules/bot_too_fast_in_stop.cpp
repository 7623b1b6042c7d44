// Robots are slow while play is stopped: 1 m/s (Laws 2014, single size) or 1.5 m/s, after 2 s of
// grace. Who is faster for 0.1 s is told once in a stop.
#include <fmt/format.h>

#include "referee/rules/rule.hpp"

namespace autoref::referee {
namespace {

// More than 0.1 s: tracked velocities lag behind robots that brake by a frame.
constexpr double kTooFastFor_s = 120_ms;
// Tracked velocities are wrong by so many deviations of a frame's place a second: by about
// 0.05 m/s where a frame is by 1.3 mm.
constexpr double kSpeedNoise_hz = 40;

std::optional<Finding> find_bot_too_fast_in_stop(RefereeState& state, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  const bool holds = state.signal.command.kind == CommandKind::kStop &&
                     has_passed(state.signal.command_time_s, c.rules.stop_grace_s, input.time_s());
  const double limit_mps = c.rules.stop_speed_mps + kSpeedNoise_hz * c.noise.robot_m;
  const auto excess_mps = [&](Side /*side*/, const TrackedRobot& robot) {
    return holds ? robot.velocity_mps.norm() - limit_mps : 0.0;
  };
  const std::optional<GraceViolation> fastest =
      take_worst(state.watch.bot_too_fast_in_stop, input, kTooFastFor_s, excess_mps);
  if (!fastest) return std::nullopt;
  Finding finding = note_of(Event::kBotTooFastInStop, RuleId::kBotTooFastInStop, c.rules,
                            fastest->id, fastest->position_m);
  finding.value = fastest->excess + limit_mps;
  finding.evidence =
      fmt::format("{} drives at {:.2f} m/s, {:.1f} s after play was stopped.", text_of(fastest->id),
                  finding.value, input.time_s() - state.signal.command_time_s);
  return finding;
}

}  // namespace

constinit const Rule kBotTooFastInStopRule{{State::kWaitStop}, find_bot_too_fast_in_stop};

}  // namespace autoref::referee
