// The paper's finite state machine (section 4.3, figure 3) as a table, one row per transition.
//
// It owns nothing. A step is pure: what follows depends on the memory, the frame and the finding
// alone, and the memory is returned, not changed. The referee calls it once per finding.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "referee/event.hpp"
#include "referee/finding.hpp"
#include "referee/machine/actions.hpp"
#include "referee/machine/guards.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"
#include "referee/state.hpp"

namespace autoref::referee {

// What an transition is taken for: one event, or all of a kind (event.hpp).
struct Trigger {
  constexpr Trigger(Event of) : event(of) {}  // implicit, so that a row names its event
  constexpr Trigger(std::string_view words, bool (*of_kind)(Event))
      : text(words), includes(of_kind) {}

  bool has(Event found) const { return event ? *event == found : includes(found); }

  std::optional<Event> event{};
  std::string_view text{};  // of a kind of events
  bool (*includes)(Event) = nullptr;
};

struct Transition {
  std::string_view label;     // empty: the event's name
  std::optional<State> from;  // none: any state
  Trigger trigger;
  Guard guard;
  Action action;
  std::optional<State> to;      // none: the state stays as it is
  std::string_view evidence;    // what the row rests on: the paper's section, or another source
  std::string_view deviations;  // "D3, D13" in README.md; empty where the row is the paper's
};

// The transitions of the figure, and after them those of the game's time, which "operates outside
// this diagram".
std::span<const Transition> transitions_in_figure();
std::span<const Transition> transitions_outside_figure();

// Those of calls that the paper's referee does not have: they differ in nothing but the event.
std::span<const Transition> transitions_beyond_paper();

// Those of cards, timeouts and knockout games (administration.cpp). They are tried first: what a
// goal leads to in a shoot-out comes before what it leads to elsewhere.
std::span<const Transition> transitions_of_administration();

// All of them, in the order in which they are tried.
std::array<std::span<const Transition>, 4> all_transitions();

// Every label that a step may have, in that order.
std::vector<std::string_view> all_labels();

struct Step {
  RefereeState state;                      // unchanged where no transition leads from here
  const Transition* transition = nullptr;  // taken; none where none leads from here
  std::string_view label;  // of the transition, or the event's name where it has none of its own
  std::optional<Command> sent;  // the command that went out with it
};

// Takes the transition that leads from the present state for what was found.
Step step(const RefereeState& state, const RefereeInput& input, const Finding& finding);

}  // namespace autoref::referee
