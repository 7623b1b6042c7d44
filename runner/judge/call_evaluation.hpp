// What a referee got right and wrong in one game.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runner/game/game.hpp"
#include "runner/judge/truth/association.hpp"

namespace autoref::runner {

// Who touched the ball last, at the calls that need it.
struct LastTouchTally {
  int right = 0;
  int wrong = 0;
  int unknown = 0;
};

struct CallEvaluation {
  std::vector<ground_truth::Verdict> verdicts;
  std::array<LastTouchTally, 2> last_touch;  // by the team that truly touched it: a, b
  std::vector<std::string> calls_in_stop;    // "goal at 12.350 s": calls that need play
  std::vector<std::string> transitions;      // that the referee's machine took
  std::string void_reason;                   // empty unless the game is void
  std::uint64_t state_hash = 0;              // of the game; not in its text
};

// Plays a game and judges its referee. Throws as play() does.
CallEvaluation evaluate_calls(const GameConfiguration& configuration,
                              const TeamMaker& make_team = make_registered_team);

// The judgement as text, and back. Throws std::invalid_argument for other texts.
std::string text_of(const CallEvaluation& evaluation);
CallEvaluation evaluation_in(std::string_view text);

}  // namespace autoref::runner
