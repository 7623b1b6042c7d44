#include "tracking/chip_flight.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace autoref::tracking {
namespace {

// Sliding balls decelerate by 3 to 10.3 m/s2 in the league's models.
constexpr double kHardestBraking_mps2 = 11;

// The residual of a straight-line fit. The normal equations are solved by Cramer's rule.
double line_misfit(double n, double s1, double s2, const Vec2& values, double squares) {
  const double determinant = n * s2 - s1 * s1;
  const double a = (s2 * values[0] - s1 * values[1]) / determinant;
  const double b = (n * values[1] - s1 * values[0]) / determinant;
  return squares - a * values[0] - b * values[1];
}

// Residual of the parabola whose curvature is clamped to the allowed range: the unconstrained
// residual plus the penalty for moving the curvature. The penalty's weight is the last diagonal
// entry of the Cholesky factor, squared: the curvature's information once the other unknowns are
// eliminated (Schur complement).
double braking_misfit(const Eigen::Matrix3d& rows, const Eigen::Vector3d& values, double squares) {
  const Eigen::LLT<Eigen::Matrix3d> equations(rows);
  const Eigen::Vector3d fit = equations.solve(values);
  const double allowed = std::clamp(fit[2], -kHardestBraking_mps2 / 2, 0.0);
  const double certainty = square(equations.matrixLLT()(2, 2));
  return squares - fit.dot(values) + certainty * square(fit[2] - allowed);
}

// Misfit of a path that is straight across `along` and a parabola with bounded deceleration along
// it. Across that direction, the kick's position has the weight `position_weight`.
double path_misfit(const CarpetSums& sums, const Vec2& along, double position_weight) {
  const Vec2 across = left_of(along);
  return line_misfit(sums.rows(0, 0) + position_weight, sums.rows(0, 1), sums.rows(1, 1),
                     (sums.values * across).head<2>(), across.dot(sums.squares * across)) +
         braking_misfit(sums.rows, sums.values * along, along.dot(sums.squares * along));
}

// The prior assumes a chip of up to 5.5 m/s at 45 degrees. It is weak enough that the detections
// soon dominate.
constexpr double kUsualSpeed_mps = 4_mps;
constexpr double kUsualRise_mps = 2.5_mps;
constexpr double kUsualRiseDeviation_mps = 1.25_mps;
constexpr double kFastestRise_mps = 3.9_mps;
constexpr double kRiseError_mps = 1.6_mps;  // error of the vertical speed in an early estimate

// Total duration of all bounces relative to that of the first flight: a geometric series with the
// largest restitution of the league's models, 0.57.
constexpr double kHopsPerFlight = 0.57 / (1 - 0.57);
constexpr double kLongestChip_s = 2 * kFastestRise_mps / kGravity_mps2 * (1 + kHopsPerFlight);

constexpr double kChipLeastNoise_m = 0.2_mm;  // rounding and unmodelled effects
// Lateral deviation per metre that the ball travels in `time_deviation_s`.
constexpr double kBend = 0.1;
constexpr int kLeastDetections = 3;

// Chi-square thresholds.
constexpr double kConvinced = 11;           // difference between the models: likelihood ratio e^5.5
constexpr double kChipInnovationGate = 20;  // for one detection: exceeded by 5 in 100 000
constexpr double kUnlikely_sd = 3.3;        // for a whole fit: exceeded by 5 in 10 000

// Whether chi-square is below the quantile, by the Wilson-Hilferty approximation.
bool is_usual(double chi_square, int freedom) {
  const double k = 2.0 / (9.0 * freedom);
  const double root = 1 - k + kUnlikely_sd * std::sqrt(k);
  return chi_square < freedom * root * root * root;
}

// No chip kicker in the league lifts the ball faster than kFastestRise_mps; a ball that seems to
// rise faster was deflected on the carpet.
bool is_up_at(double t_s, const FlightFit& fit) {
  return fit.rise_mps() > 0 && fit.rise_mps() < kFastestRise_mps + kRiseError_mps &&
         fit.height_at(t_s) > 0;
}

// Square root of the largest eigenvalue of the 2x2 covariance: the error ellipse's major semi-axis.
double worst_deviation_of(const Eigen::Matrix<double, 6, 2>& spread) {
  const Eigen::Matrix2d c = spread.transpose() * spread;
  const double half = (c(0, 0) - c(1, 1)) / 2;
  return std::sqrt((c(0, 0) + c(1, 1)) / 2 + std::sqrt(half * half + square(c(0, 1))));
}

// Propagates the covariance of the fit, (L L^T)^-1 times the noise variance: each column of `parts`
// is one output's gradient g with respect to the unknowns, and noise_m * |L^-1 g| is that output's
// standard deviation.
void add_deviations(const FlightFit& fit, double noise_m, double t_s, ChipEstimate& e) {
  const double lands_s = fit.landing_s();
  const double later = 1 / fit.landing_mps();  // a higher ball lands later and farther away
  const Vec2 further = e.velocity_mps * later;
  Eigen::Matrix<double, 6, 6> parts;
  parts << 0, 0, 1, 0, 1, 0,                     //
      0, 0, 0, 1, 0, 1,                          //
      0, 0, t_s, 0, lands_s, 0,                  //
      0, 0, 0, t_s, 0, lands_s,                  //
      1, later, 0, 0, further.x(), further.y(),  //
      t_s, lands_s * later, 0, 0, lands_s * further.x(), lands_s * further.y();
  fit.equations.matrixL().solveInPlace(parts);
  parts *= noise_m;
  e.height_deviation_m = parts.col(0).norm();
  e.landing_deviation_s = parts.col(1).norm();
  e.position_deviation_m = worst_deviation_of(parts.middleCols<2>(2));
  e.landing_deviation_m = worst_deviation_of(parts.rightCols<2>());
}

ChipEstimate estimate_from(const FlightFit& fit, double noise_m, const KickGuess& kick,
                           double t_s) {
  ChipEstimate e;
  e.flight = BallFlight::kFlying;
  e.height_m = fit.height_at(t_s);
  e.position_m = kick.position_m + fit.position_at(t_s);
  e.velocity_mps = fit.velocity_mps();
  e.vertical_speed_mps = fit.rise_mps() - kGravity_mps2 * t_s;
  e.landing_s = kick.time_s + fit.landing_s();
  e.landing_m = kick.position_m + fit.position_at(fit.landing_s());
  add_deviations(fit, noise_m, t_s, e);
  return e;
}

}  // namespace

void FlightSums::add(const FlightRow& row, double value, double weight) {
  rows += (weight * row) * row.transpose();
  values += (weight * value) * row;
  squares += weight * value * value;
}

// position + slant * height = reported, linear in all unknowns; gravity's term is known.
void FlightSums::add_detection(double t_s, const Vec2& reported_m, const Vec2& slant) {
  const Vec2 value = reported_m + slant * (kGravity_mps2 / 2 * t_s * t_s);
  FlightRow row;
  row << 1, 0, t_s, 0, slant.x(), slant.x() * t_s;
  add(row, value.x(), 1);
  row << 0, 1, 0, t_s, slant.y(), slant.y() * t_s;
  add(row, value.y(), 1);
}

// Weighted least squares by the normal equations. The residual follows from the sums alone, so no
// detection is stored.
FlightFit::FlightFit(const FlightSums& sums)
    : equations(sums.rows),
      unknowns(equations.solve(sums.values)),
      misfit(sums.squares - unknowns.dot(sums.values)) {}

void CarpetSums::add_detection(double t_s, const Vec2& reported_m) {
  const Eigen::Vector3d row(1, t_s, t_s * t_s);
  rows += row * row.transpose();
  values += row * reported_m.transpose();
  squares += reported_m * reported_m.transpose();
}

// The velocity of the path is the regression slope.
double CarpetSums::misfit(double position_weight, const Vec2& before_mps) const {
  const double determinant = rows(0, 0) * rows(1, 1) - rows(0, 1) * rows(0, 1);
  const Vec2 velocity_mps = (rows(0, 0) * values.row(1) - rows(0, 1) * values.row(0)) / determinant;
  const Vec2 along = direction_of(velocity_mps, Vec2(1, 0));
  const double straight = path_misfit(*this, along, position_weight);
  if (before_mps.isZero(0)) return straight;
  return std::min(straight, path_misfit(*this, direction_of(velocity_mps - before_mps, along), 0));
}

ChipFlight::ChipFlight(double noise_m) : noise_m_(std::max(noise_m, kChipLeastNoise_m)) {}

void ChipFlight::begin(const KickGuess& kick) {
  *this = ChipFlight(noise_m_);
  kick_ = kick;
  stage_ = Stage::kUndecided;
  settled_s_ = kick.time_s + kLongestChip_s;
  // A Gaussian prior, entered as one pseudo-observation per unknown.
  const auto believe = [this](int unknown, double value, double deviation) {
    flight_.add(FlightRow::Unit(unknown), value, weight_of(deviation));
  };
  const double along_m = kick.position_deviation_m + kUsualSpeed_mps * kick.time_deviation_s;
  believe(0, 0, along_m);
  believe(1, 0, along_m);
  believe(2, 0, 2 * kUsualSpeed_mps);
  believe(3, 0, 2 * kUsualSpeed_mps);
  believe(4, 0, kUsualRise_mps * kick.time_deviation_s);
  believe(5, kUsualRise_mps, kUsualRiseDeviation_mps);
}

// The weight of an equation with this deviation; the weight of a detection is 1.
double ChipFlight::weight_of(double deviation) const {
  return square(noise_m_ / std::max(deviation, kChipLeastNoise_m));
}

const ChipEstimate& ChipFlight::add(const BallDetection& detection) {
  assert(detection.camera_height_m > 0);
  if (stage_ == Stage::kIdle) return estimate_;
  if (stage_ != Stage::kSettling) {
    ++detections_;
    flight_.add_detection(detection.time_s - kick_.time_s, detection.reported_m - kick_.position_m,
                          slant_of(detection.reported_m, detection));
    stage_ == Stage::kUndecided ? decide(detection) : follow(detection);
  }
  if (detection.time_s >= settled_s_) {
    stage_ = Stage::kIdle;
    estimate_ = {};
    estimate_.flight = BallFlight::kOnGround;
  }
  return estimate_;
}

// Constrains the flight to begin at the kick's position. The constraint across the apparent
// direction does not depend on the kick's time. In the constraint along that direction, a ball that
// has not yet reached the position is extrapolated below the carpet. Both constraints are
// linearised at the last fit (Gauss-Newton).
FlightSums ChipFlight::from_position() const {
  const Vec2 velocity = fitted_.segment<2>(2);
  const double rise = fitted_[5];
  const Vec2 direction = direction_of(velocity + rise * slant_, Vec2(1, 0));
  const Vec2 across = left_of(direction);
  const double bend_m = kBend * kUsualSpeed_mps * kick_.time_deviation_s;
  const double weight = weight_of(kick_.position_deviation_m + bend_m);
  FlightSums sums = flight_;
  FlightRow row;
  row << across.x(), across.y(), 0, 0, across.dot(slant_), 0;
  sums.add(row, 0, weight);
  if (stage_ != Stage::kFlying) return sums;
  row << direction.x(), direction.y(), 0, 0, -direction.dot(velocity) / rise, 0;
  sums.add(row, 0, weight);
  return sums;
}

// Likelihood-ratio test between a flight and a path on the carpet, repeated with each detection.
// Each model must also pass its own chi-square test; if neither does, the height stays unknown
// until no chip could still be bouncing.
void ChipFlight::decide(const BallDetection& detection) {
  const double t_s = detection.time_s - kick_.time_s;
  carpet_.add_detection(t_s, detection.reported_m - kick_.position_m);
  if (detections_ < kLeastDetections) return;
  if (detections_ == kLeastDetections) {
    slant_ = slant_of(kick_.position_m, detection);
    fitted_ = FlightFit(flight_).unknowns;
  }
  const FlightFit fit(from_position());
  fitted_ = fit.unknowns;
  misfit_ = fit.misfit / square(noise_m_);
  const double position_weight = weight_of(kick_.position_deviation_m);
  const double carpet_misfit = carpet_.misfit(position_weight, kick_.before_mps) / square(noise_m_);
  const bool may_fly = is_usual(misfit_, 2 * detections_ - 3);
  const bool may_roll = is_usual(carpet_misfit, 2 * detections_ - 4);
  if (!may_fly && !may_roll) {
    settle(detection.time_s + kLongestChip_s);
  } else if (may_roll && misfit_ - carpet_misfit > kConvinced) {
    settle(detection.time_s);
  } else if (may_fly && is_up_at(t_s, fit) && carpet_misfit - misfit_ > kConvinced) {
    stage_ = Stage::kFlying;
    estimate_ = estimate_from(fit, noise_m_, kick_, t_s);
  }
}

void ChipFlight::follow(const BallDetection& detection) {
  const double t_s = detection.time_s - kick_.time_s;
  const FlightFit fit(from_position());
  fitted_ = fit.unknowns;
  // The increase in the fit's chi-square due to the newest detection.
  const double normalised_innovation_squared = fit.misfit / square(noise_m_) - misfit_;
  misfit_ += normalised_innovation_squared;
  const bool lost = normalised_innovation_squared > kChipInnovationGate ||
                    !is_usual(misfit_, 2 * detections_ - 3) || !is_up_at(t_s, fit);
  const double deviation_s = estimate_.landing_deviation_s;
  if (!lost) {
    estimate_ = estimate_from(fit, noise_m_, kick_, t_s);
  } else if (detection.time_s < estimate_.landing_s - 3 * deviation_s) {  // the ball hit something
    settle(detection.time_s + kLongestChip_s);
  } else {
    const double flight_s = estimate_.landing_s + 2 * deviation_s - kick_.time_s;
    settle(kick_.time_s + flight_s * (1 + kHopsPerFlight));
  }
}

// Stops estimating. The height is unknown until `settled_s`; after that, the ball counts as being
// on the ground.
void ChipFlight::settle(double settled_s) {
  stage_ = Stage::kSettling;
  settled_s_ = settled_s;
  estimate_ = {};
}

}  // namespace autoref::tracking
