// Detects whether a kicked ball flies, and how high, if vision does not report heights. Vision then
// reports where the ray from the camera meets the carpet, so a ball in the air seems to curve and
// accelerate.
#pragma once

#include <Eigen/Cholesky>
#include <cmath>

#include "soccer/geometry.hpp"
#include "soccer/units.hpp"

namespace autoref::tracking {

// Where vision reports the ball, and where the camera is.
struct BallDetection {
  double time_s = 0;
  Vec2 reported_m{0, 0};  // projected onto the plane through the centre of a ball on the carpet
  Vec2 camera_m{0, 0};
  double camera_height_m = 4;  // height above that plane
};

// Slope of the ray from the camera to a point on the carpet. The ball's position is reported -
// slant * height.
inline Vec2 slant_of(const Vec2& position_m, const BallDetection& seen) {
  return (position_m - seen.camera_m) / seen.camera_height_m;
}

// The unknowns of a flight at time 0: position (2), velocity (2), height, vertical speed.
using FlightRow = Eigen::Matrix<double, 6, 1>;

// The accumulated normal equations for two least-squares fits to what vision reports, one of a
// ballistic flight and one of a path on the carpet. The detector compares the two fits. Detections
// have weight 1, so a misfit, the sum of squared residuals, is chi-square times the variance of a
// reported coordinate. Positions are relative to the position of the kick.
struct FlightSums {
  Eigen::Matrix<double, 6, 6> rows = Eigen::Matrix<double, 6, 6>::Zero();
  FlightRow values = FlightRow::Zero();
  double squares = 0;

  // Adds the equation row * unknowns = value.
  void add(const FlightRow& row, double value, double weight);

  // Adds the equations for a ball that is on the ray with slope `slant` through the reported
  // position.
  void add_detection(double t_s, const Vec2& reported_m, const Vec2& slant);
};

struct FlightFit {
  explicit FlightFit(const FlightSums& sums);

  Vec2 velocity_mps() const { return unknowns.segment<2>(2); }
  double rise_mps() const { return unknowns[5]; }
  double height_at(double t_s) const {
    return unknowns[4] + t_s * unknowns[5] - kGravity_mps2 / 2 * t_s * t_s;
  }
  // Downward speed at landing; valid only if the flight rises above the carpet.
  double landing_mps() const {
    return std::sqrt(unknowns[5] * unknowns[5] + 2 * kGravity_mps2 * unknowns[4]);
  }
  double landing_s() const { return (unknowns[5] + landing_mps()) / kGravity_mps2; }
  Vec2 position_at(double t_s) const { return unknowns.head<2>() + t_s * unknowns.segment<2>(2); }

  Eigen::LLT<Eigen::Matrix<double, 6, 6>> equations;
  FlightRow unknowns;
  double misfit;
};

struct CarpetSums {
  Eigen::Matrix3d rows = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 3, 2> values = Eigen::Matrix<double, 3, 2>::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();

  void add_detection(double t_s, const Vec2& reported_m);

  // Misfit of the best path on the carpet with a constant acceleration of at most 11 m/s2. Either
  // the path is straight, decelerated and leads through the kick's position, which has the weight
  // `position_weight`, or it is curved. A ball slides until its spin matches its velocity. If it
  // rolled at `before_mps`, it keeps that spin at first, so the carpet's force opposes the change
  // of its velocity, which need not be along its path. Needs at least three detections.
  double misfit(double position_weight, const Vec2& before_mps) const;
};

// A sudden change of the ball's velocity between two detections.
struct KickGuess {
  double time_s = 0;            // the middle of the interval
  double time_deviation_s = 0;  // the length of that interval / sqrt(12)
  Vec2 position_m{0, 0};
  // Standard deviation per coordinate, without the effect of the uncertain time.
  double position_deviation_m = 0;
  Vec2 before_mps{0, 0};  // the ball's velocity before the kick
};

enum class BallFlight { kUnknown, kFlying, kOnGround };

// The ball's state at the last detection. All fields except `flight` apply only to a flying ball.
// Deviations are standard deviations; those of positions are given for the worst direction.
struct ChipEstimate {
  BallFlight flight = BallFlight::kUnknown;
  Vec2 position_m{0, 0};
  Vec2 velocity_mps{0, 0};
  Vec2 landing_m{0, 0};
  double position_deviation_m = 0;
  double height_m = 0;  // height of the lowest point; 0 on the carpet
  double height_deviation_m = 0;
  double vertical_speed_mps = 0;
  double landing_s = 0;  // time of landing, on the detections' clock
  double landing_deviation_s = 0;
  double landing_deviation_m = 0;
};

// Follows the first flight after one kick. It compares how well a ballistic flight and a path on
// the carpet fit the detections (a likelihood-ratio test). The result is `kUnknown` until one is
// e^5.5 times as likely as the other, while the ball may bounce after landing, and for 1.9 s if
// neither fits. The caller then restarts it if there was a new kick.
//
// Results for chips of 2 to 5.5 m/s, with cameras 4 m above the quarters of a 9 x 6 m field:
// percentage detected within 50, 100, 150, 200 and 300 ms, then errors until landing (RMS, median):
//   noise 0        39  96  99 100 100 %   height   4, 0.3 mm   landing  47, 0.3 mm
//   noise 0.4 mm    8  90  97  99 100 %           16, 3                110, 5
//   noise 1.0 mm    2  64  92  97 100 %           26, 7                130, 11
//   noise 1.4 mm    1  44  88  95 100 %           32, 9                137, 14
// 97 % of the errors are within two deviations. At most 1 chip in 1000 is classified as on the
// ground, and 1 straight kick in 1000 as flying (more if a robot deflects it by a few degrees).
class ChipFlight {
 public:
  // `noise_m`: standard deviation of a reported coordinate; a value that is too small causes wrong
  // results.
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
  double settled_s_ = 0;  // time when every possible bounce has ended
  Vec2 slant_{0, 0};      // slant of the ray through the kick's position
  FlightSums flight_;
  CarpetSums carpet_;
  FlightRow fitted_ = FlightRow::Zero();
  double misfit_ = 0;  // the flight's chi-square
  ChipEstimate estimate_;
};

}  // namespace autoref::tracking
