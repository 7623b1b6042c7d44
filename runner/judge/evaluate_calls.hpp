// Plays games and judges their referee by ground truth.
#pragma once

#include "runner/game/game.hpp"
#include "runner/results/call_evaluation.hpp"

namespace autoref::runner {

struct JudgedGame {
  GameRecord record;
  CallEvaluation evaluation;
};

// Plays a game and compares its referee's calls with the true events. `observers` watch it, too.
// Throws as play() does.
JudgedGame evaluate_calls(const GameConfiguration& configuration,
                          const TeamMaker& make_team = make_registered_team,
                          Observers observers = {});

}  // namespace autoref::runner
