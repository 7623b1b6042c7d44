#include "referee/machine/guards.hpp"

#include "referee/machine/timekeeping.hpp"

namespace autoref::referee {

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

bool is_second_near_area(const RefereeState& state, const RefereeInput& /*input*/) {
  return state.watch.attacker_too_close_to_defense_area.is_second();
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

}  // namespace autoref::referee
