// Decisions of the league's game controller that differ from AutoRef's decisions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/loop/event_log.hpp"
#include "league/messages/referee.pb.h"
#include "referee/decision.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::live {

// One difference: another restart, another position, or no restart where the other referee stopped
// play.
struct ControllerDifference {
  double time_s = 0;  // when AutoRef made a call or the controller stopped play
  std::string text;
};

class ControllerDifferences {
 public:
  void on_decision(const referee::Decision& decision);

  // Adds the controller's newest message and the signal in it. `time_s` is the time in the game.
  void add(const league::RefereePacket& packet, const RefereeSignal& signal, double time_s);

  // Number of the controller's restarts, except those that start a half.
  int restarts() const { return restarts_; }
  const std::vector<ControllerDifference>& differences() const { return differences_; }

  // The differing restarts, one per line, and the table of both referees' game events.
  std::string text() const;

 private:
  struct OwnCall {
    double time_s = 0;
    std::string event;
    Command restart;
    Vec2 ball_to_m{0, 0};
  };

  void compare(const RefereeSignal& signal, double time_s);
  void compare_restart(Command restart, double stopped_s);
  void note(double time_s, std::string text);

  std::optional<OwnCall> call_;  // AutoRef's call since play was last on
  std::optional<std::uint32_t> command_counter_;
  bool has_played_ = false;          // whether play has been on; an earlier stop cannot be judged
  std::optional<double> stopped_s_;  // when the controller stopped play, since play was last on
  std::string reason_;               // the controller's last event
  std::optional<Vec2> position_m_;
  int restarts_ = 0;
  std::vector<ControllerDifference> differences_;
  std::vector<std::string> listed_;  // the events of the last message
  std::vector<game::TimedGameEvent> counted_;
  game::GameEventLog own_;
};

}  // namespace autoref::live
