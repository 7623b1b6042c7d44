#include "app/experiment/started_games.hpp"

#include <exception>

#include "app/game/page_recorder.hpp"
#include "game/loop/game.hpp"
#include "game/team_programs/program_games.hpp"

namespace autoref::app {

bool StartedGames::add(const experiments::ScheduledGame& game) {
  if (game::has_programs(experiments::resolved(game))) return false;
  const std::lock_guard lock(mutex_);
  games_.insert_or_assign(game.id, game);
  return true;
}

void StartedGames::forget(const std::string& id) {
  const std::lock_guard lock(mutex_);
  games_.erase(id);
}

std::optional<experiments::ScheduledGame> StartedGames::game_named(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto game = games_.find(id);
  return game == games_.end() ? std::nullopt : std::optional(game->second);
}

std::optional<std::string> StartedGames::page(const std::string& id) const {
  const std::optional<experiments::ScheduledGame> game = game_named(id);
  if (!game) return std::nullopt;
  try {
    const game::GameConfiguration configuration = experiments::resolved(*game);
    PageRecorder recorder;
    const game::GameRecord record = game::play(configuration, &recorder);
    return recorder.page(configuration, record);
  } catch (const std::exception&) {
    return std::nullopt;  // the run tells why: its game is void for the same reason
  }
}

}  // namespace autoref::app
