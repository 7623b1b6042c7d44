// One simulated, refereed game, played frame by frame.
#pragma once

#include <memory>
#include <span>

#include "game/loop/game_configuration.hpp"
#include "game/loop/game_record.hpp"
#include "game/loop/observer.hpp"
#include "game/loop/team_controller.hpp"
#include "referee/decision.hpp"
#include "sim/world.hpp"
#include "soccer/frame.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/tracks.hpp"

namespace autoref::game {

// Owns the world, the camera, the tracker, the referee and both teams, and calls them once per
// frame. It does not read files, the clock or the command line. The caller decides how fast the
// game runs and how to use its results; see play() below. Games share no data, so one thread can
// step several games alternately. Do not step games in two threads at once, because Box2D has
// global state.
class Game {
 public:
  // Sets up the game before its first frame. The observers must outlive the game; `make_team` is
  // called twice here and not stored. Throws std::invalid_argument if the configuration is invalid
  // (for example, an unknown strategy or a value out of range).
  explicit Game(GameConfiguration configuration, const Observers& observers = {},
                const TeamMaker& make_team = make_registered_team);
  ~Game();
  Game(Game&&) noexcept;
  Game& operator=(Game&&) noexcept;

  // Plays one frame: the camera sees the world, the referee processes the frame, the teams decide,
  // and the world advances to the next frame. Returns true while there is more to play. The frame
  // in which the referee ends the game is the last one, and the world does not advance in it. Does
  // nothing once the game is over.
  //
  // The game ends if a strategy throws or sends a non-finite number, if the state of the world is
  // not finite, or if the game exceeds its time limit. The game is then void or, if so configured,
  // forfeited by the team that failed. The step in which the limit is exceeded plays no frame.
  // Exceptions thrown by an observer are passed on; do not step the game after that.
  bool step();

  // The two parts of step(), for callers that make a team's decisions between them. The first part
  // runs the camera and the referee and gives the teams their view of the game. The second part
  // lets the teams decide and the world advance. Both functions return true while there is more to
  // play; call the second only if the first returned true.
  bool begin_step();
  bool end_step();

  // Accepts a signal, in the program's coordinates, from the game controller that commands the game
  // (referee::Control::kGameController). From the next step on, the teams and the world get this
  // signal, and the referee follows it (Referee::follow). The game is void if there is no such
  // signal before its first step. The game is over after POST_GAME.
  void follow(const RefereeSignal& given);

  // Sets up a situation between steps. A robot must be on the field.
  void put_ball(const sim::BallState& ball);
  void put_robot(RobotId id, const sim::RobotState& state);
  // Take a robot off the field or put it on, like the functions of sim::World. A robot that was
  // taken off stays off until it is put on again.
  void take_off(RobotId id);
  void put_on(RobotId id, const Vec2& position_m, const Vec2& heading);

  // Whether the game is over: the referee has ended it, or it is void. If a new game follows
  // (referee::AfterGame::kNewGame), the first one is over once the referee has started the next.
  bool is_over() const;

  const GameConfiguration& configuration() const;

  // Results of the last step, valid until the next one. Before the first step: an empty frame, HALT
  // and no decisions.
  const Frame& frame() const;                            // the frame as seen by the camera
  const RefereeSignal& signal() const;                   // the referee's signal for that frame
  std::span<const referee::Decision> decisions() const;  // decisions made in that frame, in order
  const Tracks& tracks() const;                          // computed from the frames up to that one

  // The true state of the world: one frame later than frame(), or at the time of frame() once the
  // referee has ended the game.
  const sim::World& world() const;

  // The record of the frames so far; final once the game is over. Recomputed at each call.
  GameRecord record() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

// Plays one game to its end. Throws like the constructor of Game.
GameRecord play(const GameConfiguration& configuration, const Observers& observers = {},
                const TeamMaker& make_team = make_registered_team);

}  // namespace autoref::game
