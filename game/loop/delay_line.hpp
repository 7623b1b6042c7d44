// A delay line for the vision latency of the teams.
#pragma once

#include <cstddef>
#include <vector>

namespace autoref::game {

// Delays values by a fixed number of frames.
template <typename Value>
class DelayLine {
 public:
  explicit DelayLine(int frames) : values_(static_cast<std::size_t>(frames) + 1) {}

  void push(const Value& value) {
    values_[taken_ % values_.size()] = value;
    ++taken_;
  }
  // The value from `frames` frames ago; the first value until that many have been pushed.
  const Value& oldest() const {
    return taken_ < values_.size() ? values_.front() : values_[taken_ % values_.size()];
  }

 private:
  std::vector<Value> values_;
  std::size_t taken_ = 0;
};

}  // namespace autoref::game
