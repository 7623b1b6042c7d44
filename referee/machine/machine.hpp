// The paper's finite state machine (section 4.3, figure 3) as a table, one row per transition.
//
// The machine owns no data. A step is a pure function that returns the new state: the result
// depends only on the state, the frame and the finding. The referee calls step() once per finding.
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

// For a call of this event while the ball is in play: whether it always stops play, whether it
// stops play if fouls do so under the rule book, and whether it only counts.
bool stops_play(Event event);
bool stops_play_by_book(Event event);
bool counts_in_play(Event event);
// Whether the event is a foul that can decide a penalty kick.
bool may_decide_penalty(Event event);

// The trigger of a transition: one event, or every event of a kind (event.hpp).
struct Trigger {
  constexpr Trigger(Event of) : event(of) {}  // implicit, so that a row can name its event
  constexpr Trigger(std::string_view its_text, bool (*of_kind)(Event))
      : text(its_text), includes(of_kind) {}

  bool has(Event found) const { return event ? *event == found : includes(found); }

  std::optional<Event> event{};
  std::string_view text{};  // wording for this kind of event
  bool (*includes)(Event) = nullptr;
};

inline constexpr Trigger kCallThatStopsPlay{"a call that stops play", stops_play};
inline constexpr Trigger kCallByBook{"a call that stops play by the book", stops_play_by_book};
inline constexpr Trigger kCallThatCounts{"a call that only counts", counts_in_play};
inline constexpr Trigger kFoulInPlay{"a foul in play", may_decide_penalty};
inline constexpr Trigger kCallInStop{"a call that may be made in a stop", may_come_in_stop};

struct Transition {
  std::string_view label;     // if empty, the event's name
  std::optional<State> from;  // nullopt: any state
  Trigger trigger;
  Guard guard;
  Action action;
  std::optional<State> to;      // nullopt: the state does not change
  std::string_view evidence;    // the row's source: a section of the paper or another document
  std::string_view deviations;  // "D3, D13" (README.md); empty if the row follows the paper
};

// The transitions in the figure.
std::span<const Transition> transitions_in_figure();
// The transitions of game time, which "operates outside this diagram".
std::span<const Transition> transitions_outside_figure();

// Transitions for calls that the paper's referee lacks. These transitions differ only in the event
// that triggers them.
std::span<const Transition> transitions_beyond_paper();

// Transitions for cards, timeouts and knockout games (administration.cpp). They are tried first,
// because a goal in a shoot-out has its own transition.
std::span<const Transition> transitions_of_administration();

// Transitions for ball placement by the teams (ball_placement.cpp). They are tried before those of
// the figure, since play must not start before the ball is placed.
std::span<const Transition> transitions_of_placement();

// All transitions while AutoRef commands the game, in the order in which they are tried.
std::array<std::span<const Transition>, 6> all_transitions();

// Every label that a step can have, in the order of all_transitions().
std::vector<std::string_view> all_labels();

struct Step {
  RefereeState state;                      // unchanged if no transition applies
  const Transition* transition = nullptr;  // null if none applies
  std::string_view label;       // the transition's label, or the event's name if it has none
  std::optional<Command> sent;  // the command sent, if any
};

// Takes the first transition from the current state that the finding triggers, either from
// all_transitions() or from the given tables.
Step step(const RefereeState& state, const RefereeInput& input, const Finding& finding);
Step step(std::span<const std::span<const Transition>> tables, const RefereeState& state,
          const RefereeInput& input, const Finding& finding);

// Transitions of games that begin in the middle of a half (referee/state.hpp). They are tried
// before all others; if the game has no MidwayStart, none of them applies.
std::span<const Transition> transitions_midway();

}  // namespace autoref::referee
