// Game time, "which operates outside this diagram" (paper, section 4.3).
//
// A half's clock starts with the ready command (NORMAL_START) at its beginning and runs on until
// the half is over (paper, section 4.2, "Time-Related Rules").
#pragma once

#include <optional>

#include "referee/finding.hpp"
#include "referee/memory.hpp"
#include "referee/moment.hpp"

namespace autoref::referee {

// Stages of half `half`, counted from 0: before its kick-off, while it runs, and the break after
// it.
Stage stage_before(int half);
Stage stage_of(int half);
Stage break_after(int half);

// Whether a half's clock is running in this stage.
bool is_running(Stage stage);
// Whether the stage waits for a half's first kick-off.
bool is_before_half(Stage stage);
// Whether the stage is one between two halves.
bool is_break(Stage stage);

// Who kicks off in half `half`: the configured side in the first, the other one in the next, and
// so on in turns.
Side kickoff_side(const Configuration& configuration, int half);

// What is left of the running half, in seconds; 0 in other stages and never below.
double time_left_s(const Memory& memory, const Configuration& configuration, double now_s);

// kHalfOver or kGameOver once the running half's time is over.
std::optional<Finding> find_time_over(const Memory& memory, const Moment& moment);

}  // namespace autoref::referee
