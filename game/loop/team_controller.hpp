// Creates one side's strategy in a simulated game and runs it on the readings of the side's
// sensors.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "game/loop/delay_line.hpp"
#include "game/loop/game_configuration.hpp"
#include "sim/world.hpp"
#include "soccer/frame.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/side.hpp"
#include "soccer/team_view.hpp"
#include "soccer/tracks.hpp"
#include "strategies/strategy.hpp"

namespace autoref::game {

// Creates a team. Throws std::invalid_argument if there is no such team.
using TeamMaker = std::function<std::unique_ptr<strategies::Strategy>(
    const TeamConfiguration& team, const strategies::TeamContext& context)>;

// Creates the registered team that the configuration names (strategies/registry.hpp).
std::unique_ptr<strategies::Strategy> make_registered_team(const TeamConfiguration& team,
                                                           const strategies::TeamContext& context);

// The readings of one side's cameras and robots, delayed like the side's view of the game.
class Sensors {
 public:
  Sensors(const GameConfiguration& configuration, Side side);

  // Call once per frame with the world that the camera saw.
  void update(const Frame& frame, const sim::WorldState& world);

  const strategies::SensorReadings& readings() const { return delayed_.oldest(); }

 private:
  Side side_;
  sim::TeamSpec::Robots robots_;
  DelayLine<strategies::SensorReadings> delayed_;
  strategies::SensorReadings latest_;
};

// Owns a side's strategy and its view of the game. The game supplies delayed tracks; any fault of
// the strategy ends the game.
class TeamController {
 public:
  TeamController(const GameConfiguration& configuration, Side side, const TeamMaker& make_team);

  // Updates the team's sensors with the world that the camera has just seen.
  void sense(const Frame& frame, const sim::WorldState& world);

  // Gives the strategy the team's view. Call this for both teams before either decides.
  void prepare(const Tracks& tracks, const RefereeSignal& signal, const Situation& situation);

  // Fills `commands`. Returns a description of the strategy's fault, with all commands zero, or an
  // empty string.
  std::string decide(TeamCommands& commands);

  // Informs the strategy of how the game has ended. A fault in the strategy is ignored at this
  // point.
  void end(const strategies::GameEnd& end);

  // The requests that the team made with its last decision.
  const TeamRequests& requests() const { return requests_; }

 private:
  std::string fault_in(const TeamCommands& commands) const;

  Side side_;
  int robots_;
  std::unique_ptr<strategies::Strategy> strategy_;
  std::optional<Sensors> sensors_;  // nullopt if the strategy uses none
  TeamRequests requests_;
  TeamView view_;
  std::string fault_;
};

}  // namespace autoref::game
