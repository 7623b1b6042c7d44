// The ball in a STOP, as a person at the game controller sees it.
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

// Whether the ball lies where the simulator has to put it.
bool is_in_position(const RefereeSignal& signal, const Tracks& tracks);

class StoppedBall {
 public:
  // `events` are those since play was last on. `signal` must name the next command. The game, the
  // signal and the tracks must outlive this object.
  StoppedBall(const game::GameConfiguration& game, std::vector<GameEvent> events,
              const RefereeSignal& signal, const Tracks& tracks);

  // Whether a team has brought the ball to its position.
  bool was_placed() const;

  bool is_at_rest() const;

  // Whether play can resume with the ball in its present position.
  bool is_ready() const;

  // The team that is to place the ball: the one that takes the restart (the draw is west's), or
  // else its opponents. nullopt if neither may or both have failed, or if robots cannot get the
  // ball.
  std::optional<Side> placer() const;

  // Whether all robots that have to keep their distance from the ball do: before a free kick, the
  // opponents, and otherwise everybody.
  bool are_robots_away() const;

 private:
  bool is_left_to_teams() const;
  bool has_event(GameEventType type, std::optional<Side> by_team) const;

  const game::GameConfiguration* game_;
  std::vector<GameEvent> events_;
  const RefereeSignal* signal_;
  const Tracks* tracks_;
};

}  // namespace autoref::live
