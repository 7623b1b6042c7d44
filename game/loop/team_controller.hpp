// Runs one side's strategy in a simulated game.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "game/loop/configuration.hpp"
#include "game/loop/sensors.hpp"
#include "game/loop/team_maker.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"
#include "soccer/situation.hpp"
#include "soccer/team_requests.hpp"
#include "soccer/team_view.hpp"
#include "soccer/tracks.hpp"

namespace autoref::game {

// Owns a side's strategy and its view of the game. The game supplies delayed tracks; any fault of
// the strategy ends the game.
class TeamController {
 public:
  TeamController(const GameConfiguration& configuration, Side side, const TeamMaker& make_team);

  // Passes on what the team's sensors report about the world that the camera has just seen.
  void sense(const Frame& frame, const sim::WorldState& world);

  // Shows the strategy what the team sees. Call this for both teams before either decides.
  void prepare(const Tracks& tracks, const RefereeSignal& signal, const Situation& situation);

  // Fills `commands`. Returns a description of the strategy's fault, with all commands zero, or an
  // empty string.
  std::string decide(TeamCommands& commands);

  // Tells the strategy how the game has ended. A fault no longer matters.
  void end(const strategies::GameEnd& end);

  // The requests of the team's last decision.
  const TeamRequests& requests() const { return requests_; }

 private:
  std::string fault_in(const TeamCommands& commands) const;

  Side side_;
  int robots_;
  std::unique_ptr<strategies::Strategy> strategy_;
  std::optional<Sensors> sensors_;  // if the strategy has any
  TeamRequests requests_;
  TeamView view_;
  std::string fault_;
};

}  // namespace autoref::game
