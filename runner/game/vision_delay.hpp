// Vision latency of the teams.
#pragma once

#include <cstddef>
#include <vector>

#include "soccer/tracks.hpp"

namespace autoref::runner {

// Delays tracks by a fixed number of frames.
class DelayLine {
 public:
  explicit DelayLine(int frames) : tracks_(static_cast<std::size_t>(frames) + 1) {}

  void push(const Tracks& tracks) {
    tracks_[taken_ % tracks_.size()] = tracks;
    ++taken_;
  }
  // The tracks delayed by `frames` frames; the first tracks until enough have been pushed.
  const Tracks& oldest() const {
    return taken_ < tracks_.size() ? tracks_.front() : tracks_[taken_ % tracks_.size()];
  }

 private:
  std::vector<Tracks> tracks_;
  std::size_t taken_ = 0;
};

}  // namespace autoref::runner
