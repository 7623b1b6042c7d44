// Game time, "which operates outside this diagram" (paper, section 4.3).
//
// A half's clock starts with the ready command (NORMAL_START) and runs until the half is over
// (paper, section 4.2, "Time-Related Rules"), except during timeouts. If the rule book says so
// (2026), it stops whenever play is stopped. "Additional time is allowed for a penalty kick to be
// taken at the end of each half" (Laws 7 and 14; 2026, Penalty Kick): a half is not over until a
// penalty kick awarded in it is.
#pragma once

#include <optional>

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

// The first half of extra time. It follows the game's second half, even if the game has only one.
inline constexpr int kFirstExtraHalf = 2;

// Stages of half `half`, counted from 0: before its kick-off, while it runs, and the break before
// it (from the second half on).
Stage stage_before(int half);
Stage stage_of(int half);
Stage break_before(int half);

// Whether a half's clock is running in this stage.
bool is_running(Stage stage);
// Whether the stage precedes a half's kick-off.
bool is_before_half(Stage stage);
// Whether the stage is a break between two halves.
bool is_break(Stage stage);

// The side that kicks off half `half`: the configured side in the first half, then alternating.
Side kickoff_side(const Configuration& configuration, int half);

// The half after `half`, which must not be the last one.
int half_after(const Configuration& configuration, int half);

// Whether `half` belongs to the extra time of a knockout game.
bool is_extra(const Configuration& configuration, int half);

// The game clock in seconds, from an arbitrary origin.
double clock_s(const RefereeState& state, const RuleBook& rules, double now_s);

// The running half's clock; nullopt in other stages.
std::optional<HalfClock> half_clock(const RefereeState& state, const Configuration& configuration,
                                    double now_s);

// Time left in the running half, in seconds; at least 0, and 0 in other stages.
double time_left_s(const RefereeState& state, const Configuration& configuration, double now_s);

// When the running half's time is up and no penalty kick is left to be taken: kHalfOver, or
// kGameOver after the last half. If a knockout game is drawn then, kExtraTime, and kShootout after
// extra time.
std::optional<Finding> find_time_over(const RefereeState& state, const RefereeInput& input);

}  // namespace autoref::referee
