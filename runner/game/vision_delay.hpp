// How late teams see the field.
#pragma once

#include <cstddef>
#include <vector>

#include "soccer/tracks.hpp"

namespace autoref::runner {

// The tracks of the last few frames, so that teams see the field as it was.
class DelayLine {
 public:
  explicit DelayLine(int frames) : tracks_(static_cast<std::size_t>(frames) + 1) {}

  void push(const Tracks& tracks) {
    tracks_[taken_ % tracks_.size()] = tracks;
    ++taken_;
  }
  // As many frames back as the line is long; the first one until there are that many.
  const Tracks& oldest() const {
    return taken_ < tracks_.size() ? tracks_.front() : tracks_[taken_ % tracks_.size()];
  }

 private:
  std::vector<Tracks> tracks_;
  std::size_t taken_ = 0;
};

}  // namespace autoref::runner
