// The game events in a log's referee packets, each once.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "game/loop/game_event_log.hpp"
#include "league/messages/referee.pb.h"

namespace autoref::logs {

// A packet repeats its events for as long as the game controller keeps them. Each counts from the
// packet that has it first. Events are the same if their ids are or, without ids, all else but
// their origins. An event without id and time of creation that comes back later is another one.
// Events of the log's first packet happened before and are left out; so are proposals, which the
// game controller has not accepted.
class RecordedGameEvents {
 public:
  static constexpr std::size_t kMostEvents = 10'000;

  void take(double time_s, const league::RefereePacket& packet);

  // In order of time, at most kMostEvents.
  const std::vector<game::TimedGameEvent>& events() const { return events_; }

 private:
  void take_new(double time_s, const league::RefereePacket& packet);

  bool is_first_ = true;
  std::vector<std::string> current_;  // the last packet's events as bytes
  std::set<std::string> shown_;       // keys of the last packet's events
  std::set<std::string> known_;       // keys of all events that have an id or a time of creation
  std::vector<game::TimedGameEvent> events_;
};

}  // namespace autoref::logs
