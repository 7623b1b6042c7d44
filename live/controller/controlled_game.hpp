// A simulated game that the league's game controller commands, in its CI mode.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "game/loop/game_configuration.hpp"
#include "game/loop/game_record.hpp"
#include "game/loop/observer.hpp"
#include "game/team_programs/program_games.hpp"
#include "live/network/network.hpp"

namespace autoref::live {

// Where the game controller listens.
struct ControllerPlace {
  Address ci{kLoopback, 10009};
  int autoref_port = 10007;  // on the same computer
};

// How it went, apart from the result.
struct ControlledGameReport {
  std::int64_t accepted = 0;  // events that the controller took
  std::int64_t rejected = 0;
  std::int64_t unanswered = 0;
  std::string problem;      // of the connection for events; empty: none
  std::string differences;  // for a reader (controller_differences.hpp)
};

// Plays one game. In each frame, the controller gets the tracks and what its operator does, and its
// newest message is followed from the next frame on; AutoRef judges beside it and reports its
// events at the controller's port for automatic referees.
class ControlledGame {
 public:
  // Connects to the controller. `check` is called once per frame and may throw. Throws InputError
  // if the controller is not there, or if the game has extra time.
  ControlledGame(const game::GameConfiguration& game, const ControllerPlace& place,
                 std::function<void()> check);
  ~ControlledGame();

  // Throws InputError if the controller disappears.
  game::GameRecord play(game::Observers observers, game::GamePrograms& programs);

  ControlledGameReport report() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace autoref::live
