#include "referee/machine/guards.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>

#include "referee/machine/penalty_outcome.hpp"

namespace autoref::referee {
namespace {

constexpr std::array<Stage, kMaxHalves> kBefore = {Stage::kFirstHalfPre, Stage::kSecondHalfPre,
                                                   Stage::kExtraFirstHalfPre,
                                                   Stage::kExtraSecondHalfPre};
constexpr std::array<Stage, kMaxHalves> kRunning = {
    Stage::kFirstHalf, Stage::kSecondHalf, Stage::kExtraFirstHalf, Stage::kExtraSecondHalf};
constexpr std::array<Stage, kMaxHalves - 1> kBreaks = {Stage::kHalfTime, Stage::kExtraTimeBreak,
                                                       Stage::kExtraHalfTime};

template <typename Stages>
bool contains(const Stages& stages, Stage stage) {
  return std::find(stages.begin(), stages.end(), stage) != stages.end();
}

double length_s(const Configuration& configuration, int half) {
  return is_extra(configuration, half) ? configuration.rules.extra_half_s : configuration.half_s;
}

bool is_last(const Configuration& configuration, int half) {
  if (is_extra(configuration, half)) return half + 1 == kMaxHalves;
  return half + 1 == configuration.halves;
}

std::string text_of_half(const RefereeState& state, const Configuration& configuration) {
  if (!is_extra(configuration, state.half)) {
    return fmt::format("Half {} of {}", state.half + 1, configuration.halves);
  }
  return fmt::format("Half {} of extra time", state.half + 1 - kFirstExtraHalf);
}

Event end_of(const RefereeState& state, const Configuration& configuration) {
  if (!is_last(configuration, state.half)) return Event::kHalfOver;
  const PerSide<int>& goals = state.signal.goals;
  const bool is_drawn = goals[Side::kWest] == goals[Side::kEast];
  if (!configuration.knockout || !is_drawn) return Event::kGameOver;
  return is_extra(configuration, state.half) ? Event::kShootout : Event::kExtraTime;
}

bool is_penalty(const std::optional<Command>& command) {
  return command && command->kind == CommandKind::kPreparePenalty;
}

// Whether a penalty kick has been awarded and is not over.
bool is_penalty_pending(const RefereeState& state, const RefereeInput& input) {
  if (state.machine_state != State::kRun) return is_penalty(pending_restart(state));
  return state.play.is_penalty() && !is_penalty_over(state, input);
}

// The command GOAL stays in force for a frame, so that every receiver sees it.
bool is_goal_being_signalled(const RefereeState& state, const RefereeInput& input) {
  return state.signal.command.kind == CommandKind::kGoal &&
         state.signal.command_time_s == input.time_s();
}

}  // namespace

bool holds_always(const RefereeState& /*state*/, const RefereeInput& /*input*/) { return true; }

bool next_is_preparation(const RefereeState& state, const RefereeInput& /*input*/) {
  const std::optional<Command>& next = state.signal.next_command;
  return next &&
         (next->kind == CommandKind::kPrepareKickoff || next->kind == CommandKind::kPreparePenalty);
}

bool next_starts_play(const RefereeState& state, const RefereeInput& input) {
  return state.signal.next_command && !next_is_preparation(state, input);
}

bool is_during_game(const RefereeState& state, const RefereeInput& input) {
  return !is_between_halves(state, input) && !is_after_game(state, input);
}

bool is_between_halves(const RefereeState& state, const RefereeInput& /*input*/) {
  return is_break(state.signal.stage);
}

bool is_after_game(const RefereeState& state, const RefereeInput& /*input*/) {
  return state.signal.stage == Stage::kPostGame;
}

bool is_before_shootout(const RefereeState& state, const RefereeInput& /*input*/) {
  return state.signal.stage == Stage::kShootoutBreak;
}

bool is_in_shootout(const RefereeState& state, const RefereeInput& /*input*/) {
  return state.signal.stage == Stage::kShootout;
}

bool game_was_last(const RefereeState& /*state*/, const RefereeInput& input) {
  return input.configuration.after_game == AfterGame::kHalt;
}

bool new_game_follows(const RefereeState& /*state*/, const RefereeInput& input) {
  return input.configuration.after_game == AfterGame::kNewGame;
}

bool fouls_stop_play(const RefereeState& /*state*/, const RefereeInput& input) {
  return input.configuration.rules.fouls_stop_play;
}

bool has_fouls_for_halt(const RefereeState& state, const RefereeInput& input) {
  return state.watch.attacker_too_close_to_defense_area.has_team_with(
      input.configuration.rules.area_fouls_per_halt);
}

bool fouls_decide_penalty(const RefereeState& state, const RefereeInput& input) {
  return input.configuration.rules.penalty_fouls_decide && state.play.is_penalty();
}

bool fouls_decide_kick(const RefereeState& state, const RefereeInput& input) {
  return fouls_decide_penalty(state, input) || is_in_shootout(state, input);
}

bool fouls_are_noted(const RefereeState& state, const RefereeInput& input) {
  return !fouls_stop_play(state, input);
}

Stage stage_before(int half) { return kBefore[static_cast<std::size_t>(half)]; }
Stage stage_of(int half) { return kRunning[static_cast<std::size_t>(half)]; }
Stage break_before(int half) { return kBreaks[static_cast<std::size_t>(half) - 1]; }

std::optional<int> half_in(Stage stage) {
  for (int half = 0; half < kMaxHalves; ++half) {
    const bool follows = half > 0 && break_before(half) == stage;
    if (stage == stage_before(half) || stage == stage_of(half) || follows) return half;
  }
  return std::nullopt;
}

bool is_running(Stage stage) { return contains(kRunning, stage); }
bool is_before_half(Stage stage) { return contains(kBefore, stage); }
bool is_break(Stage stage) { return contains(kBreaks, stage); }

Side kickoff_side(const Configuration& configuration, int half) {
  const Side first = configuration.first_kickoff;
  return half % 2 == 0 ? first : opponent_of(first);
}

int half_after(const Configuration& configuration, int half) {
  return half + 1 == configuration.halves ? kFirstExtraHalf : half + 1;
}

bool is_extra(const Configuration& configuration, int half) {
  return configuration.knockout && half >= kFirstExtraHalf;
}

TimeoutAllowance timeout_allowance(const RefereeState& state, const Configuration& configuration) {
  const RuleBook& rules = configuration.rules;
  if (is_extra(configuration, state.half)) return {rules.extra_timeouts, rules.extra_timeouts_s};
  return {rules.timeouts, rules.timeouts_s};
}

double clock_s(const RefereeState& state, const RuleBook& rules, double now_s) {
  // The game clock counts either actual play only, or all time except timeouts.
  if (rules.clock_stops) return state.play_clock.at_s(now_s);
  return now_s - state.timeout_clock.at_s(now_s);
}

std::optional<HalfClock> half_clock(const RefereeState& state, const Configuration& configuration,
                                    double now_s) {
  if (!is_running(state.signal.stage)) return std::nullopt;
  const double played_s = clock_s(state, configuration.rules, now_s) - state.half_began_s;
  return HalfClock{played_s, std::max(0.0, length_s(configuration, state.half) - played_s)};
}

double time_left_s(const RefereeState& state, const Configuration& configuration, double now_s) {
  const std::optional<HalfClock> clock = half_clock(state, configuration, now_s);
  return clock ? clock->left_s : 0;
}

std::optional<Finding> find_time_over(const RefereeState& state, const RefereeInput& input) {
  const Configuration& configuration = input.configuration;
  if (!is_running(state.signal.stage)) return std::nullopt;
  const double now_s = clock_s(state, configuration.rules, input.time_s());
  const double limit_s = length_s(configuration, state.half);
  if (!has_passed(state.half_began_s, limit_s, now_s)) return std::nullopt;
  if (configuration.rules.penalty_prolongs_half &&
      (is_penalty_pending(state, input) || is_goal_being_signalled(state, input))) {
    return std::nullopt;
  }
  Finding finding;
  finding.event = end_of(state, configuration);
  finding.rule = "paper 4.2, time-related rules";
  finding.value = now_s - state.half_began_s;
  finding.threshold = limit_s;
  finding.unit = "s";
  finding.evidence =
      fmt::format("{} has lasted {:.3f} s.", text_of_half(state, configuration), finding.value);
  return finding;
}

std::optional<Command> pending_restart(const RefereeState& state) {
  const std::optional<Command>& next = state.signal.next_command;
  return next && next->kind == CommandKind::kNormalStart ? state.prepared : next;
}

bool needs_preparation(const std::optional<Command>& restart) {
  return restart && (restart->kind == CommandKind::kPrepareKickoff ||
                     restart->kind == CommandKind::kPreparePenalty);
}

bool wins_at_once(const RuleBook& rules, const PerSide<int>& goals) {
  const auto [less, more] = std::minmax(goals[Side::kWest], goals[Side::kEast]);
  return rules.goals_to_win > 0 && more >= rules.goals_to_win && more - less > rules.goal_lead;
}

}  // namespace autoref::referee
