// The league's game controller on the network, in command of a simulated game.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "game/loop/game.hpp"
#include "game/loop/game_configuration.hpp"
#include "game/loop/observer.hpp"
#include "league/log_contents.hpp"
#include "league/record_reader.hpp"
#include "live/controller/controller_differences.hpp"
#include "live/controller/controller_reporter.hpp"
#include "live/controller/followed_signal.hpp"
#include "live/controller/placement_watch.hpp"
#include "live/live_options.hpp"
#include "live/network/record_source.hpp"
#include "referee/decision.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::live {

// What the controller and AutoRef said to each other.
struct FollowedControllerReport {
  ControllerStatus status;       // of the connection for events
  league::MessageFaults faults;  // of the referee packets
  std::string differences;       // differing decisions as text (controller_differences.hpp)
};

// Receives the controller's referee packets, which the game follows, and reports the events that
// AutoRef calls, and successful ball placements, to the controller. Robots have to place the ball
// if the game leaves this to the teams; otherwise, and if no robot will
// (StoppedBall::needs_placement_by_hand), it is placed by hand.
class FollowedController final : public game::Observer, league::LogVisitor {
 public:
  // Throws InputError if the packets cannot be received.
  FollowedController(const game::GameConfiguration& game, const LiveOptions& options);

  // Takes the packets that have arrived. Returns whether the controller has a match that is not
  // over and has given a command since the HALT before its first half. Before the game, call this
  // until it returns true, and then follow().
  bool has_match();

  // Takes the packets that have arrived, and lets the game follow them.
  void follow(game::Game& game);

  // Reports the events of the frame that the game has just judged. `start_unix_s` is the Unix time
  // of the game's first frame.
  void report(const game::Game& game, double start_unix_s);

  // A message for the user if there is a new problem: no packets arrive, or the controller takes no
  // events. Looks for problems at most once a second.
  std::optional<std::string> take_notice();

  FollowedControllerReport summary() const;

 private:
  using Clock = std::chrono::steady_clock;

  void on_decision(const referee::Decision& decision) override;
  void on_referee(double time_s, const league::RefereePacket& packet) override;
  void take_packets();
  void update_placement(const Tracks& tracks);
  bool needs_placement_by_hand(const Tracks& tracks) const;
  std::string problem() const;

  game::GameConfiguration game_;
  std::string source_text_;  // where the packets are expected
  RecordSource source_;
  league::RecordReader reader_;
  ControllerReporter reporter_;
  FollowedSignal followed_;
  ControllerDifferences differences_;
  PlacementWatch placement_;
  std::optional<std::int64_t> first_ns_;      // when the first packet arrived
  double now_s_ = 0;                          // the game's time
  std::vector<RefereeSignal> signals_;        // signals that the game has not followed yet
  std::vector<referee::Decision> decisions_;  // decisions that have not been reported yet
  std::optional<RefereeSignal> stopped_;      // the signal for which the ball was last looked at
  // Whether the ball is placed by hand because no robot will.
  bool is_placed_by_hand_ = false;
  Clock::time_point heard_ = Clock::now();
  bool is_heard_ = false;               // whether a packet could be used
  bool has_begun_ = false;              // whether the game has begun
  Clock::time_point checked_ = heard_;  // when take_notice() last looked for problems
  std::string problem_;                 // what it found then
};

}  // namespace autoref::live
