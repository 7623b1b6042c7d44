#include "referee/machine/guards.hpp"

#include "referee/machine/timekeeping.hpp"

namespace autoref::referee {

bool holds_always(const Memory& /*memory*/, const Configuration& /*configuration*/) { return true; }

bool next_is_preparation(const Memory& memory, const Configuration& /*configuration*/) {
  const std::optional<Command>& next = memory.signal.next_command;
  return next &&
         (next->kind == CommandKind::kPrepareKickoff || next->kind == CommandKind::kPreparePenalty);
}

bool next_starts_play(const Memory& memory, const Configuration& configuration) {
  return memory.signal.next_command && !next_is_preparation(memory, configuration);
}

bool is_during_game(const Memory& memory, const Configuration& configuration) {
  return !is_between_halves(memory, configuration) && !is_after_game(memory, configuration);
}

bool is_between_halves(const Memory& memory, const Configuration& /*configuration*/) {
  return is_break(memory.signal.stage);
}

bool is_after_game(const Memory& memory, const Configuration& /*configuration*/) {
  return memory.signal.stage == Stage::kPostGame;
}

bool is_before_shootout(const Memory& memory, const Configuration& /*configuration*/) {
  return memory.signal.stage == Stage::kShootoutBreak;
}

bool is_in_shootout(const Memory& memory, const Configuration& /*configuration*/) {
  return memory.signal.stage == Stage::kShootout;
}

bool game_was_last(const Memory& /*memory*/, const Configuration& configuration) {
  return configuration.after_game == AfterGame::kHalt;
}

bool new_game_follows(const Memory& /*memory*/, const Configuration& configuration) {
  return configuration.after_game == AfterGame::kNewGame;
}

bool fouls_stop_play(const Memory& /*memory*/, const Configuration& configuration) {
  return configuration.rules.fouls_stop_play;
}

bool fouls_are_noted(const Memory& memory, const Configuration& configuration) {
  return !fouls_stop_play(memory, configuration);
}

}  // namespace autoref::referee
