// A simulated game in real time on the league's network.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "game/loop/game_configuration.hpp"
#include "game/loop/game_record.hpp"
#include "game/loop/observer.hpp"
#include "game/team_programs/program_games.hpp"
#include "live/controller/followed_controller.hpp"
#include "live/frame_pacer.hpp"
#include "live/live_options.hpp"
#include "live/simulator/team_ports.hpp"
#include "strategies/strategy.hpp"

namespace autoref::live {

// How a live game went, apart from its result.
struct LiveReport {
  Punctuality punctuality;
  std::int64_t dropped = 0;  // datagrams that the system did not accept
  PerSide<TeamTraffic> traffic;
  StreamTroubles connections;
  std::int64_t wrong_control = 0;  // packets with errors at the control port
  // Number of frames in which a network team's newest packet was 0 frames old, 1 frame old, or
  // older.
  PerSide<std::array<std::int64_t, 3>> command_ages;
  std::optional<FollowedControllerReport> controller;  // nullopt unless it commands the game
};

// Plays one game. In each frame, the camera sees the world, the referee decides, and vision,
// referee and tracker packets are sent. The teams have time until the next frame is due; then the
// world advances with their newest commands. At unlimited speed, the next frame is due when every
// network team has sent a packet since this one. In lock-step, it is due when every network team
// (and the control port if it takes part) has requested it.
//
// If the league's game controller commands the game (referee::Control::kGameController), the game
// begins as soon as the controller has a match (FollowedController::has_match), waits for no team,
// and ends after POST_GAME, or as void after a day.
class LiveGame {
 public:
  // Opens the ports of the network teams. A game under a game controller must be paced by the
  // clock. `is_interrupted` is called about once per frame; the game ends when it returns true.
  // Throws InputError if the network cannot be used.
  LiveGame(const game::GameConfiguration& game, const LiveOptions& options, FrameClock& clock,
           std::function<bool()> is_interrupted);
  ~LiveGame();

  // Makes a team that plays over the network, for a TeamMaker.
  std::unique_ptr<strategies::Strategy> make_network_team(const strategies::TeamContext& context);

  // Plays the game and, unless it is interrupted, sends its last frame for another second. Throws
  // Interrupted if the game is interrupted before it begins.
  game::PlayedGame play(game::Observers observers, game::GamePrograms& programs);

  LiveReport report() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace autoref::live
