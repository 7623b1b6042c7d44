// Requests to the simulator, on their way from the network's thread to the game's.
#pragma once

#include <mutex>
#include <optional>
#include <vector>

#include "league/simulator/simulator_command.hpp"

namespace autoref::live {

// Requests to the simulator that are waiting for the game's thread, at most 64.
class ControlRequests {
 public:
  // Called in the network's thread. Returns false if 64 requests are already waiting.
  bool add(league::SimulatorRequest request);
  std::vector<league::SimulatorRequest> take_all();
  // The speed in the latest waiting request that sets one, if any.
  std::optional<double> speed() const;

 private:
  mutable std::mutex mutex_;
  std::vector<league::SimulatorRequest> requests_;
};

}  // namespace autoref::live
