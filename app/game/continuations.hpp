// `autoref play --from LOG@SECONDS --games N`: what follows one point of a recorded game.
#pragma once

#include <optional>
#include <string>

#include "app/game/log_start.hpp"
#include "game/loop/game_configuration.hpp"
#include "io/json.hpp"

namespace autoref::app {

struct ManyGames {
  int games = 0;    // 0: one game, played by play_one()
  int workers = 0;  // 0: one per processor
  bool json = false;
};

inline constexpr int kMostContinuations = 100'000;

// Plays the game with consecutive seeds from its own on, and prints how often each outcome
// occurred. Returns the exit code. Throws Interrupted after Ctrl-C.
int play_continuations(const game::GameConfiguration& game, const ManyGames& many,
                       const LogInstant& instant, const std::optional<RecordedSequel>& sequel);

// "in the log, play ended after 2.13 s with a goal by yellow".
std::string text_of(const RecordedSequel& sequel);
// {"lasts_s": 2.133, "scorer": "yellow"}; the scorer is null if no goal ended the play.
io::Json json_of(const RecordedSequel& sequel);

}  // namespace autoref::app
