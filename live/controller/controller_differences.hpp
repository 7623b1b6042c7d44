// What the league's game controller decided otherwise than AutoRef would have.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/loop/event_log.hpp"
#include "league/messages/referee.pb.h"
#include "referee/decision.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::live {

// One restart that differs: another one, another position, or none where the other stopped play.
struct ControllerDifference {
  double time_s = 0;  // when AutoRef called, or the controller stopped
  std::string text;
};

class ControllerDifferences {
 public:
  void on_decision(const referee::Decision& decision);

  // The controller's newest message and the signal in it, at a time of the game.
  void add(const league::RefereePacket& packet, const RefereeSignal& signal, double time_s);

  int restarts() const { return restarts_; }  // the controller's, apart from those of a half
  const std::vector<ControllerDifference>& differences() const { return differences_; }

  // The restarts that differ, one per line, and the table of both referees' game events.
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

  std::optional<OwnCall> call_;  // AutoRef's, since play was on last
  std::optional<std::uint32_t> command_counter_;
  std::optional<double> stopped_s_;  // by the controller, since play was on last
  std::string reason_;               // its last event
  std::optional<Vec2> position_m_;
  int restarts_ = 0;
  std::vector<ControllerDifference> differences_;
  std::vector<std::string> listed_;  // the events of the last message
  std::vector<game::TimedGameEvent> counted_;
  game::GameEventLog own_;
};

}  // namespace autoref::live
