#include "referee/machine/guards.hpp"

#include "referee/machine/timekeeping.hpp"

namespace autoref::referee {

bool holds_always(const RefereeState& /*state*/, const Configuration& /*configuration*/) {
  return true;
}

bool next_is_preparation(const RefereeState& state, const Configuration& /*configuration*/) {
  const std::optional<Command>& next = state.signal.next_command;
  return next &&
         (next->kind == CommandKind::kPrepareKickoff || next->kind == CommandKind::kPreparePenalty);
}

bool next_starts_play(const RefereeState& state, const Configuration& configuration) {
  return state.signal.next_command && !next_is_preparation(state, configuration);
}

bool is_during_game(const RefereeState& state, const Configuration& configuration) {
  return !is_between_halves(state, configuration) && !is_after_game(state, configuration);
}

bool is_between_halves(const RefereeState& state, const Configuration& /*configuration*/) {
  return is_break(state.signal.stage);
}

bool is_after_game(const RefereeState& state, const Configuration& /*configuration*/) {
  return state.signal.stage == Stage::kPostGame;
}

bool is_before_shootout(const RefereeState& state, const Configuration& /*configuration*/) {
  return state.signal.stage == Stage::kShootoutBreak;
}

bool is_in_shootout(const RefereeState& state, const Configuration& /*configuration*/) {
  return state.signal.stage == Stage::kShootout;
}

bool game_was_last(const RefereeState& /*state*/, const Configuration& configuration) {
  return configuration.after_game == AfterGame::kHalt;
}

bool new_game_follows(const RefereeState& /*state*/, const Configuration& configuration) {
  return configuration.after_game == AfterGame::kNewGame;
}

bool fouls_stop_play(const RefereeState& /*state*/, const Configuration& configuration) {
  return configuration.rules.fouls_stop_play;
}

bool is_second_near_area(const RefereeState& state, const Configuration& /*configuration*/) {
  return state.watch.attacker_too_close_to_defense_area.is_second();
}

bool fouls_decide_penalty(const RefereeState& state, const Configuration& configuration) {
  return configuration.rules.penalty_fouls_decide && state.play.is_penalty();
}

bool fouls_decide_kick(const RefereeState& state, const Configuration& configuration) {
  return fouls_decide_penalty(state, configuration) || is_in_shootout(state, configuration);
}

bool fouls_are_noted(const RefereeState& state, const Configuration& configuration) {
  return !fouls_stop_play(state, configuration);
}

}  // namespace autoref::referee
