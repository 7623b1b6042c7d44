// Watches a game from inside its loop.
#pragma once

#include <cstdint>

#include "referee/decision.hpp"
#include "sim/world.hpp"
#include "soccer/frame.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/team_requests.hpp"

namespace autoref::runner {

// The parts of a frame, in their order. The record is kept after the referee, too.
enum class Phase : std::uint8_t { kCamera, kReferee, kTeamWest, kTeamEast, kPhysics, kRecord };
inline constexpr int kPhaseCount = 6;

// All calls come from Game::step(), in the order of what happens in a frame.
class Observer {
 public:
  virtual ~Observer() = default;
  // A part of the frame has ended.
  virtual void on_phase(Phase /*ended*/) {}
  // Once per frame, before the referee: what it is asked for.
  virtual void on_requests(const PerSide<TeamRequests>& /*requests*/) {}
  // Once per frame, after the referee and before the teams.
  virtual void on_frame(const Frame& /*frame*/, const RefereeSignal& /*signal*/,
                        const sim::World& /*world*/) {}
  virtual void on_decision(const referee::Decision& /*decision*/) {}
};

}  // namespace autoref::runner
