#include "live/simulator/control_requests.hpp"

#include <cstddef>
#include <utility>

namespace autoref::live {
namespace {

constexpr std::size_t kMostRequests = 64;

}  // namespace

bool ControlRequests::add(league::SimulatorRequest request) {
  const std::lock_guard lock(mutex_);
  if (requests_.size() == kMostRequests) return false;
  requests_.push_back(std::move(request));
  return true;
}

std::vector<league::SimulatorRequest> ControlRequests::take_all() {
  const std::lock_guard lock(mutex_);
  return std::exchange(requests_, {});
}

std::optional<double> ControlRequests::speed() const {
  const std::lock_guard lock(mutex_);
  std::optional<double> speed;
  for (const league::SimulatorRequest& request : requests_)
    speed = request.speed ? request.speed : speed;
  return speed;
}

}  // namespace autoref::live
