// A simulated game commanded by the league's game controller in its CI mode.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "game/loop/game_configuration.hpp"
#include "game/loop/game_record.hpp"
#include "game/loop/observer.hpp"
#include "game/team_programs/program_games.hpp"
#include "live/controller/ci_connection.hpp"
#include "live/live_options.hpp"
#include "live/network/network.hpp"

namespace autoref::live {

// The addresses at which the game controller listens.
struct ControllerPlace {
  Address ci{kLoopback, kCiPort};
  int autoref_port = kControllerPort;  // port for automatic referees, on the same computer
};

// How the game went, apart from the result.
struct ControlledGameReport {
  std::int64_t accepted = 0;  // events that the controller accepted
  std::int64_t rejected = 0;
  std::int64_t unanswered = 0;
  std::string problem;      // problem with the connection for events; empty: none
  std::string differences;  // differing decisions as text (controller_differences.hpp)
};

// Plays one game. The controller gets the tracks of each frame with events or actions of its
// operator, and of the first frame that is at least 25 ms later than the one before; the game
// follows its newest message from the next frame on. AutoRef judges the same game and reports its
// events to the controller's port for automatic referees.
class ControlledGame {
 public:
  // Connects to the controller. `is_interrupted` is called once per frame; the game ends when it
  // returns true. Throws InputError if the controller cannot be reached or if the game has extra
  // time.
  ControlledGame(const game::GameConfiguration& game, const ControllerPlace& place,
                 std::function<bool()> is_interrupted);
  ~ControlledGame();

  // Plays the game, at this pace in wall-clock time; nullopt: as fast as possible. Throws
  // InputError if the connection to the controller is lost, and Interrupted if the game is
  // interrupted before it begins.
  game::PlayedGame play(game::Observers observers, game::GamePrograms& programs,
                        std::optional<double> frames_per_s);

  ControlledGameReport report() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace autoref::live
