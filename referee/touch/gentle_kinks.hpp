// Changes of the ball's velocity that noise hides from frame to frame, but not over a few frames.
//
// Straight lines are fitted to the ball's way before and after each sighting. Where they differ by
// more than the carpet and the noise of both explain, and by more than at the sightings beside, the
// ball met something there. It is known some frames later.
#pragma once

#include <array>
#include <optional>

#include "referee/touch/touch_candidates.hpp"
#include "referee/touch_parameters.hpp"

namespace autoref::referee {

struct GentleKink {
  const Sighting* before = nullptr;  // the sightings beside the kink; valid until the next one
  const Sighting* after = nullptr;
  double since_s = 0;  // time of the oldest sighting that tells of it
  BallWay way;
  Impulse impulse;
};

class GentleKinks {
 public:
  explicit GentleKinks(const TouchParameters& parameters) : parameters_(parameters) {}

  // Forgets all sightings.
  void restart() { known_ = 0; }

  // Takes in a sighting; the kink that it completes, if there is one.
  std::optional<GentleKink> update(const Sighting& sighting);

 private:
  static constexpr int kHalf = 4;  // intervals on either side
  static constexpr int kKept = 2 * kHalf + 2;

  // A straight, even way fitted to sightings.
  struct Line {
    double middle_s = 0;
    Vec2 middle_m{0, 0};
    Vec2 velocity_mps{0, 0};
    double variance_m2ps2 = 0;  // of each coordinate of the velocity
    Vec2 at(double time_s) const { return middle_m + velocity_mps * (time_s - middle_s); }
  };

  const Sighting& sighting(int back) const {
    return sightings_[static_cast<std::size_t>((newest_ + kKept - back) % kKept)];
  }
  Line line_through(int newest_back, int oldest_back) const;
  Vec2 unexplained_change_mps(const Line& before, const Line& after) const;

  TouchParameters parameters_;
  std::array<Sighting, kKept> sightings_;
  int newest_ = 0;
  int known_ = 0;
  double former_excess_ = 0;  // of the change, in what is explained, at the middle before
  GentleKink former_;         // there, but for the sightings
};

}  // namespace autoref::referee
