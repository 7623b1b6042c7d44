// Games whose numbers are drawn at random, and their logs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "game/settings/game_settings.hpp"

namespace autoref::tools {

// Whether ten minutes always show enough of a number.
enum class Shown : std::uint8_t { kAlways, kNotAlways };

// A setting that is drawn, uniformly.
struct Drawn {
  std::string_view path;
  double low;
  double high;
  double target;  // for the median error; 0: none
  Shown shown;
};

// The game of this number. Games of other seeds are drawn independently.
game::GameSettings drawn_game(std::size_t number, std::uint64_t seed);

// Plays the first ten minutes of the game and writes them as a log.
void write_log(const game::GameSettings& settings, const std::string& log);

// What was drawn for this setting of the game, such as "sim.ball.roll_mps2", or for this setting of
// its teams, such as "robot.speed_mps". Null if it was not drawn.
const Drawn* drawn_of_game(const std::string& path, const game::GameSettings& game);
const Drawn* drawn_of_robots(const std::string& path);

}  // namespace autoref::tools
