// Collects the league's events for a referee's decisions.
#pragma once

#include <string>
#include <vector>

#include "referee/decision.hpp"
#include "soccer/game_event.hpp"

namespace autoref::game {

struct TimedGameEvent {
  double time_s = 0;  // since the start of the game or log
  GameEvent event;
};

class GameEventLog {
 public:
  // `start_unix_s` is the Unix time of the game's time 0.
  explicit GameEventLog(double start_unix_s = 0) : start_unix_s_(start_unix_s) {}

  void on_decision(const referee::Decision& decision);

  // Decisions for which the league has no event are left out.
  const std::vector<TimedGameEvent>& events() const { return events_; }

 private:
  double start_unix_s_ = 0;
  std::vector<TimedGameEvent> events_;
};

// The events as JSON (game_event.hpp), one per line.
std::string game_event_lines(const std::vector<TimedGameEvent>& events);

}  // namespace autoref::game
