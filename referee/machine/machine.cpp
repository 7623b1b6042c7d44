// The machine's transitions, and step().
#include "referee/machine/machine.hpp"

#include <algorithm>
#include <array>

#include "referee/machine/ball_in_play.hpp"
#include "referee/machine/cards.hpp"
#include "referee/machine/guards.hpp"

namespace autoref::referee {
namespace {

bool comes_in_play(Event event, Effect effect) {
  const EventEntry& entry = entry_of(event);
  return entry.effect == effect && entry.when != When::kInStop;
}

// clang-format off
constexpr std::array kInFigure = {
  Transition{"begin", State::kInit, Event::kBegin, kAlways, kBeginGames,
        State::kWaitStart, "paper 4.3; STOP: 2016", "D1"},
  Transition{"clients_moved", State::kWaitStart, Event::kRobotsMoved, kAlways, kPrepareFirstKickoff,
        State::kWaitStop, "paper 4.3, 4.4", "D5"},
  Transition{"start_timeout", State::kWaitStart, Event::kStartTimeout, kAlways, kPrepareFirstKickoff,
        State::kWaitStop, "AutoRef", "D2"},
  Transition{"prepare", State::kWaitStop, Event::kReady, kNextIsPreparation, kSendPreparation,
        State::kWaitStop, "2016", "D3, D13"},
  Transition{"prepare_late", State::kWaitStop, Event::kReadyTimeout, kNextIsPreparation, kSendPreparation,
        State::kWaitStop, "2016", "D3, D13"},
  Transition{"start", State::kWaitStop, Event::kReady, kNextStartsPlay, kStartPlay,
        State::kRun, "paper 4.2, 4.4", "D13"},
  Transition{"start_late", State::kWaitStop, Event::kReadyTimeout, kNextStartsPlay, kStartPlay,
        State::kRun, "paper 4.2, a fixed timeout", "D13"},
  Transition{"goal", State::kRun, Event::kGoal, kAlways, kAwardGoal,
        State::kDelayWait, "paper 4.2, 4.3", ""},
  Transition{"throw_in", State::kRun, Event::kThrowIn, kAlways, kStopPlay,
        State::kWaitStop, "paper 4.2", ""},
  Transition{"corner_kick", State::kRun, Event::kCornerKick, kAlways, kStopPlay,
        State::kWaitStop, "paper 4.2", ""},
  Transition{"goal_kick", State::kRun, Event::kGoalKick, kAlways, kStopPlay,
        State::kWaitStop, "paper 4.2", ""},
  Transition{"touch_line_unknown", State::kRun, Event::kTouchLineUnknown, kAlways, kStopPlay,
        State::kWaitStop, "AutoRef", "D14"},
  Transition{"attacker_too_close_to_defense_area", State::kRun, Event::kAttackerTooCloseToDefenseArea, kAlways, kStopPlay,
        State::kWaitStop, "paper 4.2; Laws", "D9"},
  Transition{"restart_not_taken", State::kRun, Event::kRestartNotTaken, kAlways, kStopPlay,
        State::kWaitStop, "2016, Laws", "D10"},
  Transition{"stuck_ball", State::kRun, Event::kStuckBall, kAlways, kStopPlay,
        State::kWaitStop, "2016, Laws", "D11"},
  Transition{"signalled", State::kDelayWait, Event::kSignalled, kDuringGame, kStopAfterSignal,
        State::kWaitStop, "paper 4.3; STOP: 2016", "D4"},
};

constexpr std::array kOutsideFigure = {
  Transition{"half_over", std::nullopt, Event::kHalfOver, kAlways, kEndHalf,
        State::kDelayWait, "paper 4.2, 4.3; HALT: AutoRef", "D12"},
  Transition{"next_half", State::kDelayWait, Event::kSignalled, kBetweenHalves, kBeginNextHalf,
        State::kWaitStop, "paper 4.2, 4.3; Laws", "D12"},
  Transition{"game_over", std::nullopt, Event::kGameOver, kGameWasLast, kEndGame,
        State::kOver, "paper 4.2", ""},
  Transition{"game_over_next", std::nullopt, Event::kGameOver, kNewGameFollows, kEndGame,
        State::kDelayWait, "paper 4.2; HALT: AutoRef", "D12"},
  Transition{"new_game", State::kDelayWait, Event::kSignalled, kAfterGame, kBeginNewGame,
        State::kWaitStop, "paper 4.2", ""},
};

constexpr std::array kBeyondPaper = {
  Transition{"", State::kRun, Event::kPenaltyPositions, kFoulsDecidePenalty, kNoteFoulInPenalty,
        State::kRun, "2026", ""},
  Transition{"", State::kRun, kFoulInPlay, kFoulsDecideKick, kNoteFoulInPenalty,
        State::kRun, "2026; Laws, appendix A", ""},
  Transition{"", std::nullopt, Event::kAttackerStaysNearArea, kSecondNearArea, kHaltForFoul,
        State::kDelayWait, "2026", ""},
  Transition{"", State::kWaitStop, Event::kAttackerStaysNearArea, kAlways, kSetRestartInStop,
        State::kWaitStop, "2026", ""},
  Transition{"", State::kWaitStop, Event::kBoundaryCrossing, kAlways, kSetRestartInStop,
        State::kWaitStop, "2026", ""},
  Transition{"", State::kWaitStop, Event::kBotInterferedPlacement, kAlways, kAllowMoreTime,
        State::kWaitStop, "2026", ""},
  Transition{"", State::kRun, kCallThatStopsPlay, kAlways, kStopPlay,
        State::kWaitStop, "rule book; goal_line_unknown: AutoRef", "D14"},
  Transition{"", State::kRun, kCallByBook, kFoulsStopPlay, kStopPlay,
        State::kWaitStop, "rule book", ""},
  Transition{"", State::kRun, kCallByBook, kFoulsAreNoted, kNoteFoul,
        State::kRun, "rule book", ""},
  Transition{"", State::kRun, kCallThatCounts, kAlways, kNoteFoul,
        State::kRun, "rule book", ""},
  Transition{"", State::kWaitStop, kCallInStop, kAlways, kNoteFoul,
        State::kWaitStop, "rule book", ""},
};
// clang-format on

bool leads_on(const Transition& transition, const RefereeState& state, const RefereeInput& input,
              Event event) {
  return transition.trigger.has(event) &&
         (!transition.from || *transition.from == state.machine_state) &&
         transition.guard.holds(state, input);
}

// The clock that counts actual play runs only in RUN; a transition from RUN to RUN does not affect
// it.
void follow_play(RefereeState& state, State before, double now_s) {
  if (before == state.machine_state) return;
  if (before == State::kRun) state.play_clock.stop(now_s);
  if (state.machine_state == State::kRun) state.play_clock.start(now_s);
}

const Transition* find_transition(std::span<const std::span<const Transition>> tables,
                                  const RefereeState& state, const RefereeInput& input,
                                  Event event) {
  for (const std::span<const Transition> transitions : tables) {
    for (const Transition& transition : transitions) {
      if (leads_on(transition, state, input, event)) return &transition;
    }
  }
  return nullptr;
}

void add_once(std::vector<std::string_view>& labels, std::string_view label) {
  if (std::find(labels.begin(), labels.end(), label) == labels.end()) labels.push_back(label);
}

bool waits_for_robots(const MidwayStart& midway_start) {
  return midway_start.is_stopped || needs_preparation(midway_start.restart);
}

bool begins_in_play(const RefereeState& state, const RefereeInput& /*input*/) {
  return state.midway_start && !waits_for_robots(*state.midway_start);
}

bool begins_at_restart(const RefereeState& state, const RefereeInput& /*input*/) {
  return state.midway_start && waits_for_robots(*state.midway_start);
}

// All yellow cards have the same duration, so none has more left.
void take_over_cards(CardBook& cards, const RefereeSignal& given, Side side, const RuleBook& rules,
                     double played_s) {
  cards.fouls = given.fouls[side];
  cards.cards_for_fouls = rules.fouls_per_card > 0 ? cards.fouls / rules.fouls_per_card : 0;
  if (!rules.has(RuleId::kCards)) return;
  for (const double left_s : given.yellow_left_s[side])
    cards.yellow_ends_s.push_back(played_s + std::min(left_s, rules.card_s));
}

// Timeouts left from the game do not count in extra time.
void take_over_timeouts(TimeoutBook& book, const RefereeSignal& given, Side side,
                        const TimeoutAllowance& allowance) {
  if (given.stage == Stage::kExtraTimeBreak) return;
  book.taken = std::max(0, allowance.timeouts - given.timeouts_left[side]);
  book.used_s = std::max(0.0, allowance.time_s - given.timeout_left_s[side]);
}

// The number of halves up to and including `half`.
std::size_t halves_until(int half, const Configuration& configuration) {
  std::size_t count = 1;
  for (int one = 0; one < half; one = half_after(configuration, one)) ++count;
  return count;
}

void take_over_goals(RefereeState& state, const RefereeInput& input, const RefereeSignal& given) {
  state.signal.goals = given.goals;
  state.goals_by_half.assign(halves_until(state.half, input.configuration), {});
  for (const Side side : kSides) {
    // A goal may have been revoked after its half.
    const int earlier =
        std::min(given.goals[side], state.midway_start->goals_in_earlier_halves[side]);
    state.goals_by_half.front()[side] = earlier;
    state.goals_by_half.back()[side] += given.goals[side] - earlier;
  }
}

// Continues the game whose last signal is `given`. In a break, the next half is about to begin.
void take_over(RefereeState& state, const RefereeInput& input, const RefereeSignal& given) {
  const RuleBook& rules = input.configuration.rules;
  RefereeSignal& signal = state.signal;
  state.half = half_in(given.stage).value();
  take_over_goals(state, input, given);
  if (rules.has(RuleId::kCards)) {
    signal.yellow_cards = given.yellow_cards;
    signal.red_cards = given.red_cards;
  }
  signal.blue_on_positive_half = given.blue_on_positive_half;
  if (is_break(given.stage) && rules.change_ends)
    signal.blue_on_positive_half = !signal.blue_on_positive_half;
  for (const Side side : kSides) {
    take_over_cards(state.cards[side], given, side, rules, state.play_clock.at_s(input.time_s()));
    take_over_timeouts(state.timeouts[side], given, side,
                       timeout_allowance(state, input.configuration));
    if (!given.can_place_ball[side] && !is_break(given.stage))
      state.placement_failures[side] = rules.placement_failures;
  }
}

void start_half(RefereeState& state, const RefereeInput& input) {
  const std::optional<RefereeSignal>& given = state.midway_start->signal;
  const double now_s = input.time_s();
  if (given) take_over(state, input, *given);
  allow_robots(state, input.configuration);
  state.signal.next_command = state.midway_start->restart;
  state.signal.stage = stage_of(state.half);
  state.half_began_s = clock_s(state, input.configuration.rules, now_s);
  if (!given) return;
  if (is_running(given->stage)) {
    const double whole_s = time_left_s(state, input.configuration, now_s);
    state.half_began_s -= whole_s - std::clamp(given->stage_time_left_s, 0.0, whole_s);
  } else if (state.signal.next_command &&
             state.signal.next_command->kind == CommandKind::kPrepareKickoff) {
    state.signal.stage = stage_before(state.half);  // the clock starts with the kick-off
  }
}

void begin_in_play(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  start_half(state, input);
  if (state.midway_start->restart) {
    place_ball(state, state.midway_start->ball_m);
    start_play(state, input, finding);
  } else {
    send(state, input, {CommandKind::kForceStart, Side::kWest});
    state.play = play_joined(input);
  }
}

void begin_at_restart(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  start_half(state, input);
  place_ball(state, state.midway_start->ball_m);
  if (state.midway_start->is_stopped) {
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
// Transitions of games that begin in the middle of a half.
constexpr std::array kMidway = {
  Transition{"begin_in_play", State::kInit, Event::kBegin, kBeginsInPlay, kBeginInPlay,
        State::kRun, "AutoRef", ""},
  Transition{"begin_at_restart", State::kInit, Event::kBegin, kBeginsAtRestart, kBeginAtRestart,
        State::kWaitStop, "AutoRef", ""},
};
// clang-format on

}  // namespace

bool stops_play(Event event) { return comes_in_play(event, Effect::kStopsPlay); }
bool stops_play_by_book(Event event) { return comes_in_play(event, Effect::kStopsByBook); }
bool counts_in_play(Event event) { return comes_in_play(event, Effect::kCounts); }

// Surplus robots are removed by hand, and a penalty kick may be retaken because of the robots'
// positions.
bool may_decide_penalty(Event event) {
  const EventEntry& entry = entry_of(event);
  return entry.is_foul && entry.when != When::kInStop && event != Event::kTooManyRobots &&
         event != Event::kPenaltyPositions;
}

std::span<const Transition> transitions_in_figure() { return kInFigure; }
std::span<const Transition> transitions_outside_figure() { return kOutsideFigure; }
std::span<const Transition> transitions_beyond_paper() { return kBeyondPaper; }

std::array<std::span<const Transition>, 6> all_transitions() {
  return {transitions_midway(),    transitions_of_administration(), transitions_of_placement(),
          transitions_in_figure(), transitions_outside_figure(),    transitions_beyond_paper()};
}

std::vector<std::string_view> all_labels() {
  std::vector<std::string_view> labels;
  for (const std::span<const Transition> transitions : all_transitions()) {
    for (const Transition& transition : transitions) {
      if (!transition.label.empty()) add_once(labels, transition.label);
      for (const EventEntry& entry : event_table()) {
        if (transition.label.empty() && transition.trigger.has(entry.event))
          add_once(labels, entry.name);
      }
    }
  }
  return labels;
}

Step step(const RefereeState& state, const RefereeInput& input, const Finding& finding) {
  return step(all_transitions(), state, input, finding);
}

Step step(std::span<const std::span<const Transition>> tables, const RefereeState& state,
          const RefereeInput& input, const Finding& finding) {
  Step taken{state, find_transition(tables, state, input, finding.event), {}, std::nullopt};
  if (taken.transition == nullptr) return taken;
  taken.label = taken.transition->label.empty() ? name_of(finding.event) : taken.transition->label;
  taken.transition->action.take(taken.state, input, finding);
  taken.state.machine_state = taken.transition->to.value_or(state.machine_state);
  follow_play(taken.state, state.machine_state, input.time_s());
  if (taken.state.signal.command_counter != state.signal.command_counter) {
    taken.sent = taken.state.signal.command;
  }
  return taken;
}

std::span<const Transition> transitions_midway() { return kMidway; }

}  // namespace autoref::referee
