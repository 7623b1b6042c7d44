#include "referee/machine/actions.hpp"

#include "referee/machine/ball_in_play.hpp"
#include "referee/machine/cards.hpp"
#include "referee/machine/readiness.hpp"
#include "referee/machine/retakes.hpp"
#include "referee/machine/shootout.hpp"
#include "referee/machine/timekeeping.hpp"

namespace autoref::referee {
namespace {

constexpr Command kStop{CommandKind::kStop, Side::kWest};
constexpr Command kHalt{CommandKind::kHalt, Side::kWest};
constexpr Command kNormalStart{CommandKind::kNormalStart, Side::kWest};

Command kickoff_of(Side side) { return {CommandKind::kPrepareKickoff, side}; }

void send(Memory& memory, const Moment& moment, const Command& command) {
  memory.signal.command = command;
  memory.signal.command_time_s = moment.time_s();
  ++memory.signal.command_counter;
}

// "When entering the WAIT_STOP state, AutoRef saves the current positions" (paper, section 4.4).
void wait_anew(Memory& memory, const Moment& moment) {
  memory.wait_began_s = moment.time_s();
  memory.looked_s = moment.time_s();
  memory.saved = positions_in(moment.frame);
}

void place_ball(Memory& memory, const Vec2& target_m) {
  memory.signal.placement = Placement{target_m, false};
  memory.ball_in_place_since_s.reset();
}

void end_play(Memory& memory) {
  memory.play = PlayMemory{};
  memory.watch = RuleWatch{};
  memory.retakes = Retakes{};
  memory.signal.placement.reset();
}

void start_clock(Memory& memory, const Moment& moment) {
  memory.signal.stage = stage_of(memory.half);
  memory.half_began_s = clock_s(memory, moment.configuration.rules, moment.time_s());
}

void begin_break(Memory& memory, const Moment& moment) {
  send(memory, moment, kHalt);
  memory.delay_ends_s = moment.time_s() + moment.configuration.break_s;
}

void signal_goal(Memory& memory, const Moment& moment, const Finding& finding, Side scorer) {
  end_play(memory);
  place_ball(memory, finding.ball_to_m);
  memory.signal.next_command = finding.restart;
  send(memory, moment, {CommandKind::kGoal, scorer});
  memory.delay_ends_s = moment.time_s();
}

std::optional<Side> kicker_of(const Memory& memory, const Command& command) {
  if (command.kind == CommandKind::kNormalStart && memory.prepared) return memory.prepared->side;
  if (is_for_one_side(command.kind)) return command.side;
  return std::nullopt;
}

}  // namespace

// Deviation D1: STOP tells the clients that they may move.
void begin(Memory& memory, const Moment& moment, const Finding& /*finding*/) {
  send(memory, moment, kStop);
  memory.signal.next_command = kickoff_of(kickoff_side(moment.configuration, memory.half));
  allow_robots(memory, moment.configuration);
  wait_anew(memory, moment);
}

void prepare_first_kickoff(Memory& memory, const Moment& moment, const Finding& finding) {
  place_ball(memory, Vec2(0, 0));
  send_preparation(memory, moment, finding);
}

// Deviation D3: a preparation is followed by a wait of its own, and then by the ready command.
void send_preparation(Memory& memory, const Moment& moment, const Finding& /*finding*/) {
  const Command preparation = *memory.signal.next_command;
  send(memory, moment, preparation);
  memory.prepared = preparation;
  memory.signal.next_command = kNormalStart;
  memory.signal.placement->at_once = false;
  wait_anew(memory, moment);
}

void start_play(Memory& memory, const Moment& moment, const Finding& /*finding*/) {
  const Command command = *memory.signal.next_command;
  send(memory, moment, command);
  memory.play = play_begun(command, kicker_of(memory, command), moment);
  if (command.kind == CommandKind::kNormalStart && memory.prepared) {
    memory.play.restart = *memory.prepared;
  }
  if (memory.signal.placement) memory.play.place_m = memory.signal.placement->target_m;
  memory.signal.placement.reset();
  memory.signal.next_command.reset();
  memory.watch = kept_at_start(memory.watch);
  if (command.kind == CommandKind::kNormalStart && is_before_half(memory.signal.stage)) {
    start_clock(memory, moment);
  }
}

void award_goal(Memory& memory, const Moment& moment, const Finding& finding) {
  const Side scorer = opponent_of(finding.restart.side);
  ++memory.signal.goals[scorer];
  ++memory.goals_by_half.back()[scorer];
  signal_goal(memory, moment, finding, scorer);
}

void stop_play(Memory& memory, const Moment& moment, const Finding& finding) {
  book(memory, moment, finding);
  const Retakes retakes = retakes_after(memory.retakes, finding);
  end_play(memory);
  memory.retakes = retakes;
  place_ball(memory, finding.ball_to_m);
  memory.signal.next_command = finding.restart;
  send(memory, moment, kStop);
  wait_anew(memory, moment);
}

void note_foul(Memory& memory, const Moment& moment, const Finding& finding) {
  book(memory, moment, finding);
}

void show_card(Memory& memory, const Moment& moment, const Finding& finding) {
  for (const Side side : kSides) {
    if (!finding.offender || *finding.offender == side) ++memory.cards[side].cards_for_fouls;
  }
  book(memory, moment, finding);
}

void end_card(Memory& memory, const Moment& moment, const Finding& finding) {
  take_card_off(memory, moment.configuration, finding);
}

// Deviation D4: the briefly transmitted command is followed by STOP.
void stop_after_signal(Memory& memory, const Moment& moment, const Finding& /*finding*/) {
  send(memory, moment, kStop);
  wait_anew(memory, moment);
}

// Deviation D12: the briefly transmitted command at half-time is HALT.
void end_half(Memory& memory, const Moment& moment, const Finding& /*finding*/) {
  end_play(memory);
  const int next = half_after(moment.configuration, memory.half);
  memory.signal.stage = break_before(next);
  memory.signal.next_command = kickoff_of(kickoff_side(moment.configuration, next));
  begin_break(memory, moment);
}

void begin_extra_time(Memory& memory, const Moment& moment, const Finding& finding) {
  memory.timeouts = {};
  end_half(memory, moment, finding);
}

void begin_next_half(Memory& memory, const Moment& moment, const Finding& finding) {
  memory.half = half_after(moment.configuration, memory.half);
  memory.goals_by_half.push_back({});
  memory.signal.stage = stage_before(memory.half);
  place_ball(memory, Vec2(0, 0));
  stop_after_signal(memory, moment, finding);
}

void begin_timeout(Memory& memory, const Moment& moment, const Finding& finding) {
  memory.timeout_side = finding.restart.side;
  ++memory.timeouts[memory.timeout_side].taken;
  memory.timeout_clock.start(moment.time_s());
  // What was prepared is prepared again: STOP comes in between.
  if (memory.signal.next_command == kNormalStart) {
    memory.signal.next_command = memory.prepared;
  }
  send(memory, moment, finding.restart);
}

void end_timeout(Memory& memory, const Moment& moment, const Finding& finding) {
  memory.timeouts[memory.timeout_side].used_s += finding.value;
  memory.timeout_clock.stop(moment.time_s());
  memory.watch = RuleWatch{};
  memory.signal.placement->at_once = false;
  stop_after_signal(memory, moment, finding);
}

void end_for_shootout(Memory& memory, const Moment& moment, const Finding& /*finding*/) {
  end_play(memory);
  memory.signal.stage = Stage::kShootoutBreak;
  const Side kicker = next_kicker(memory.shootout, moment.configuration);
  memory.signal.next_command = {CommandKind::kPreparePenalty, kicker};
  begin_break(memory, moment);
}

void begin_shootout(Memory& memory, const Moment& moment, const Finding& finding) {
  memory.signal.stage = Stage::kShootout;
  const Side kicker = next_kicker(memory.shootout, moment.configuration);
  place_ball(memory, moment.configuration.field.penalty_mark_at(opponent_of(kicker)));
  stop_after_signal(memory, moment, finding);
}

void count_shootout_goal(Memory& memory, const Moment& moment, const Finding& finding) {
  const Side kicker = next_kicker(memory.shootout, moment.configuration);
  ++memory.shootout.kicks[kicker];
  memory.signal.shootout_goals[kicker] = ++memory.shootout.goals[kicker];
  signal_goal(memory, moment, finding, kicker);
}

void count_shootout_miss(Memory& memory, const Moment& moment, const Finding& finding) {
  ++memory.shootout.kicks[next_kicker(memory.shootout, moment.configuration)];
  stop_play(memory, moment, finding);
}

void end_game(Memory& memory, const Moment& moment, const Finding& /*finding*/) {
  end_play(memory);
  memory.signal.stage = Stage::kPostGame;
  memory.signal.next_command.reset();
  send(memory, moment, kHalt);
  memory.delay_ends_s = moment.time_s();
  ++memory.games_finished;
}

void begin_new_game(Memory& memory, const Moment& moment, const Finding& finding) {
  memory.half = 0;
  memory.goals_by_half.assign(1, {});
  memory.signal.goals = {};
  memory.cards = {};
  memory.timeouts = {};
  memory.shootout = {};
  memory.signal.shootout_goals = {};
  memory.signal.yellow_cards = memory.signal.red_cards = {};
  allow_robots(memory, moment.configuration);
  memory.signal.stage = stage_before(0);
  memory.signal.next_command = kickoff_of(kickoff_side(moment.configuration, 0));
  place_ball(memory, Vec2(0, 0));
  stop_after_signal(memory, moment, finding);
}

}  // namespace autoref::referee
