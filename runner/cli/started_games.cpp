#include "runner/cli/started_games.hpp"

#include <algorithm>
#include <exception>

#include "runner/cli/page_recorder.hpp"
#include "runner/game/game.hpp"
#include "runner/team_programs/program_games.hpp"

namespace autoref::runner {

bool StartedGames::add(const ScheduledGame& game, std::size_t most) {
  if (has_programs(resolved(game))) return false;
  const std::lock_guard lock(mutex_);
  games_.push_back(game);
  if (games_.size() > most) games_.pop_front();
  return true;
}

std::optional<ScheduledGame> StartedGames::game_named(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto game = std::find_if(games_.begin(), games_.end(),
                                 [&id](const ScheduledGame& one) { return one.id == id; });
  return game == games_.end() ? std::nullopt : std::optional(*game);
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
