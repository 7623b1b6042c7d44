// Compares the game events of a recorded referee with AutoRef's, one by one.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "game/loop/event_log.hpp"
#include "io/json.hpp"
#include "referee/referee_configuration.hpp"
#include "soccer/rules/game_event.hpp"

namespace autoref::logs {

// Whether any of AutoRef's decisions become events of this type (referee/events.def). When AutoRef
// assists a human referee, it neither judges placements nor shows cards.
bool is_judged(GameEventType type, referee::Control control);

// A recorded event and the matching event of AutoRef. If one of them has no match, the other is
// missing.
struct GameEventPair {
  std::optional<game::TimedGameEvent> recorded;
  std::optional<game::TimedGameEvent> refereed;
  bool is_matched() const { return recorded && refereed; }
};

struct GameEventCounts {
  int recorded = 0;
  int refereed = 0;
  int matched = 0;
};

struct GameEventComparison {
  std::vector<GameEventPair> pairs;  // in order of time; only event types that AutoRef judges
  std::map<GameEventType, GameEventCounts> types;
  GameEventCounts all;
  std::map<GameEventType, int> not_judged;  // number of recorded events of each other type
};

// Matches events of the same type and team that are at most `tolerance_s` apart. Both lists must be
// in order of time; each recorded event is matched with the first event that fits. `control` is
// AutoRef's control mode.
GameEventComparison compared(std::span<const game::TimedGameEvent> recorded,
                             std::span<const game::TimedGameEvent> refereed,
                             referee::Control control, double tolerance_s = 2.0);

// A table with a row per event type; empty if no events were recorded. `other` is the title of the
// recorded events.
std::string game_events_text(const GameEventComparison& comparison,
                             std::string_view other = "recorded");

// The comparison as a JSON object; null if no events were recorded.
io::Json game_events_json(const GameEventComparison& comparison);

}  // namespace autoref::logs
