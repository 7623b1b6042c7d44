// Detects whether a kicked ball flies, and how high, from vision without heights: vision reports
// where the ray from the camera meets the carpet, so a ball in the air seems to curve and
// accelerate.
#pragma once

#include "soccer/geometry.hpp"
#include "tracking/chip_fit.hpp"

namespace autoref::tracking {

// A sudden change of the ball's velocity between two detections.
struct KickGuess {
  double time_s = 0;            // the middle of the interval
  double time_deviation_s = 0;  // the interval's length / sqrt(12)
  Vec2 position_m{0, 0};
  double position_deviation_m = 0;  // per coordinate, without the time's effect
  Vec2 before_mps{0, 0};            // the ball's velocity before
};

enum class BallFlight { kUnknown, kFlying, kOnGround };

// State at the last detection. All fields except `flight` apply to a flying ball only. Deviations
// are standard deviations, for positions in the worst direction.
struct ChipEstimate {
  BallFlight flight = BallFlight::kUnknown;
  Vec2 position_m{0, 0};
  Vec2 velocity_mps{0, 0};
  Vec2 landing_m{0, 0};
  double position_deviation_m = 0;
  double height_m = 0;  // height of the lowest point; 0 on the carpet
  double height_deviation_m = 0;
  double vertical_speed_mps = 0;
  double landing_s = 0;  // on the detections' clock
  double landing_deviation_s = 0;
  double landing_deviation_m = 0;
};

// Follows the first flight of one kick: compares how well a ballistic flight and a path on the
// carpet fit the detections (a likelihood-ratio test). `kUnknown` until one is e^5.5 times as
// likely, while the ball may bounce after landing, and for 1.9 s if neither fits; the caller then
// restarts it if there was a new kick. Measured on chips of 2 to 5.5 m/s below cameras 4 m above
// the quarters of a 9 x 6 m field: percentage detected within 50, 100, 150, 200, 300 ms, then
// errors until landing (RMS, median):
//   noise 0        39  96  99 100 100 %   height   4, 0.3 mm   landing  47, 0.3 mm
//   noise 0.4 mm    8  90  97  99 100 %           16, 3                110, 5
//   noise 1.0 mm    2  64  92  97 100 %           26, 7                130, 11
//   noise 1.4 mm    1  44  88  95 100 %           32, 9                137, 14
// 97 % of the errors are within two deviations. At most 1 chip in 1000 is classified as on the
// ground, and 1 straight kick in 1000 as flying; more if a robot deflects it by a few degrees.
class ChipFlight {
 public:
  // `noise_m`: standard deviation of a reported coordinate; too small a value causes wrong results.
  explicit ChipFlight(double noise_m);

  void begin(const KickGuess& kick);

  // Adds the next detection after the kick, in order of time; all values must be finite.
  const ChipEstimate& add(const BallDetection& detection);
  const ChipEstimate& estimate() const { return estimate_; }

 private:
  enum class Stage { kIdle, kUndecided, kFlying, kSettling };
  double weight_of(double deviation) const;
  FlightSums from_position() const;
  void decide(const BallDetection& detection);
  void follow(const BallDetection& detection);
  void settle(double settled_s);

  double noise_m_;
  KickGuess kick_;
  Stage stage_ = Stage::kIdle;
  int detections_ = 0;
  double settled_s_ = 0;  // when every possible bounce has ended
  Vec2 slant_{0, 0};      // slant of the ray through the kick's position
  FlightSums flight_;
  CarpetSums carpet_;
  FlightRow fitted_ = FlightRow::Zero();
  double misfit_ = 0;  // the flight's chi-square
  ChipEstimate estimate_;
};

}  // namespace autoref::tracking
