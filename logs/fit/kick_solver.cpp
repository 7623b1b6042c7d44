#include "logs/fit/kick_solver.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <unsupported/Eigen/LevenbergMarquardt>
#include <unsupported/Eigen/NumericalDiff>

#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

double hop_height_m(double rise_mps) { return square(rise_mps) / (2 * kGravity_mps2); }

double unknown_or(const KickUnknowns& u, Eigen::Index index, double otherwise) {
  return index < u.size() ? u[index] : otherwise;
}

// Where `camera` reports a ball whose lowest point is at `height_m`: on its ray, at the height of
// the centre of a ball on the carpet. Unlikely heights near the camera are lowered.
Vec2 reported_at(const Vec2& position_m, double height_m, const CameraPosition& camera) {
  const double below_m = camera.height_m - kBallRadius_m;
  const double left_m = std::max(below_m - height_m, below_m / 2);
  return camera.position_m + (position_m - camera.position_m) * (below_m / left_m);
}

// Residuals in standard deviations: of the detections, of the ball's position at rest, and of the
// time of the kick, which is somewhere between the last detection before it and the next one.
struct KickResiduals : Eigen::DenseFunctor<double> {
  // The dribbler moves the ball a little between its last detection and the kick.
  static constexpr double kRestDeviation_m = 10_mm;
  static constexpr int kPriors = 3;

  KickResiduals(const KickedBall& kicked, BallModel path, std::span<const KickedSight> seen,
                Eigen::Index unknowns)
      : Eigen::DenseFunctor<double>(static_cast<int>(unknowns),
                                    2 * static_cast<int>(seen.size()) + kPriors),
        ball(kicked),
        model(path),
        sights(seen) {}

  int operator()(const InputType& u, ValueType& residuals) const {
    residuals.head<2>() = (u.head<2>() - ball.rest_m) / kRestDeviation_m;
    residuals[2] = u[kStart] / (ball.interval_s / 2) - 1;
    Eigen::Index i = kPriors;
    for (const KickedSight& sight : sights) {
      residuals.segment<2>(i) =
          (model(u, sight.since_s, sight.camera) - sight.position_m) / ball.noise_m;
      i += 2;
    }
    return 0;
  }

  const KickedBall& ball;
  BallModel model;
  std::span<const KickedSight> sights;
};

}  // namespace

std::span<const KickedSight> sights_until(const KickedBall& ball, double end_s) {
  const auto end = std::find_if(ball.sights.begin(), ball.sights.end(),
                                [&](const KickedSight& sight) { return sight.since_s >= end_s; });
  return {ball.sights.begin(), end};
}

// As in the simulator, landings scale both components of the velocity, and a hop that would stay
// very low ends the flight.
Vec2 chipped_ball(const KickUnknowns& u, double since_s, const CameraPosition& camera) {
  const Vec2 velocity_mps = u.segment<2>(kVx);
  double speed_mps = velocity_mps.norm();
  double rise_mps = u[kVz];
  double left_s = std::max(0.0, since_s - u[kStart]);
  double path_m = 0;
  double kept_xy = unknown_or(u, kFirstXy, 1);
  while (rise_mps > 0 && left_s >= flight_duration_s(rise_mps)) {
    path_m += speed_mps * flight_duration_s(rise_mps);
    left_s -= flight_duration_s(rise_mps);
    speed_mps *= kept_xy;
    kept_xy = unknown_or(u, kLaterXy, 1);
    rise_mps *= unknown_or(u, kFirstZ, 0);
    if (hop_height_m(rise_mps) < kUsualBall.rolls_below_hop_m) rise_mps = 0;
  }
  double height_m = 0;
  if (rise_mps > 0) {
    height_m = left_s * (rise_mps - kGravity_mps2 / 2 * left_s);
    path_m += speed_mps * left_s;
  } else {
    const double roll_s = std::min(left_s, std::abs(speed_mps) / kUsualBall.roll_mps2);
    path_m += roll_s * (speed_mps - std::copysign(kUsualBall.roll_mps2, speed_mps) / 2 * roll_s);
  }
  const Vec2 position_m = u.head<2>() + direction_of(velocity_mps, {1, 0}) * path_m;
  return reported_at(position_m, height_m, camera);
}

Vec2 ball_on_carpet(const KickUnknowns& u, double since_s, const CameraPosition& /*camera*/) {
  const double t_s = std::max(0.0, since_s - u[kStart]);
  const double sliding_s = std::min(t_s, u[kSlidingTime]);
  const double rolling_s = t_s - sliding_s;
  const double lost_m =
      u[kSliding] * sliding_s * (sliding_s / 2 + rolling_s) + u[kRolling] / 2 * square(rolling_s);
  const Vec2 velocity_mps = u.segment<2>(kVx);
  return u.head<2>() + velocity_mps * t_s - direction_of(velocity_mps, {1, 0}) * lost_m;
}

std::optional<KickSolution> fit_kick(const KickedBall& ball, BallModel model, double end_s,
                                     KickUnknowns unknowns) {
  constexpr int kLeastSights = 8;
  constexpr int kMostEvaluations = 1000;
  const auto sights = sights_until(ball, end_s);
  if (sights.size() < kLeastSights) return std::nullopt;
  const Eigen::Index n = unknowns.size();
  Eigen::NumericalDiff<KickResiduals> residuals(KickResiduals(ball, model, sights, n));
  Eigen::LevenbergMarquardt solver(residuals);
  solver.setMaxfev(kMostEvaluations);
  solver.minimize(unknowns);
  Eigen::VectorXd values(residuals.values());
  Eigen::MatrixXd jacobian(residuals.values(), n);
  residuals(unknowns, values);
  residuals.df(unknowns, jacobian);
  const Eigen::LLT<Eigen::MatrixXd> equations(jacobian.transpose() * jacobian);
  KickSolution solution{unknowns, equations.solve(Eigen::MatrixXd::Identity(n, n)),
                        values.squaredNorm() / static_cast<double>(residuals.values() - n)};
  if (!std::isfinite(solution.misfit)) return std::nullopt;
  if (equations.info() != Eigen::Success || !solution.covariance.allFinite())
    solution.covariance.setConstant(std::numeric_limits<double>::infinity());
  solution.covariance *= std::max(1.0, solution.misfit);
  return solution;
}

}  // namespace autoref::logs
