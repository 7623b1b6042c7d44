// While play is stopped, robots must drive slowly: at most 1 m/s (Laws 2014, single size), or 1.5
// m/s after 2 s of grace. A foul is called if a robot exceeds this speed for 0.1 s, at most once
// per robot and stop. If several robots of a team are too fast within 2 s, only the first one
// counts. During ball placement, no robot counts (2026, Fouls While Ball Out Of Play).
#include <fmt/format.h>

#include "referee/machine/readiness.hpp"
#include "referee/rules/rule.hpp"

namespace autoref::referee {
namespace {

// This time is longer than 0.1 s, because the tracked velocity of a braking robot lags by a frame.
constexpr double kTooFastFor_s = 120_ms;
// Standard deviation of tracked velocities per standard deviation of detected positions: 0.05 m/s
// for 1.3 mm.
constexpr double kSpeedNoise_hz = 40;

bool is_being_placed(const RefereeState& state, const RefereeInput& input) {
  const RuleBook& rules = input.configuration.rules;
  return rules.edition == Edition::kRules2026 && state.signal.placement && input.ball &&
         (input.ball->position_m - state.signal.placement->target_m).norm() >
             ball_tolerance_m(input.configuration) + 3 * input.configuration.noise.ball_m;
}

bool has_just_been_called(const StopSpeedWatch& watch, Side side, const RefereeInput& input) {
  const RuleBook& rules = input.configuration.rules;
  return rules.edition == Edition::kRules2026 && watch.called_s[side] &&
         !has_passed(*watch.called_s[side], rules.foul_repeat_s, input.time_s());
}

std::optional<Finding> find_bot_too_fast_in_stop(RefereeState& state, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  const bool holds =
      state.signal.command.kind == CommandKind::kStop &&
      has_passed(state.signal.command_time_s, c.rules.stop_grace_s, input.time_s()) &&
      !is_being_placed(state, input);
  const double limit_mps = c.rules.stop_speed_mps + kSpeedNoise_hz * c.noise.robot_m;
  StopSpeedWatch& watch = state.watch.bot_too_fast_in_stop;
  const auto excess_mps = [&](Side side, const TrackedRobot& robot) {
    return holds && !has_just_been_called(watch, side, input)
               ? robot.velocity_mps.norm() - limit_mps
               : 0.0;
  };
  const std::optional<GraceViolation> fastest =
      take_worst(watch.robots, input, kTooFastFor_s, excess_mps);
  if (!fastest) return std::nullopt;
  watch.called_s[fastest->id.side] = input.time_s();
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
