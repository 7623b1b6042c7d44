// A side of a recorded game from one time on, as an opponent that repeats itself
// (game/loop/ghost.hpp).
#pragma once

#include <filesystem>
#include <optional>

#include "game/loop/ghost.hpp"
#include "soccer/side.hpp"

namespace autoref::logs {

// Recorded play that goes on for longer is cut.
inline constexpr double kLongestGhost_s = 300;

struct LoggedGhost {
  // Yellow is in the west, whichever end it defends in the log, and robots have the numbers of the
  // log. Positions and velocities come from the tracker; the ball's vertical velocity is unknown
  // and set to zero. The frames end when the recorded referee stops play, where the log shows
  // nothing for a second, or with the log. The touches come from AutoRef's touch detector; one
  // is at 0 if the other side has the ball at its hull from the start.
  game::Ghost ghost;
  // The side whose goal ended the recorded play, according to the score in the packets when play is
  // resumed, but at most a minute after the stop.
  std::optional<Side> scorer;
};

// The side's motion from `at_s` on, in seconds from the start of the log; the ghost's times count
// from there. Its first frame is the log's last frame at or before that time. Without referee
// packets, and before the first one, play counts as on. Throws std::invalid_argument if the file is
// not a log, if the log does not cover that time, or if play is stopped at that time.
LoggedGhost logged_ghost(const std::filesystem::path& log, double at_s, Side side);

}  // namespace autoref::logs
