// Transitions of games that begin in the middle of a half.
#include "referee/machine/begin_midway.hpp"

#include <array>

#include "referee/machine/ball_in_play.hpp"
#include "referee/machine/cards.hpp"
#include "referee/machine/timekeeping.hpp"

namespace autoref::referee {
namespace {

bool needs_preparation(const std::optional<Command>& command) {
  return command && (command->kind == CommandKind::kPrepareKickoff ||
                     command->kind == CommandKind::kPreparePenalty);
}

bool waits_for_robots(const Beginning& beginning) {
  return beginning.is_stopped || needs_preparation(beginning.restart);
}

bool begins_in_play(const RefereeState& state, const RefereeInput& /*input*/) {
  return state.beginning && !waits_for_robots(*state.beginning);
}

bool begins_at_restart(const RefereeState& state, const RefereeInput& /*input*/) {
  return state.beginning && waits_for_robots(*state.beginning);
}

void start_half(RefereeState& state, const RefereeInput& input) {
  allow_robots(state, input.configuration);
  state.signal.stage = stage_of(state.half);
  state.half_began_s = clock_s(state, input.configuration.rules, input.time_s());
  state.signal.next_command = state.beginning->restart;
}

void begin_in_play(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  start_half(state, input);
  if (state.beginning->restart) {
    place_ball(state, state.beginning->ball_m);
    start_play(state, input, finding);
  } else {
    send(state, input, {CommandKind::kForceStart, Side::kWest});
    state.play = play_joined(input);
  }
}

void begin_at_restart(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  start_half(state, input);
  place_ball(state, state.beginning->ball_m);
  if (state.beginning->is_stopped) {
    send(state, input, {CommandKind::kStop, Side::kWest});
    wait_anew(state, input);
  } else {
    send_preparation(state, input, finding);
  }
}

constexpr Guard kBeginsInPlay{"the game begins in play", begins_in_play};
constexpr Guard kBeginsAtRestart{"the game begins before a restart", begins_at_restart};
constexpr Action kBeginInPlay{"start the half; send the restart, or FORCE_START", begin_in_play};
constexpr Action kBeginAtRestart{"start the half; place the ball; send STOP or the preparation",
                                 begin_at_restart};

// clang-format off
constexpr std::array kMidway = {
  Transition{"begin_in_play", State::kInit, Event::kBegin, kBeginsInPlay, kBeginInPlay,
        State::kRun, "AutoRef", ""},
  Transition{"begin_at_restart", State::kInit, Event::kBegin, kBeginsAtRestart, kBeginAtRestart,
        State::kWaitStop, "AutoRef", ""},
};
// clang-format on

}  // namespace

std::span<const Transition> transitions_midway() { return kMidway; }

}  // namespace autoref::referee
