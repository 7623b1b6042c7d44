// The events on the field or on the clock that the referee acts on.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "soccer/named.hpp"
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

constexpr auto names_of(Card /*any*/) {
  return std::to_array<Named<Card>>(
      {{Card::kNone, "none"}, {Card::kYellow, "yellow"}, {Card::kRed, "red"}});
}

using autoref::name_of;

// The effect of a call that is made while the ball is in play.
enum class Effect : std::uint8_t {
  kNone,         // not a call
  kStopsPlay,    // a restart follows
  kStopsByBook,  // stops play if fouls stop play under the rule book; otherwise only counted
  kCounts,       // play continues
};

// When a call may be made. A call made while play is stopped is only counted.
enum class When : std::uint8_t { kInPlay, kInStop, kAnyTime };

// The fixed properties of an event.
struct EventEntry {
  Event event = Event::kBegin;
  std::string_view name{};          // snake_case, as in event logs and column names: "throw_in"
  std::string_view about{};         // what happened, as a sentence
  std::string_view league_event{};  // the league's GameEvent.Type; empty if it has none
  Effect effect = Effect::kNone;
  When when = When::kInPlay;     // used only if the event is a call
  bool is_foul = false;          // counted among the team's fouls in the game's row
  bool counts_to_card = false;   // 2026: every third such foul brings a yellow card
  bool is_non_stopping = false;  // 2026: the team's goals in the next 2 s do not count
  bool is_exit = false;          // the ball left the field; the last touch decides the restart
  Card card = Card::kNone;       // the card that the event always brings
  std::optional<CommandKind> restart{};  // the restart that always follows
};

// The entries for all events, ordered by event number.
std::span<const EventEntry> event_table();
const EventEntry& entry_of(Event event);

std::string_view name_of(Event event);

// Whether the event is a call. A game's row in the results counts the calls.
bool is_call(Event event);

// Whether a call of this event may be made while play is stopped.
bool may_come_in_stop(Event event);

}  // namespace autoref::referee
