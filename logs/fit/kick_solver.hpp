// Least-squares fits of a kicked ball's path to what calibrated cameras report without heights.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "logs/fit/estimate.hpp"
#include "sim/sim_configuration.hpp"
#include "soccer/frame.hpp"
#include "soccer/geometry.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {

// A detection after a kick.
struct KickedSight {
  double since_s = 0;  // time since the last detection before the kick
  Vec2 position_m{0, 0};
  CameraPosition camera;
};

struct KickedBall {
  Vec2 rest_m{0, 0};  // the last detection before the kick
  std::vector<KickedSight> sights;
  double interval_s = 0;  // between two frames
  double noise_m = 0;
};

// Where a model needs parameters that the detections hardly show, or a first guess.
inline constexpr sim::BallParameters kUsualBall;

constexpr double flight_duration_s(double rise_mps) { return 2 * rise_mps / kGravity_mps2; }

// The detections less than `end_s` after the last one before the kick.
std::span<const KickedSight> sights_until(const KickedBall& ball, double end_s);

// The unknowns of both models begin with the ball's position at rest, its velocity after the kick
// and the time of the kick.
using KickUnknowns = Eigen::VectorXd;
enum KickUnknown : Eigen::Index { kX, kY, kVx, kVy, kStart, kModel };

// Where `camera` reports a chipped ball. There may be fewer unknowns: without the last ones,
// landings keep the whole speed along the carpet and end the flight.
enum ChipUnknown : Eigen::Index { kVz = kModel, kFirstXy, kFirstZ, kLaterXy };
Vec2 chipped_ball(const KickUnknowns& u, double since_s, const CameraPosition& camera);

// Where any camera reports a ball that slides and then rolls.
enum CarpetUnknown : Eigen::Index { kSliding = kModel, kRolling, kSlidingTime };
Vec2 ball_on_carpet(const KickUnknowns& u, double since_s, const CameraPosition& camera);

using BallModel = Vec2 (*)(const KickUnknowns&, double, const CameraPosition&);

struct KickSolution {
  KickUnknowns unknowns;
  Eigen::MatrixXd covariance;  // infinite if the detections do not determine all unknowns
  double misfit = 0;           // chi-square per degree of freedom

  Measured measured(Eigen::Index i) const { return {unknowns[i], std::sqrt(covariance(i, i))}; }
};

// Fits `model` to the detections until `end_s`, beginning with `unknowns`. Returns nullopt if these
// are too few. If the fit is worse than the noise explains, the covariance is larger.
std::optional<KickSolution> fit_kick(const KickedBall& ball, BallModel model, double end_s,
                                     KickUnknowns unknowns);

}  // namespace autoref::logs
