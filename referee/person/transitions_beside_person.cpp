#include "referee/person/transitions_beside_person.hpp"

#include <algorithm>
#include <array>

#include "referee/machine/actions.hpp"
#include "referee/machine/ball_in_play.hpp"
#include "referee/machine/cards.hpp"
#include "referee/machine/guards.hpp"

namespace autoref::referee {
namespace {

bool given_starts_play(const RefereeState& /*state*/, const RefereeInput& input) {
  return starts_play(input.given->command.kind);
}

bool given_halts(const RefereeState& /*state*/, const RefereeInput& input) {
  const CommandKind kind = input.given->command.kind;
  return kind == CommandKind::kHalt || kind == CommandKind::kGoal;
}

bool given_is_timeout(const RefereeState& /*state*/, const RefereeInput& input) {
  return input.given->command.kind == CommandKind::kTimeout;
}

bool person_commands(const RefereeState& /*state*/, const RefereeInput& input) {
  return input.configuration.control == Control::kHuman;
}

bool nobody_commands(const RefereeState& /*state*/, const RefereeInput& input) {
  return input.configuration.control == Control::kNone;
}

bool person_commands_fouls_stop(const RefereeState& state, const RefereeInput& input) {
  return person_commands(state, input) && fouls_stop_play(state, input);
}

// The half that a stage belongs to, counted from 0. The stages before a half and the break before
// it belong to that half.
int half_of(Stage stage) {
  constexpr std::array<int, 14> kHalves = {0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 3, 3, 3};
  return kHalves[static_cast<std::size_t>(stage)];
}

void count_goals(RefereeState& state) {
  auto& by_half = state.goals_by_half;
  const int half = half_of(state.signal.stage);
  const bool is_shootout = state.signal.stage >= Stage::kShootoutBreak;
  if (half < state.half && !is_shootout) by_half.assign(1, {});  // a new game has begun
  if (!is_shootout) state.half = half;
  while (static_cast<int>(by_half.size()) <= state.half) by_half.push_back({});
  for (const Side side : kSides) {
    int before = 0;
    for (std::size_t i = 0; i + 1 < by_half.size(); ++i) before += by_half[i][side];
    by_half.back()[side] = state.signal.goals[side] - before;
  }
}

// A kick of a shoot-out ends when its play ends.
void count_kick(RefereeState& state) {
  if (state.signal.stage == Stage::kShootout && state.play.kicker)
    ++state.shootout.kicks[*state.play.kicker];
}

void end_followed_play(RefereeState& state, const RefereeInput& input) {
  count_kick(state);
  // A second foul near the area and a second attempt at a restart count as they do after AutoRef's
  // own stop (actions.cpp).
  const PerSide<int> fouls_near_area = state.watch.attacker_too_close_to_defense_area.fouls;
  const Finding* call = input.own_call;
  const Retakes retakes = call == nullptr ? Retakes{} : retakes_after(state.retakes, *call);
  const bool stays_near_area = call != nullptr && call->event == Event::kAttackerStaysNearArea;
  end_play(state);
  state.retakes = retakes;
  if (stays_near_area) state.watch.attacker_too_close_to_defense_area.fouls = fouls_near_area;
}

// The time when the command was given. Only a command that was in force when AutoRef joined is
// older than this frame.
double given_s(const RefereeState& state, const RefereeInput& input) {
  const bool is_joining = state.machine_state == State::kInit;
  return is_joining ? std::min(input.time_s(), input.given->command_time_s) : input.time_s();
}

void take_restart(RefereeState& state, const RefereeInput& input) {
  const RefereeSignal& given = *input.given;
  RefereeSignal& signal = state.signal;
  signal.next_command = given.next_command;
  if (!given.placement) {
    signal.placement.reset();
  } else if (!signal.placement || signal.placement->target_m != given.placement->target_m) {
    place_ball(state, given.placement->target_m);
  }
}

void take_command(RefereeState& state, const RefereeInput& input) {
  const double since_s = given_s(state, input);
  send(state, input, input.given->command);
  state.signal.command_time_s = since_s;
  take_values(state, input);
}

void follow_start(RefereeState& state, const RefereeInput& input, const Finding& /*finding*/) {
  const bool is_joining = state.machine_state == State::kInit;
  if (is_play(state.machine_state)) end_followed_play(state, input);
  const Command command = input.given->command;
  const std::optional<Placement> placement = state.signal.placement;
  take_command(state, input);
  state.play =
      is_joining ? play_joined(input) : play_begun(command, kicker_of(state, command), input);
  if (!is_joining && command.kind == CommandKind::kNormalStart && state.prepared)
    state.play.restart = *state.prepared;
  if (!is_joining && placement) state.play.position_m = placement->target_m;
  state.signal.placement.reset();
  state.signal.next_command.reset();
  state.watch = kept_at_start(state.watch);
}

void follow_stop(RefereeState& state, const RefereeInput& input, const Finding& /*finding*/) {
  const bool is_joining = state.machine_state == State::kInit;
  if (state.machine_state == State::kTimeout) state.watch = RuleWatch{};
  if (is_play(state.machine_state)) end_followed_play(state, input);
  take_command(state, input);
  take_restart(state, input);
  const Command command = state.signal.command;
  if (command.kind == CommandKind::kPrepareKickoff || command.kind == CommandKind::kPreparePenalty)
    state.prepared = command;
  wait_anew(state, input);
  if (!is_joining) return;
  for (const Side side : kSides)
    state.watch.attacker_too_close_to_defense_area.grace_from_s[side] = state.signal.command_time_s;
}

// After a halt, another stop begins.
void follow_halt(RefereeState& state, const RefereeInput& input, const Finding& /*finding*/) {
  if (is_play(state.machine_state)) {
    end_followed_play(state, input);
  } else if (state.signal.command.kind != CommandKind::kTimeout) {
    end_play(state);
  }
  take_command(state, input);
  take_restart(state, input);
}

// On its own call, AutoRef sends STOP and keeps the state of play in case it is overruled.
void emit_stop(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  count_foul(state, input, finding);
  place_ball(state, finding.ball_to_m);
  state.signal.next_command = finding.restart;
  send(state, input, {CommandKind::kStop, Side::kWest});
}

void note_call(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  count_foul(state, input, finding);
}

void note_call_in_penalty(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  count_foul(state, input, finding);
  note_foul_at_kick(state, finding);
}

// The person's command is in force again.
void resume_play(RefereeState& state, const RefereeInput& input, const Finding& /*finding*/) {
  state.signal.command = input.given->command;
  state.signal.placement.reset();
  state.signal.next_command.reset();
}

void join_play(RefereeState& state, const RefereeInput& input, const Finding& /*finding*/) {
  send(state, input, {CommandKind::kForceStart, Side::kWest});
  state.play = play_joined(input);
}

constexpr Guard kGivenStartsPlay{"it starts play", given_starts_play};
constexpr Guard kGivenHalts{"HALT or GOAL", given_halts};
constexpr Guard kGivenIsTimeout{"TIMEOUT", given_is_timeout};
constexpr Guard kPersonCommands{"a person commands", person_commands};
constexpr Guard kNobodyCommands{"nobody commands", nobody_commands};
constexpr Guard kPersonCommandsFoulsStop{"a person commands and fouls stop play",
                                         person_commands_fouls_stop};

constexpr Action kFollowStart{"follow; play begins, or is joined if it began before", follow_start};
constexpr Action kFollowStop{"follow; play ends", follow_stop};
constexpr Action kFollowHalt{"follow; play ends", follow_halt};
constexpr Action kEmitStop{"report the call; send STOP", emit_stop};
constexpr Action kNoteCall{"report the call; count the foul", note_call};
constexpr Action kNoteCallInPenalty{"report the call; it decides the penalty kick",
                                    note_call_in_penalty};
constexpr Action kResumePlay{"the person's command is in force again", resume_play};
constexpr Action kJoinPlay{"join play", join_play};

// clang-format off
constexpr std::array kBesidePerson = {
  Transition{"start_given", std::nullopt, Event::kCommandGiven, kGivenStartsPlay, kFollowStart,
        State::kRun, "paper 4.1, 5", ""},
  Transition{"halt_given", std::nullopt, Event::kCommandGiven, kGivenHalts, kFollowHalt,
        State::kDelayWait, "paper 4.1, 5", ""},
  Transition{"timeout_given", std::nullopt, Event::kCommandGiven, kGivenIsTimeout, kFollowHalt,
        State::kTimeout, "paper 4.1, 5", ""},
  Transition{"stop_given", std::nullopt, Event::kCommandGiven, kAlways, kFollowStop,
        State::kWaitStop, "paper 4.1, 5", ""},
  Transition{"overruled", State::kCalled, Event::kOverruled, kAlways, kResumePlay,
        State::kRun, "AutoRef", ""},
  Transition{"join", State::kInit, Event::kBegin, kNobodyCommands, kJoinPlay,
        State::kRun, "AutoRef", ""},
  Transition{"penalty_positions", State::kRun, Event::kPenaltyPositions, kFoulsDecidePenalty,
        kNoteCallInPenalty, State::kRun, "2026", ""},
  Transition{"", State::kRun, kFoulInPlay, kFoulsDecideKick, kNoteCallInPenalty,
        State::kRun, "2026; Laws, appendix A", ""},
  Transition{"", State::kRun, kCallThatStopsPlay, kPersonCommands, kEmitStop,
        State::kCalled, "paper 5", ""},
  Transition{"", State::kRun, kCallByBook, kPersonCommandsFoulsStop, kEmitStop,
        State::kCalled, "paper 5; rule book", ""},
  Transition{"", State::kRun, kCallThatStopsPlay, kNobodyCommands, kNoteCall,
        State::kRun, "AutoRef", ""},
  Transition{"", State::kRun, kCallByBook, kAlways, kNoteCall,
        State::kRun, "rule book", ""},
  Transition{"", State::kRun, kCallThatCounts, kAlways, kNoteCall,
        State::kRun, "rule book", ""},
  Transition{"boundary_crossing", State::kCalled, Event::kBoundaryCrossing, kAlways, kNoteCall,
        State::kCalled, "2026", ""},
  Transition{"", State::kWaitStop, kCallInStop, kAlways, kNoteCall,
        State::kWaitStop, "rule book", ""},
};
// clang-format on

}  // namespace

std::span<const Transition> transitions_beside_person() { return kBesidePerson; }

bool starts_play(CommandKind kind) {
  return kind == CommandKind::kNormalStart || kind == CommandKind::kForceStart ||
         kind == CommandKind::kDirectFree || kind == CommandKind::kIndirectFree;
}

void take_values(RefereeState& state, const RefereeInput& input) {
  const RefereeSignal& given = *input.given;
  RefereeSignal& signal = state.signal;
  const PerSide<int> robots_before = signal.robots_allowed;
  signal.stage = given.stage;
  signal.blue_on_positive_half = given.blue_on_positive_half;
  signal.keepers = given.keepers;
  signal.goals = given.goals;
  signal.shootout_goals = given.shootout_goals;
  signal.robots_allowed = given.robots_allowed;
  signal.yellow_cards = given.yellow_cards;
  signal.red_cards = given.red_cards;
  signal.yellow_left_s = given.yellow_left_s;
  signal.fouls = given.fouls;
  signal.timeouts_left = given.timeouts_left;
  signal.timeout_left_s = given.timeout_left_s;
  // If the number of robots allowed changed before AutoRef joined, the time of the change is
  // unknown, so the time to leave starts now.
  note_robots_allowed(state, input, robots_before);
  count_goals(state);
  // In CALLED, AutoRef's own restart is in force.
  if (!is_play(state.machine_state)) take_restart(state, input);
}

}  // namespace autoref::referee
