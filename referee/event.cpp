#include "referee/event.hpp"

#include <array>

namespace autoref::referee {
namespace {

// An X-macro: events.def also expands into the enumeration, so table and enumeration cannot differ.
constexpr std::array<EventEntry, kEventCount> kTable = {{
#define AUTOREF_EVENT(id, number, ...) {.event = Event::id, __VA_ARGS__},
#include "referee/events.def"
#undef AUTOREF_EVENT
}};

constexpr bool is_in_order() {
  int next = 0;
  for (const EventEntry& entry : kTable) {
    if (static_cast<int>(entry.event) != next++) return false;
  }
  return true;
}
static_assert(is_in_order(), "events.def must list the events by their numbers, without gaps");

}  // namespace

std::span<const EventEntry> event_table() { return kTable; }

const EventEntry& entry_of(Event event) { return kTable[static_cast<std::size_t>(event)]; }

std::string_view name_of(Event event) { return entry_of(event).name; }

bool is_call(Event event) { return entry_of(event).effect != Effect::kNone; }

bool may_come_in_stop(Event event) {
  return is_call(event) && entry_of(event).when != When::kInPlay;
}

}  // namespace autoref::referee
