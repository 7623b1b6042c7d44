// What happened on the field or on the clock that made the referee act.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "soccer/referee_signal.hpp"

namespace autoref::referee {

enum class Event : std::uint8_t {
#define AUTOREF_EVENT(id, number, ...) id = (number),
#include "referee/events.def"
#undef AUTOREF_EVENT
};

#define AUTOREF_EVENT(...) +1  // NOLINT(bugprone-macro-parentheses): a sum
inline constexpr int kEventCount = 0
#include "referee/events.def"
    ;
#undef AUTOREF_EVENT

enum class Card : std::uint8_t { kNone, kYellow, kRed };
std::string_view name_of(Card card);

// What a call does to play that is on.
enum class Effect : std::uint8_t {
  kNone,         // not a call on play or on robots
  kStopsPlay,    // and a restart follows
  kStopsByBook,  // the same where fouls stop play in the rule book; else it only counts
  kCounts,       // play goes on
};

// When a call may come. Once play is stopped, every call only counts.
enum class When : std::uint8_t { kInPlay, kInStop, kAnyTime };

// What is the same whenever the event occurs.
struct EventEntry {
  Event event = Event::kBegin;
  std::string_view name{};          // in snake_case, as in event logs and column heads: "throw_in"
  std::string_view league_event{};  // the league's GameEvent.Type; empty where it has none
  Effect effect = Effect::kNone;
  When when = When::kInPlay;             // of calls
  bool is_foul = false;                  // among a team's fouls in a game's row
  bool counts_to_card = false;           // 2026: every third one is a yellow card
  bool is_non_stopping = false;          // 2026: no goal by the team for 2 s
  bool is_exit = false;                  // the ball left the field: who touched it last decides
  Card card = Card::kNone;               // shown whatever the circumstances
  std::optional<CommandKind> restart{};  // that follows whatever the circumstances
};

// In the order of their numbers.
std::span<const EventEntry> event_table();
const EventEntry& entry_of(Event event);

std::string_view name_of(Event event);

// Whether the event is a call on play or on robots; these are the kinds that a game's row counts.
bool is_call(Event event);

// Whether the call may come while play is stopped.
bool may_come_in_stop(Event event);

}  // namespace autoref::referee
