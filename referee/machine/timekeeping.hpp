// Game time, "which operates outside this diagram" (paper, section 4.3).
//
// A half's clock starts with the ready command (NORMAL_START) at its beginning and runs on until
// the half is over (paper, section 4.2, "Time-Related Rules"), but for timeouts. Where the book
// says so (2026), it stands whenever play is stopped.
#pragma once

#include <optional>

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

// The first half of extra time; its halves follow the game's two, even where a game has one.
inline constexpr int kFirstExtraHalf = 2;

// Stages of half `half`, counted from 0: before its kick-off, while it runs, and the break before
// it, from the second one on.
Stage stage_before(int half);
Stage stage_of(int half);
Stage break_before(int half);

// Whether a half's clock is running in this stage.
bool is_running(Stage stage);
// Whether the stage waits for a half's first kick-off.
bool is_before_half(Stage stage);
// Whether the stage is one between two halves.
bool is_break(Stage stage);

// Who kicks off in half `half`: the configured side in the first, the other one in the next, and
// so on in turns.
Side kickoff_side(const Configuration& configuration, int half);

// The half that follows `half`, which is not the last one.
int half_after(const Configuration& configuration, int half);

// Whether `half` belongs to the extra time of a knockout game.
bool is_extra(const Configuration& configuration, int half);

// What the game's clock shows, in seconds from anywhere.
double clock_s(const RefereeState& state, const RuleBook& rules, double now_s);

// The running half's clock; none in other stages.
std::optional<HalfClock> half_clock(const RefereeState& state, const Configuration& configuration,
                                    double now_s);

// What is left of the running half, in seconds; 0 in other stages and never below.
double time_left_s(const RefereeState& state, const Configuration& configuration, double now_s);

// Once the running half's time is over: kHalfOver, or after the last one kGameOver; where a
// knockout game is drawn then, kExtraTime, and after extra time kShootout.
std::optional<Finding> find_time_over(const RefereeState& state, const RefereeInput& input);

}  // namespace autoref::referee
