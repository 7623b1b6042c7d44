// Games that begin with the state of a log: `autoref play --from`.
#pragma once

#include <optional>
#include <string>

#include "game/settings/assignments.hpp"
#include "game/settings/game_settings.hpp"
#include "soccer/side.hpp"

namespace autoref::app {

// A point in a log at which games begin.
struct LogInstant {
  std::string log;
  double at_s = 0;  // time since the start of the log
};

// Parses LOG@SECONDS. Throws InputError naming --from.
LogInstant instant_in(const std::string& from);

// How the recorded play went on after that point.
struct RecordedSequel {
  double lasts_s = 0;          // until play was stopped, or to the end of the log
  std::optional<Side> scorer;  // the side whose goal stopped it, if any
};

struct GameFromLog {
  game::GameSettings game;
  std::optional<RecordedSequel> sequel;  // only with a ghost
};

// The game of the scenario `file`, beginning with the log's state. Without a scenario, the rule
// book is guessed from the log, and the field, the length and the number of halves, and the numbers
// of robots come from the log; settings that the user has set are kept. `ghost` is the colour of
// the side that repeats what it did in the log, or empty; the game then ends soon after the
// recorded play. Throws InputError.
GameFromLog game_from_log(const LogInstant& instant, const std::string& file,
                          const std::string& seed, const std::string& ghost,
                          const game::Assignments& assignments);

}  // namespace autoref::app
