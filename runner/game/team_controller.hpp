// A team on the field of a simulated game.
#pragma once

#include <memory>
#include <string>

#include "runner/game/configuration.hpp"
#include "runner/game/team_maker.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"
#include "soccer/situation.hpp"
#include "soccer/team_requests.hpp"
#include "soccer/team_view.hpp"
#include "soccer/tracks.hpp"

namespace autoref::runner {

// Owns a side's strategy and what it sees. The game gives it delayed tracks; what goes wrong in the
// strategy ends the game as void.
class TeamController {
 public:
  TeamController(const GameConfiguration& configuration, Side side, const TeamMaker& make_team);

  // Fills `commands`; returns what went wrong, empty where nothing did. Then all commands are zero.
  std::string decide(const Tracks& tracks, const RefereeSignal& signal, const Situation& situation,
                     TeamCommands& commands);

  // What the team asked for with its last decision.
  const TeamRequests& requests() const { return requests_; }

 private:
  std::string fault_in(const TeamCommands& commands) const;

  Side side_;
  int robots_;
  std::unique_ptr<strategies::Strategy> strategy_;
  TeamRequests requests_;
  TeamView view_;
};

}  // namespace autoref::runner
