// How high a kicked ball flies, told from vision that reports no height.
//
// Vision projects the ball onto the carpet: it reports the place where the ray from the camera
// through the ball meets the plane of a lying ball's centre. A flying ball therefore seems to
// speed up and to bend away from where a kick along the carpet would go.
#pragma once

#include <Eigen/Core>

#include "soccer/geometry.hpp"
#include "soccer/units.hpp"

namespace autoref {

// A sudden change of the ball's velocity, as its discoverer knows it.
struct KickGuess {
  double time_s = 0;            // the middle between the sightings before and after it
  double time_deviation_s = 0;  // their distance / sqrt(12)
  Vec2 place_m{0, 0};
  double place_deviation_m = 0;  // across the ball's way; along it the time counts
};

struct BallSighting {
  double time_s = 0;
  Vec2 reported_m{0, 0};       // on the plane of a lying ball's centre
  Vec2 camera_m{0, 0};         // of the camera that saw it
  double camera_height_m = 4;  // above that plane
};

enum class BallFlight { kUnknown, kFlying, kOnGround };

// What is known at the last sighting. All but `flight` holds for a flying ball only. Deviations are
// standard deviations, in the plane those of the worst direction.
struct ChipEstimate {
  BallFlight flight = BallFlight::kUnknown;
  double height_m = 0;  // of the lowest point; 0 on the carpet
  double height_deviation_m = 0;
  Vec2 position_m{0, 0};
  double position_deviation_m = 0;
  Vec2 velocity_mps{0, 0};
  double vertical_speed_mps = 0;
  double landing_s = 0;  // on the clock of the sightings
  double landing_deviation_s = 0;
  Vec2 landing_m{0, 0};
  double landing_deviation_m = 0;
};

// Follows one kick from sighting to sighting: fits a ballistic flight and a straight, slowing way
// along the carpet, and compares the two by their likelihoods.
class ChipFlight {
 public:
  // `noise_m`: the standard deviation of a reported coordinate.
  explicit ChipFlight(double noise_m);

  void begin(const KickGuess& kick);

  // Sightings in order of time, the first one after the kick.
  const ChipEstimate& add(const BallSighting& sighting);
  const ChipEstimate& estimate() const { return estimate_; }

 private:
  ChipEstimate estimate_;
};

}  // namespace autoref
