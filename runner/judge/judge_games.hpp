// Plays and judges many games, in worker processes.
#pragma once

#include <cstdio>
#include <vector>

#include "runner/experiments/judge_schedule.hpp"
#include "runner/judge/call_evaluation.hpp"

namespace autoref::runner {

// The judgements in the games' order; a game whose worker failed is void. `progress` may be null.
// Throws Interrupted where the user ended it.
std::vector<CallEvaluation> judge_games(const std::vector<JudgeGame>& games, int workers,
                                        std::FILE* progress);

}  // namespace autoref::runner
