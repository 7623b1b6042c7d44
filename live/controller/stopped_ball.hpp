// The ball in a STOP: whether play can resume, and who has to place the ball.
#pragma once

#include <optional>
#include <vector>

#include "game/loop/game_configuration.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/rules/game_event.hpp"
#include "soccer/side.hpp"
#include "soccer/tracks.hpp"
#include "soccer/units.hpp"

namespace autoref::live {

// The ball counts as at rest below this speed; AutoRef's choice.
inline constexpr double kBallAtRest_mps = 0.2_mps;

// The ball counts as in position within this distance of its designated position, if the simulator
// or a person places it; AutoRef's choice.
inline constexpr double kBallInPosition_m = 0.1_m;

// Longest wait for somebody else to go on in a STOP; AutoRef's choice.
inline constexpr double kLongestStop_s = 40_s;

// Whether the ball is in its designated position.
bool is_in_position(const RefereeSignal& signal, const Tracks& tracks);

class StoppedBall {
 public:
  // `events` are those since play was last on; the designated position may have changed in the
  // meantime. If the signal does not name the next command, it counts as a force start. The game,
  // the signal and the tracks must outlive this object.
  StoppedBall(const game::GameConfiguration& game, std::vector<GameEvent> events,
              const RefereeSignal& signal, const Tracks& tracks);

  // Whether the team of this side has placed the ball since play was last on.
  bool was_placed_by(Side side) const;

  bool is_at_rest() const;

  // Whether the ball has come to rest where robots cannot get it.
  bool is_out_of_reach() const;

  // Whether play can resume with the ball in its present position.
  bool is_ready() const;

  // The team that is to place the ball: the one that takes the restart, or else its opponents; for
  // a force start, west comes first. nullopt if teams do not place the ball for this restart, or if
  // neither may or both have failed.
  std::optional<Side> placer() const;

  // Whether the ball has to be placed by hand because no robot will do it: no team can or may, the
  // ball is out of their reach, or play has been stopped for kLongestStop_s. `waited_s` is the time
  // since the STOP. The ball must not be ready.
  bool needs_placement_by_hand(double waited_s) const;

  // Whether all robots that have to keep their distance from the ball do: before a free kick, the
  // opponents, and otherwise everybody.
  bool are_robots_away() const;

 private:
  bool is_left_to_teams() const;
  bool has_event(GameEventType type, Side by_team) const;

  const game::GameConfiguration* game_;
  std::vector<GameEvent> events_;
  const RefereeSignal* signal_;
  Command next_;  // the restart
  const Tracks* tracks_;
};

}  // namespace autoref::live
