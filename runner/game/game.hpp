// One simulated, refereed game, played frame by frame.
#pragma once

#include <memory>
#include <span>

#include "referee/decision.hpp"
#include "runner/game/configuration.hpp"
#include "runner/game/game_record.hpp"
#include "runner/game/observer.hpp"
#include "runner/game/team_maker.hpp"
#include "sim/world.hpp"
#include "soccer/frame.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::runner {

// Owns the world, the camera, the referee and both teams, and calls them once a frame. It reads no
// files, no clock and no command line: whoever drives it decides how fast it runs and what becomes
// of it. play() below is such a driver. Games share nothing, so that one thread may step several of
// them by turns; two threads must not, as Box2D keeps state of its own.
class Game {
 public:
  // Sets up the game before its first frame. `observer`, if any, must outlive the game; `make_team`
  // is called twice here and not kept. Throws std::invalid_argument for a configuration that no
  // game can be made of (unknown strategy, numbers out of range).
  explicit Game(GameConfiguration configuration, Observer* observer = nullptr,
                const TeamMaker& make_team = make_registered_team);
  ~Game();
  Game(Game&&) noexcept;
  Game& operator=(Game&&) noexcept;

  // Plays one frame: the camera sees the world, the referee judges what it sees, the teams decide,
  // and the world moves on to the next frame. Returns true while there is more to play. The frame
  // in which the referee ends the game is its last, and the world stays where it was. Once the game
  // is over, nothing happens.
  //
  // A strategy that throws or sends a number that is not finite makes the game void, and so over.
  // What an observer throws comes out; step no further then.
  bool step();

  // Whether the referee has ended the game, or it is void. Where a new game follows
  // (referee::AfterGame::kNewGame), the first one is over once the referee has begun the next.
  bool is_over() const;

  const GameConfiguration& configuration() const;

  // Of the last step, until the next one. Before the first: an empty frame, HALT, no decisions.
  const Frame& frame() const;                            // as the camera saw it
  const RefereeSignal& signal() const;                   // given on that frame
  std::span<const referee::Decision> decisions() const;  // the referee's on that frame, in order

  // The true state: one frame after frame(), or the same once the referee has ended the game.
  const sim::World& world() const;

  // The record of the frames so far; final once the game is over. Collected anew at each call.
  GameRecord record() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

// Plays one game to its end. Throws as the constructor of Game does.
GameRecord play(const GameConfiguration& configuration, Observer* observer = nullptr,
                const TeamMaker& make_team = make_registered_team);

}  // namespace autoref::runner
