// The guards of the machine's transitions (referee/machine/machine.hpp).
#pragma once

#include <string_view>

#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

// A condition and its wording in the figure; the wording is empty if the condition always holds.
struct Guard {
  std::string_view text;
  bool (*holds)(const RefereeState& state, const RefereeInput& input);
};

bool holds_always(const RefereeState& state, const RefereeInput& input);
bool next_is_preparation(const RefereeState& state, const RefereeInput& input);
bool next_starts_play(const RefereeState& state, const RefereeInput& input);
bool is_during_game(const RefereeState& state, const RefereeInput& input);
bool is_between_halves(const RefereeState& state, const RefereeInput& input);
bool is_after_game(const RefereeState& state, const RefereeInput& input);
bool is_before_shootout(const RefereeState& state, const RefereeInput& input);
bool is_in_shootout(const RefereeState& state, const RefereeInput& input);
bool game_was_last(const RefereeState& state, const RefereeInput& input);
bool new_game_follows(const RefereeState& state, const RefereeInput& input);
bool fouls_stop_play(const RefereeState& state, const RefereeInput& input);
bool is_second_near_area(const RefereeState& state, const RefereeInput& input);
bool fouls_decide_penalty(const RefereeState& state, const RefereeInput& input);
bool fouls_decide_kick(const RefereeState& state, const RefereeInput& input);
bool fouls_are_noted(const RefereeState& state, const RefereeInput& input);

inline constexpr Guard kAlways{"", holds_always};
inline constexpr Guard kNextIsPreparation{"next is a preparation", next_is_preparation};
inline constexpr Guard kNextStartsPlay{"next is not a preparation", next_starts_play};
inline constexpr Guard kDuringGame{"during a half", is_during_game};
inline constexpr Guard kBetweenHalves{"between halves", is_between_halves};
inline constexpr Guard kAfterGame{"after the game", is_after_game};
inline constexpr Guard kBeforeShootout{"in the break before the shoot-out", is_before_shootout};
inline constexpr Guard kInShootout{"in the shoot-out", is_in_shootout};
inline constexpr Guard kGameWasLast{"no new game follows", game_was_last};
inline constexpr Guard kNewGameFollows{"a new game follows", new_game_follows};
inline constexpr Guard kFoulsStopPlay{"fouls stop play", fouls_stop_play};
inline constexpr Guard kSecondNearArea{"the team's second in this stop or free kick",
                                       is_second_near_area};
inline constexpr Guard kFoulsDecidePenalty{"fouls decide the penalty kick", fouls_decide_penalty};
inline constexpr Guard kFoulsDecideKick{"fouls decide the penalty kick, or in a shoot-out",
                                        fouls_decide_kick};
inline constexpr Guard kFoulsAreNoted{"fouls only count", fouls_are_noted};

}  // namespace autoref::referee
