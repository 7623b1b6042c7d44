// Plays games and judges their referee by ground truth.
#pragma once

#include "experiments/results/call_evaluation.hpp"
#include "game/loop/game.hpp"

namespace autoref::judge {

struct JudgedGame {
  game::GameRecord record;
  experiments::CallEvaluation evaluation;
};

// Plays a game and compares its referee's calls with the true events. `observers` watch it, too.
// Throws as play() does.
JudgedGame evaluate_calls(const game::GameConfiguration& configuration,
                          const game::TeamMaker& make_team = game::make_registered_team,
                          game::Observers observers = {});

}  // namespace autoref::judge
