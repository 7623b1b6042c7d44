#include "runner/cli/started_games.hpp"

#include <exception>

#include "runner/cli/page_recorder.hpp"
#include "runner/game/game.hpp"
#include "runner/team_programs/program_games.hpp"

namespace autoref::runner {

bool StartedGames::add(const ScheduledGame& game) {
  if (has_programs(resolved(game))) return false;
  const std::lock_guard lock(mutex_);
  games_.insert_or_assign(game.id, game);
  return true;
}

void StartedGames::forget(const std::string& id) {
  const std::lock_guard lock(mutex_);
  games_.erase(id);
}

std::optional<ScheduledGame> StartedGames::game_named(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto game = games_.find(id);
  return game == games_.end() ? std::nullopt : std::optional(game->second);
}

std::optional<std::string> StartedGames::page(const std::string& id) const {
  const std::optional<ScheduledGame> game = game_named(id);
  if (!game) return std::nullopt;
  try {
    const GameConfiguration configuration = resolved(*game);
    PageRecorder recorder;
    const GameRecord record = play(configuration, &recorder);
    return recorder.page(configuration, record);
  } catch (const std::exception&) {
    return std::nullopt;  // the run tells why: its game is void for the same reason
  }
}

}  // namespace autoref::runner
