#include "game/loop/game_event_log.hpp"

#include <optional>
#include <utility>

#include "game/loop/game_event.hpp"

namespace autoref::game {

void GameEventLog::on_decision(const referee::Decision& decision) {
  std::optional<GameEvent> event = game_event_of(decision, start_unix_s_);
  if (event) events_.push_back({decision.time_s, *std::move(event)});
}

std::string game_event_lines(const std::vector<TimedGameEvent>& events) {
  std::string lines;
  for (const TimedGameEvent& timed : events) lines += game_event_json(timed.event) + "\n";
  return lines;
}

}  // namespace autoref::game
