// Observers of a game's loop.
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "game/play_counts/ball_actions.hpp"
#include "game/play_counts/possession_chains.hpp"
#include "referee/decision.hpp"
#include "sim/world.hpp"
#include "soccer/frame.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/robot_command.hpp"

namespace autoref::game {

class PlayStatistics;

// The game in a frame, for observers that judge the situation. Valid only during the call.
struct StateOfPlay {
  const PlayStatistics& statistics;
  const RefereeSignal& signal;
  const sim::WorldState& now;
};

// The phases of a frame, in order. kReferee includes the tracker. kRecord occurs twice: at the end,
// and after kReferee.
enum class Phase : std::uint8_t { kCamera, kReferee, kTeamWest, kTeamEast, kPhysics, kRecord };
inline constexpr int kPhaseCount = 6;

// All functions are called by Game::step(), in the order of events in a frame.
class Observer {
 public:
  virtual ~Observer() = default;
  // Called at the end of each phase of the frame.
  virtual void on_phase(Phase /*ended*/) {}
  // The teams' requests to the referee. Called once per frame, before the referee.
  virtual void on_requests(const PerSide<TeamRequests>& /*requests*/) {}
  // Called just before on_frame(), with what vision detects in addition to the frame; not called if
  // there is nothing.
  virtual void on_other_detections(const OtherDetections& /*others*/) {}
  // Called once per frame, after the referee and before the teams.
  virtual void on_frame(const Frame& /*frame*/, const RefereeSignal& /*signal*/,
                        const sim::World& /*world*/) {}
  // Called once per frame, just before the world moves, with the commands that reach the robots
  // and, if the ball is placed by hand, its new position.
  virtual void on_commands(const PerSide<TeamCommands>& /*commands*/,
                           const std::optional<Placement>& /*placement*/,
                           const sim::World& /*world*/) {}
  virtual void on_decision(const referee::Decision& /*decision*/) {}
  // Called when an action has ended, after the decisions and before on_chain(). Not called in
  // shoot-outs.
  virtual void on_action(const BallAction& /*action*/) {}
  // Called when a possession chain has ended, after the decisions and before on_frame(). Not called
  // in shoot-outs.
  virtual void on_chain(const PossessionChain& /*chain*/) {}
  // Called for each shot of these chains, after on_chain().
  virtual void on_shot(const Shot& /*shot*/) {}
  // Called once per frame, after on_shot() and before on_frame(). Not called in shoot-outs.
  virtual void on_play(const StateOfPlay& /*play*/) {}
};

// The observers of one game, in the order in which they are called. They must outlive the game.
class Observers {
 public:
  Observers() = default;
  // Implicit, so that a caller with one observer can pass its address; null means none.
  Observers(Observer* one) { add(one); }  // NOLINT(google-explicit-constructor)

  void add(Observer* one) {
    if (one != nullptr) list_.push_back(one);
  }

  // Calls this callback for every observer.
  template <typename... Parameters>
  void call(void (Observer::*callback)(Parameters...),
            const std::type_identity_t<Parameters>&... arguments) const {
    for (Observer* one : list_) (one->*callback)(arguments...);
  }

 private:
  std::vector<Observer*> list_;
};

}  // namespace autoref::game
