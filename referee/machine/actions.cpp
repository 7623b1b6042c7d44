#include "referee/machine/actions.hpp"

#include "referee/machine/ball_in_play.hpp"
#include "referee/machine/ball_placement.hpp"
#include "referee/machine/cards.hpp"
#include "referee/machine/guards.hpp"
#include "referee/machine/penalty_outcome.hpp"
#include "referee/machine/readiness.hpp"

namespace autoref::referee {
namespace {

constexpr Command kStop{CommandKind::kStop, Side::kWest};
constexpr Command kHalt{CommandKind::kHalt, Side::kWest};
constexpr Command kNormalStart{CommandKind::kNormalStart, Side::kWest};

Command kickoff_of(Side side) { return {CommandKind::kPrepareKickoff, side}; }

void start_clock(RefereeState& state, const RefereeInput& input) {
  state.signal.stage = stage_of(state.half);
  state.half_began_s = clock_s(state, input.configuration.rules, input.time_s());
}

void give_restart(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  place_ball(state, finding.ball_to_m);
  state.signal.next_command = finding.restart;
  if (input.configuration.placement == PlacedBy::kTeams)
    leave_to_team(state, input.configuration.rules, finding);
}

void begin_break(RefereeState& state, const RefereeInput& input) {
  send(state, input, kHalt);
  state.delay_ends_s = input.time_s() + input.configuration.break_s;
}

void signal_goal(RefereeState& state, const RefereeInput& input, const Finding& finding,
                 Side scorer) {
  end_play(state);
  place_ball(state, finding.ball_to_m);
  state.signal.next_command = finding.restart;
  send(state, input, {CommandKind::kGoal, scorer});
  state.delay_ends_s = input.time_s();
}

}  // namespace

void send(RefereeState& state, const RefereeInput& input, const Command& command) {
  state.signal.command = command;
  state.signal.command_time_s = input.time_s();
  ++state.signal.command_counter;
}

void wait_anew(RefereeState& state, const RefereeInput& input) {
  state.wait_began_s = input.time_s();
  state.checked_s = input.time_s();
  state.saved = positions_in(input.frame);
}

void place_ball(RefereeState& state, const Vec2& target_m) {
  state.signal.placement = Placement{target_m, false};
  state.ball_in_position_since_s.reset();
}

void end_play(RefereeState& state) {
  state.play = PlayState{};
  state.watch = RuleWatch{};
  state.retakes = Retakes{};
  state.placing = TeamPlacement{};
  state.signal.placement.reset();
}

std::optional<Side> kicker_of(const RefereeState& state, const Command& command) {
  if (command.kind == CommandKind::kNormalStart && state.prepared) return state.prepared->side;
  if (is_for_one_side(command.kind)) return command.side;
  return std::nullopt;
}

// Deviation D1: STOP lets the clients move.
void begin(RefereeState& state, const RefereeInput& input, const Finding& /*finding*/) {
  send(state, input, kStop);
  state.signal.next_command = kickoff_of(kickoff_side(input.configuration, state.half));
  allow_robots(state, input.configuration);
  wait_anew(state, input);
}

void prepare_first_kickoff(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  place_ball(state, Vec2(0, 0));
  send_preparation(state, input, finding);
}

// Deviation D3: after a PREPARE command, the referee waits once more and then sends the ready
// command.
void send_preparation(RefereeState& state, const RefereeInput& input, const Finding& /*finding*/) {
  const Command preparation = *state.signal.next_command;
  send(state, input, preparation);
  state.prepared = preparation;
  state.signal.next_command = kNormalStart;
  state.signal.placement->at_once = false;
  wait_anew(state, input);
}

void start_play(RefereeState& state, const RefereeInput& input, const Finding& /*finding*/) {
  const Command command = *state.signal.next_command;
  send(state, input, command);
  state.play = play_begun(command, kicker_of(state, command), input);
  if (command.kind == CommandKind::kNormalStart && state.prepared) {
    state.play.restart = *state.prepared;
  }
  if (state.signal.placement) state.play.position_m = state.signal.placement->target_m;
  state.signal.placement.reset();
  state.signal.next_command.reset();
  state.watch = kept_at_start(state.watch);
  if (command.kind == CommandKind::kNormalStart && is_before_half(state.signal.stage)) {
    start_clock(state, input);
  }
}

void award_goal(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  const Side scorer = opponent_of(finding.restart.side);
  ++state.signal.goals[scorer];
  ++state.goals_by_half.back()[scorer];
  signal_goal(state, input, finding, scorer);
}

void stop_play(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  book(state, input, finding);
  const Retakes retakes = retakes_after(state.retakes, finding);
  const PerSide<int> fouls_near_area = state.watch.attacker_too_close_to_defense_area.fouls;
  end_play(state);
  state.retakes = retakes;
  // A team's second foul counts even if its first foul has already stopped play.
  if (finding.event == Event::kAttackerStaysNearArea) {
    state.watch.attacker_too_close_to_defense_area.fouls = fouls_near_area;
  }
  give_restart(state, input, finding);
  send(state, input, kStop);
  wait_anew(state, input);
}

void note_foul(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  book(state, input, finding);
}

// The rule penalty_kick_failed, or the rule on shoot-outs, reports the consequences of the fouls.
void note_foul_at_kick(RefereeState& state, const Finding& finding) {
  for (const Side side : kSides) {
    if (!finding.offender || *finding.offender == side) state.play.has_fouled[side] = true;
  }
}

void note_foul_in_penalty(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  book(state, input, finding);
  note_foul_at_kick(state, finding);
}

void allow_more_time(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  book(state, input, finding);
  state.wait_began_s += input.configuration.rules.interference_s;
}

// A kick-off or penalty kick that stays the restart is prepared again.
void set_restart_in_stop(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  book(state, input, finding);
  if (finding.restart != pending_restart(state)) state.retakes = Retakes{};
  give_restart(state, input, finding);
  if (state.signal.command != kStop) send(state, input, kStop);
  wait_anew(state, input);
}

// At a tournament, people would clear the field during the halt; here, it only gives the robots
// time to stop.
void halt_for_foul(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  book(state, input, finding);
  end_play(state);
  give_restart(state, input, finding);
  send(state, input, kHalt);
  state.delay_ends_s = input.time_s() + input.configuration.rules.halt_s;
}

void show_card(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  for (const Side side : kSides) {
    if (!finding.offender || *finding.offender == side) ++state.cards[side].cards_for_fouls;
  }
  book(state, input, finding);
}

void end_card(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  take_card_off(state, input.configuration, finding);
}

// Deviation D4: STOP follows the command that is sent only briefly.
void stop_after_signal(RefereeState& state, const RefereeInput& input, const Finding& /*finding*/) {
  send(state, input, kStop);
  wait_anew(state, input);
}

// Deviation D12: at half-time, the command that is sent only briefly is HALT.
void end_half(RefereeState& state, const RefereeInput& input, const Finding& /*finding*/) {
  end_play(state);
  const int next = half_after(input.configuration, state.half);
  state.signal.stage = break_before(next);
  state.signal.next_command = kickoff_of(kickoff_side(input.configuration, next));
  begin_break(state, input);
}

void begin_extra_time(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  state.timeouts = {};
  end_half(state, input, finding);
}

void begin_next_half(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  state.half = half_after(input.configuration, state.half);
  state.goals_by_half.push_back({});
  state.placement_failures = {};
  state.signal.stage = stage_before(state.half);
  if (input.configuration.rules.change_ends)
    state.signal.blue_on_positive_half = !state.signal.blue_on_positive_half;
  place_ball(state, Vec2(0, 0));
  stop_after_signal(state, input, finding);
}

void begin_timeout(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  state.timeout_side = finding.restart.side;
  ++state.timeouts[state.timeout_side].taken;
  state.timeout_clock.start(input.time_s());
  // A prepared kick-off or penalty is prepared again, because STOP cancels the preparation.
  state.signal.next_command = pending_restart(state);
  send(state, input, finding.restart);
}

void end_timeout(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  state.timeouts[state.timeout_side].used_s += finding.value;
  state.timeout_clock.stop(input.time_s());
  state.watch = RuleWatch{};
  state.signal.placement->at_once = false;
  stop_after_signal(state, input, finding);
}

void end_for_shootout(RefereeState& state, const RefereeInput& input, const Finding& /*finding*/) {
  end_play(state);
  state.signal.stage = Stage::kShootoutBreak;
  const Side kicker = next_kicker(state.shootout, input.configuration);
  state.signal.next_command = {CommandKind::kPreparePenalty, kicker};
  begin_break(state, input);
}

void begin_shootout(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  state.signal.stage = Stage::kShootout;
  const Side kicker = next_kicker(state.shootout, input.configuration);
  place_ball(state, input.configuration.field.penalty_mark_at(opponent_of(kicker)));
  stop_after_signal(state, input, finding);
}

void count_shootout_goal(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  const Side kicker = next_kicker(state.shootout, input.configuration);
  ++state.shootout.kicks[kicker];
  state.signal.shootout_goals[kicker] = ++state.shootout.goals[kicker];
  signal_goal(state, input, finding, kicker);
}

void count_shootout_miss(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  ++state.shootout.kicks[next_kicker(state.shootout, input.configuration)];
  stop_play(state, input, finding);
}

void end_game(RefereeState& state, const RefereeInput& input, const Finding& /*finding*/) {
  end_play(state);
  state.signal.stage = Stage::kPostGame;
  state.signal.next_command.reset();
  send(state, input, kHalt);
  state.delay_ends_s = input.time_s();
  ++state.games_finished;
}

void begin_new_game(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  state.half = 0;
  state.goals_by_half.assign(1, {});
  state.signal.goals = {};
  state.cards = {};
  state.timeouts = {};
  state.shootout = {};
  state.placement_failures = {};
  state.signal.shootout_goals = {};
  state.signal.yellow_cards = state.signal.red_cards = {};
  allow_robots(state, input.configuration);
  state.signal.stage = stage_before(0);
  state.signal.blue_on_positive_half = true;
  state.signal.next_command = kickoff_of(kickoff_side(input.configuration, 0));
  place_ball(state, Vec2(0, 0));
  stop_after_signal(state, input, finding);
}

}  // namespace autoref::referee
