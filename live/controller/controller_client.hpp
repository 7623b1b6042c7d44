// Connects to the league's game controller and reports game events to it.
#pragma once

#include <memory>
#include <string>

#include "live/controller/controller_session.hpp"
#include "live/network/network.hpp"

namespace autoref::live {

struct ControllerStatus {
  bool is_registered = false;
  std::size_t waiting = 0;  // number of events waiting to be sent
  ControllerCounts counts;
  std::string problem;      // problem with the last connection; empty: none
  std::int64_t losses = 0;  // number of lost connections
};

// "registered; 12 events accepted, 1 rejected ...".
std::string controller_line(const ControllerStatus& controller);

// Works in the network's thread. If the connection is lost or refused, the client tries again every
// second.
class ControllerClient {
 public:
  // `host` is an IPv4 address; if it is empty, the host is not known yet (set_host()).
  ControllerClient(NetworkThread& thread, const Address& controller, std::string identifier);
  ~ControllerClient();  // sends waiting events for at most a second
  ControllerClient(const ControllerClient&) = delete;
  ControllerClient& operator=(const ControllerClient&) = delete;

  // Switches to this host unless it is already the current one.
  void set_host(const std::string& host);

  void report(const GameEvent& event);

  ControllerStatus status() const;

 private:
  class Impl;
  std::shared_ptr<Impl> impl_;
};

}  // namespace autoref::live
