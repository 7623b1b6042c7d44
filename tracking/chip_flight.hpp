// Whether and how high a kicked ball flies, by vision that reports no height: it reports where the
// ray from the camera meets the carpet, so that a ball in the air seems to bend and to speed up.
#pragma once

#include "soccer/geometry.hpp"
#include "tracking/chip_fit.hpp"

namespace autoref {

// A sudden change of the ball's velocity between two detections.
struct KickGuess {
  double time_s = 0;            // the middle between them
  double time_deviation_s = 0;  // their distance / sqrt(12)
  Vec2 position_m{0, 0};
  double position_deviation_m = 0;  // per coordinate, beside what the time explains
};

enum class BallFlight { kUnknown, kFlying, kOnGround };

// At the last detection. All but `flight` is for a flying ball only; deviations are standard
// deviations, of places in the worst direction.
struct ChipEstimate {
  BallFlight flight = BallFlight::kUnknown;
  Vec2 position_m{0, 0};
  Vec2 velocity_mps{0, 0};
  Vec2 landing_m{0, 0};
  double position_deviation_m = 0;
  double height_m = 0;  // of the lowest point; 0 on the carpet
  double height_deviation_m = 0;
  double vertical_speed_mps = 0;
  double landing_s = 0;  // on the clock of the detections
  double landing_deviation_s = 0;
  double landing_deviation_m = 0;
};

// Follows the first flight of one kick, by comparing how well a flight and a way along the carpet
// explain the detections. Unknown until one is e^5.5 times as likely, while the ball may hop after
// its landing, and for 1.9 s where neither fits: then the caller begins anew if there was a kick.
// Chips of 2 to 5.5 m/s below cameras 4 m up over the quarters of a 9 x 6 m field: share told
// within 50, 100, 150, 200, 300 ms, then the errors until the landing (RMS, median):
//   noise 0        39  96  99 100 100 %   height   4, 0.3 mm   landing  47, 0.3 mm
//   noise 0.4 mm    8  90  97  99 100 %           16, 3                110, 5
//   noise 1.0 mm    2  64  92  97 100 %           26, 7                130, 11
//   noise 1.4 mm    1  44  88  95 100 %           32, 9                137, 14
// Of the errors 97 % are within two deviations. At most 1 chip in 1000 is called on the ground, and
// 1 straight kick in 1000 flying; more where a robot turns it aside by a few degrees.
class ChipFlight {
 public:
  // `noise_m`: standard deviation of a reported coordinate; one too small makes calls wrong.
  explicit ChipFlight(double noise_m);

  void begin(const KickGuess& kick);

  // Finite detections after the kick, in order of time.
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
  double settled_s_ = 0;  // when nothing can be in the air any more
  Vec2 slant_{0, 0};      // of the ray through the kick's place
  FlightSums flight_;
  CarpetSums carpet_;
  FlightRow fitted_ = FlightRow::Zero();
  double misfit_ = 0;  // the flight's chi-square
  ChipEstimate estimate_;
};

}  // namespace autoref
