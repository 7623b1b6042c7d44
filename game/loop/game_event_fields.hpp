// The league's game events for the referee's decisions, and their text as JSON.
#pragma once

#include <optional>
#include <string>

#include "referee/decision.hpp"
#include "soccer/rules/game_event.hpp"

namespace autoref::game {

// The league's event for a decision, filled in from its finding; nullopt if the league has no such
// event. The event's origin is "AutoRef". `start_unix_s` is the Unix time of the game's time 0.
std::optional<GameEvent> game_event_of(const referee::Decision& decision, double start_unix_s = 0);

// The event as one line of JSON with the league's field names, as printed by protobuf's JSON
// mapping with original field names.
std::string game_event_json(const GameEvent& event);

}  // namespace autoref::game
