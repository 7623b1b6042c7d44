// The guards of the machine's transitions (referee/machine/machine.hpp), and game time.
#pragma once

#include <optional>
#include <string_view>

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

// A condition and its wording in the figure; the wording is empty if the guard always holds.
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
bool has_fouls_for_halt(const RefereeState& state, const RefereeInput& input);
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
                                       has_fouls_for_halt};
inline constexpr Guard kFoulsDecidePenalty{"fouls decide the penalty kick", fouls_decide_penalty};
inline constexpr Guard kFoulsDecideKick{"fouls decide the penalty kick, or in a shoot-out",
                                        fouls_decide_kick};
inline constexpr Guard kFoulsAreNoted{"fouls only count", fouls_are_noted};

// Game time, "which operates outside this diagram" (paper, section 4.3).
//
// A half's clock starts with the ready command (NORMAL_START) and runs until the half is over
// (paper, section 4.2, "Time-Related Rules"), except during timeouts. If the rule book says so
// (2026), it stops whenever play is stopped. "Additional time is allowed for a penalty kick to be
// taken at the end of each half" (Laws 7 and 14; 2026, Penalty Kick). So a half does not end before
// a penalty kick awarded in it has been completed.

// The first half of extra time. It follows the game's second half, even if the game has only one.
inline constexpr int kFirstExtraHalf = 2;

// The stages of half `half`, counted from 0: before its kick-off, during it, and in the break
// before it (from the second half on).
Stage stage_before(int half);
Stage stage_of(int half);
Stage break_before(int half);

// The half, counted from 0, to which the stage belongs, or that follows this break; nullopt for
// shoot-outs and after the game.
std::optional<int> half_in(Stage stage);

// Whether a half's clock is running in this stage.
bool is_running(Stage stage);
// Whether the stage precedes a half's kick-off.
bool is_before_half(Stage stage);
// Whether the stage is a break between two halves.
bool is_break(Stage stage);

// The side that kicks off half `half`: the configured side kicks off the first half, and the sides
// alternate after that.
Side kickoff_side(const Configuration& configuration, int half);

// The half after `half`, which must not be the last one.
int half_after(const Configuration& configuration, int half);

// Whether `half` belongs to the extra time of a knockout game.
bool is_extra(const Configuration& configuration, int half);

// The timeouts that a team may take, and their total length, in the game or in extra time.
struct TimeoutAllowance {
  int timeouts = 0;
  double time_s = 0;
};
TimeoutAllowance timeout_allowance(const RefereeState& state, const Configuration& configuration);

// The game clock in seconds, from an arbitrary origin.
double clock_s(const RefereeState& state, const RuleBook& rules, double now_s);

// The running half's clock; nullopt in other stages.
std::optional<HalfClock> half_clock(const RefereeState& state, const Configuration& configuration,
                                    double now_s);

// Time left in the running half, in seconds; never negative, and 0 in other stages.
double time_left_s(const RefereeState& state, const Configuration& configuration, double now_s);

// When the running half's time is up and no penalty kick remains to be taken: kHalfOver, or
// kGameOver after the last half. If a knockout game is level at the end: kExtraTime, or kShootout
// after extra time.
std::optional<Finding> find_time_over(const RefereeState& state, const RefereeInput& input);

// The restart that is about to be taken: a PREPARE command also while it is in force and the next
// command is NORMAL_START. nullopt during play.
std::optional<Command> pending_restart(const RefereeState& state);

// Whether the restart is a kick-off or a penalty kick, which need a PREPARE command.
bool needs_preparation(const std::optional<Command>& restart);

// Whether a team with this score wins before the time is over (2026: ten goals and a lead of more
// than one).
bool wins_at_once(const RuleBook& rules, const PerSide<int>& goals);

}  // namespace autoref::referee
