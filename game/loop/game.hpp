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
// frame. It reads no files, clock or command line: the caller decides how fast it runs and how to
// use the results; see play() below. Games share no data, so one thread can step several games
// alternately. Do not step games in two threads at once, because Box2D has global state.
class Game {
 public:
  // Sets up the game before its first frame. The observers must outlive the game; `make_team` is
  // called twice here and not stored. Throws std::invalid_argument if the configuration is invalid
  // (unknown strategy, numbers out of range).
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
  // not finite, or if the game exceeds its time limit. It is then void or, if so configured,
  // forfeited by the team that failed. The step that exceeds the limit plays no frame. Exceptions
  // thrown by an observer are passed on; do not step the game after that.
  bool step();

  // The two parts of step(), for callers that decide for a team in between. The first runs the
  // camera and the referee and shows the teams what they see; the second lets the teams decide and
  // the world advance. Both return true while there is more to play; call the second only if the
  // first returned true.
  bool begin_step();
  bool end_step();

  // Accepts a signal, in the program's coordinates, from the game controller that commands the game
  // (referee::Control::kGameController). From the next step on, the teams and the world get this
  // signal, and the referee follows it (Referee::follow). Without such a signal before its first
  // step, the game is void. After POST_GAME, it is over.
  void follow(const RefereeSignal& given);

  // Sets up a situation between steps. A robot must be on the field.
  void put_ball(const sim::BallState& ball);
  void put_robot(RobotId id, const sim::RobotState& state);
  // Like the functions of sim::World. A robot that was taken off stays off until it is put on
  // again.
  void take_off(RobotId id);
  void put_on(RobotId id, const Vec2& position_m, const Vec2& heading);

  // Whether the game is over: the referee has ended it, or it is void. If a new game follows
  // (referee::AfterGame::kNewGame), the first one is over once the referee has started the next.
  bool is_over() const;

  const GameConfiguration& configuration() const;

  // Results of the last step, valid until the next one. Before the first step: an empty frame, HALT
  // and no decisions.
  const Frame& frame() const;                            // as seen by the camera
  const RefereeSignal& signal() const;                   // the referee's signal for that frame
  std::span<const referee::Decision> decisions() const;  // made in that frame, in order
  const Tracks& tracks() const;                          // made from frames up to that one

  // The true state: one frame later than frame(), or at the time of frame() once the referee has
  // ended the game.
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
