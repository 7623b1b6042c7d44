// Reports a game's events to the league's game controller on the network.
#pragma once

#include <string>

#include "live/controller/controller_client.hpp"
#include "live/network/network.hpp"
#include "soccer/rules/game_event.hpp"

namespace autoref::live {

class ControllerReporter {
 public:
  // If the host is empty, it is the sender of the referee packets. `uuid` makes the events' ids
  // unique.
  ControllerReporter(const Address& controller, std::string uuid);

  // Records the sender of the referee packets.
  void note_referee(const std::string& host);

  // Gives the event an id and reports it.
  void report(GameEvent event);

  ControllerStatus status() const { return client_.status(); }

 private:
  std::string uuid_;
  bool is_host_known_;
  std::string host_;  // the last sender of referee packets
  int reported_ = 0;
  NetworkThread thread_;
  ControllerClient client_;
};

}  // namespace autoref::live
