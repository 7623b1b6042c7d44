#include "logs/recorded_game_events.hpp"

#include <algorithm>
#include <utility>

#include "game/loop/game_event.hpp"
#include "league/game_event_message.hpp"

namespace autoref::logs {
namespace {

// Equal for the same event in different packets.
std::string key_of(GameEvent event) {
  if (!event.id.empty()) return event.id;
  event.origin.clear();  // grows when another automatic referee reports the event
  return game::game_event_json(event);
}

bool is_identified(const GameEvent& event) { return !event.id.empty() || event.created_us; }

}  // namespace

void RecordedGameEvents::take(double time_s, const league::RefereePacket& packet) {
  const auto& now = packet.game_events();
  if (!std::equal(now.begin(), now.end(), current_.begin(), current_.end())) {
    current_.assign(now.begin(), now.end());
    take_new(time_s, packet);
  }
  is_first_ = false;
}

void RecordedGameEvents::take_new(double time_s, const league::RefereePacket& packet) {
  std::set<std::string> shown;
  for (GameEvent& event : league::game_events_of(packet)) {
    std::string key = key_of(event);
    bool is_new = !shown_.contains(key) && !is_first_;
    if (is_identified(event) && known_.size() < 2 * kMostEvents)
      is_new = known_.insert(key).second && is_new;
    shown.insert(std::move(key));
    if (is_new && events_.size() < kMostEvents) events_.push_back({time_s, std::move(event)});
  }
  shown_ = std::move(shown);
}

}  // namespace autoref::logs
