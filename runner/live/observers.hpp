// Two observers of one game.
#pragma once

#include "runner/game/observer.hpp"

namespace autoref::runner {

// Calls the first, which may be null, and then the second.
class Observers final : public Observer {
 public:
  Observers(Observer* first, Observer* second) : first_(first), second_(second) {}

  void on_phase(Phase ended) override {
    for_both([&](Observer& one) { one.on_phase(ended); });
  }
  void on_requests(const PerSide<TeamRequests>& requests) override {
    for_both([&](Observer& one) { one.on_requests(requests); });
  }
  void on_other_detections(const OtherDetections& others) override {
    for_both([&](Observer& one) { one.on_other_detections(others); });
  }
  void on_frame(const Frame& frame, const RefereeSignal& signal, const sim::World& world) override {
    for_both([&](Observer& one) { one.on_frame(frame, signal, world); });
  }
  void on_decision(const referee::Decision& decision) override {
    for_both([&](Observer& one) { one.on_decision(decision); });
  }

 private:
  template <typename Action>
  void for_both(const Action& action) {
    if (first_ != nullptr) action(*first_);
    action(*second_);
  }

  Observer* first_;
  Observer* second_;
};

}  // namespace autoref::runner
