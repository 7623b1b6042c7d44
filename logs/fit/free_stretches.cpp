#include "logs/fit/free_stretches.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

// Where a ball counts as free. Noise must not hide a touch.
constexpr double kClearOfRobots_m = kRobotRadius_m + kBallRadius_m + 40_mm;
constexpr double kClearOfWalls_m = kBallRadius_m + 30_mm;
constexpr double kClearOfGoalLines_m = 30_mm;
constexpr double kLongestPause_s = 0.15;  // without a detection
constexpr std::ptrdiff_t kFewestDetections = 14;

constexpr std::size_t kFewestForTwoPhases = 18;
// By how much the misfit of two phases must be lower than that of one phase, and how much lower it
// may be if there is only one.
constexpr double kClearGain = 25;
constexpr double kSmallGain = 9;

bool is_free(const RecordedMotion& motion, std::size_t frame) {
  const Vec2& ball_m = motion.ball[frame].position_m;
  return motion.is_running[frame] && motion.nearest_m[frame] > kClearOfRobots_m &&
         std::abs(ball_m.x()) < motion.field.half_length_m() - kClearOfGoalLines_m &&
         std::abs(ball_m.y()) < motion.field.wall_y_m() - kClearOfWalls_m;
}

// The detections of each stretch.
std::vector<std::vector<std::size_t>> detections_in(const RecordedMotion& motion) {
  std::vector<std::vector<std::size_t>> stretches;
  for (const std::vector<std::size_t>& path : free_paths_in(motion)) {
    auto begin = path.begin();
    while (begin != path.end()) {
      const auto end = std::find_if(begin, path.end(), [&](std::size_t frame) {
        return motion.ball[frame].camera != motion.ball[*begin].camera;
      });
      if (end - begin >= kFewestDetections) stretches.emplace_back(begin, end);
      begin = end;
    }
  }
  return stretches;
}

// Fits the line, and projects the detections onto it.
void fit_line(const RecordedMotion& motion, FreeStretch& stretch) {
  Eigen::MatrixX2d points(stretch.frames.size(), 2);
  for (std::size_t i = 0; i < stretch.frames.size(); ++i)
    points.row(static_cast<Eigen::Index>(i)) =
        motion.ball[stretch.frames[i]].position_m.transpose();
  stretch.centre_m = points.colwise().mean();
  points.rowwise() -= stretch.centre_m.transpose();
  const Eigen::Matrix2d covariance = points.transpose() * points;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(covariance);
  stretch.direction = axes.eigenvectors().col(1);
  if ((points.row(points.rows() - 1) - points.row(0)) * stretch.direction < 0)
    stretch.direction = -stretch.direction;
  const Eigen::VectorXd along = points * stretch.direction;
  stretch.along_m.assign(along.begin(), along.end());
  stretch.squares_m2 = std::max(axes.eigenvalues()[0], 0.0);
}

OnePhaseFit one_phase_fit(const FreeStretch& stretch) {
  Eigen::Matrix3d rows = Eigen::Matrix3d::Zero();
  Eigen::Vector3d values = Eigen::Vector3d::Zero();
  const auto row_at = [](double time_s) {
    return Eigen::Vector3d(1, time_s, -time_s * time_s / 2);
  };
  for (std::size_t i = 0; i < stretch.times_s.size(); ++i) {
    const Eigen::Vector3d row = row_at(stretch.times_s[i]);
    rows += row * row.transpose();
    values += row * stretch.along_m[i];
  }
  const Eigen::Matrix3d inverse = rows.inverse();
  const Eigen::Vector3d unknowns = inverse * values;
  double misfit = 0;
  for (std::size_t i = 0; i < stretch.times_s.size(); ++i)
    misfit += square(stretch.along_m[i] - row_at(stretch.times_s[i]).dot(unknowns));
  return {unknowns[0],
          unknowns[1],
          {unknowns[2], stretch.noise_m * std::sqrt(inverse(2, 2))},
          misfit / square(stretch.noise_m)};
}

struct LinearFit {
  Eigen::Vector4d unknowns;
  double squares = 0;  // sum of squared residuals
};

LinearFit linear_fit(const FreeStretch& stretch, double switch_s) {
  Eigen::Matrix4d rows = Eigen::Matrix4d::Zero();
  Eigen::Vector4d values = Eigen::Vector4d::Zero();
  for (std::size_t i = 0; i < stretch.times_s.size(); ++i) {
    const Eigen::RowVector4d row = path_row(stretch.times_s[i], switch_s);
    rows += row.transpose() * row;
    values += row.transpose() * stretch.along_m[i];
  }
  LinearFit fit{rows.ldlt().solve(values)};
  for (std::size_t i = 0; i < stretch.times_s.size(); ++i)
    fit.squares +=
        square(stretch.along_m[i] - path_row(stretch.times_s[i], switch_s) * fit.unknowns);
  return fit;
}

double best_switch_s(const FreeStretch& stretch) {
  constexpr int kGrid = 40;
  constexpr double kMargin = 0.06;  // of the duration, in which no switch could be seen
  const auto switch_at = [&](int i) {
    return stretch.duration_s() * (kMargin + (1 - 2 * kMargin) * i / (kGrid - 1));
  };
  const auto squares = [&](double switch_s) { return linear_fit(stretch, switch_s).squares; };
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kGrid; ++i) {
    if (const double value = squares(switch_at(i)); value < least) {
      least = value;
      best = i;
    }
  }
  constexpr int kSteps = 18;
  return golden_minimum(switch_at(std::max(best - 1, 0)), switch_at(std::min(best + 1, kGrid - 1)),
                        kSteps, squares);
}

TwoPhaseFit two_phase_fit(const FreeStretch& stretch) {
  using Row = Eigen::Matrix<double, 5, 1>;
  constexpr double kStep_s = 1e-3;
  const double switch_s = best_switch_s(stretch);
  const LinearFit fit = linear_fit(stretch, switch_s);
  Eigen::Matrix<double, 5, 5> rows = Eigen::Matrix<double, 5, 5>::Zero();
  for (const double time_s : stretch.times_s) {
    Row row;
    row << path_row(time_s, switch_s).transpose(),
        (path_row(time_s, switch_s + kStep_s) - path_row(time_s, switch_s - kStep_s)) *
            fit.unknowns / (2 * kStep_s);
    rows += row * row.transpose();
  }
  const Eigen::FullPivLU<Eigen::Matrix<double, 5, 5>> lu(rows);
  const Row variances = lu.isInvertible()
                            ? Row(lu.inverse().diagonal().cwiseMax(0) * square(stretch.noise_m))
                            : Row(Row::Constant(std::numeric_limits<double>::infinity()));
  return {fit.unknowns[0],
          fit.unknowns[1],
          switch_s,
          {fit.unknowns[2], std::sqrt(variances[2])},
          {fit.unknowns[3], std::sqrt(variances[3])},
          fit.squares / square(stretch.noise_m)};
}

FreeStretch line_through(const RecordedMotion& motion, std::vector<std::size_t> frames) {
  FreeStretch stretch;
  stretch.frames = std::move(frames);
  stretch.times_s.reserve(stretch.frames.size());
  const double start_s = motion.ball[stretch.frames.front()].time_s;
  for (const std::size_t frame : stretch.frames)
    stretch.times_s.push_back(motion.ball[frame].time_s - start_s);
  fit_line(motion, stretch);
  return stretch;
}

// Degrees of freedom of the distances from a line.
double line_freedom(const FreeStretch& stretch) {
  return static_cast<double>(stretch.frames.size()) - 2;
}

// The noise that explains the distances from the lines in most stretches.
double noise_along_paths_m(const std::vector<FreeStretch>& stretches, double noise_m) {
  constexpr double kMost = 0.75;
  std::vector<double> squares_m2;
  squares_m2.reserve(stretches.size());
  for (const FreeStretch& stretch : stretches)
    squares_m2.push_back(stretch.squares_m2 / line_freedom(stretch));
  return std::max(noise_m, std::sqrt(quantile(std::move(squares_m2), kMost)));
}

}  // namespace

bool is_good_fit(double misfit, double freedom) {
  return misfit < freedom + 4 * std::sqrt(2 * freedom);
}

Eigen::RowVector4d path_row(double time_s, double switch_s) {
  const double first_s = std::min(time_s, switch_s);
  const double second_s = std::max(time_s - switch_s, 0.0);
  return {1, time_s, -first_s * (first_s / 2 + second_s), -second_s * second_s / 2};
}

bool FreeStretch::has_one_phase() const {
  return is_straight && is_good_fit(one.misfit, static_cast<double>(frames.size()) - 3) &&
         (!two || one.misfit - two->misfit < kSmallGain);
}

bool FreeStretch::has_two_phases() const {
  return is_straight && two && is_good_fit(two->misfit, static_cast<double>(frames.size()) - 5) &&
         one.misfit - two->misfit >= kClearGain;
}

bool FreeStretch::slides_then_rolls() const {
  constexpr double kLeastContrast = 2;
  return has_two_phases() && two->first_mps2.value > kSlides_mps2 &&
         two->first_mps2.value > kLeastContrast * two->second_mps2.value;
}

// A rolling ball whose deceleration falls with its speed does not quite have one phase.
bool FreeStretch::rolls_throughout() const {
  const auto is_rolling = [](const Measured& deceleration) {
    return deceleration.value > kLeastRolling_mps2 && deceleration.value < kSlides_mps2;
  };
  if (has_one_phase()) return is_rolling(one.deceleration_mps2);
  return has_two_phases() && is_rolling(two->first_mps2) && is_rolling(two->second_mps2);
}

bool FreeStretch::slides_throughout() const {
  return has_one_phase() && one.deceleration_mps2.value > kSlides_mps2 &&
         one.deceleration_mps2.deviation < kVagueSliding_mps2;
}

std::vector<std::vector<std::size_t>> free_paths_in(const RecordedMotion& motion) {
  std::vector<std::vector<std::size_t>> paths;
  std::vector<std::size_t> current;
  const auto finish = [&] {
    if (!current.empty()) paths.push_back(current);
    current.clear();
  };
  for (std::size_t i = 0; i < motion.frames(); ++i) {
    if (!is_free(motion, i)) {
      finish();
    } else if (motion.ball[i].is_seen) {
      if (!current.empty() &&
          motion.ball[i].time_s - motion.ball[current.back()].time_s > kLongestPause_s)
        finish();
      current.push_back(i);
    }
  }
  finish();
  return paths;
}

std::vector<FreeStretch> free_stretches_in(const RecordedMotion& motion) {
  std::vector<FreeStretch> stretches;
  for (std::vector<std::size_t>& frames : detections_in(motion)) {
    const Vec2 path_m =
        motion.ball[frames.back()].position_m - motion.ball[frames.front()].position_m;
    if (path_m.norm() >= kShortestPath_m)
      stretches.push_back(line_through(motion, std::move(frames)));
  }
  if (stretches.empty()) return stretches;
  const double noise_m = noise_along_paths_m(stretches, motion.ball_noise_m);
  for (FreeStretch& stretch : stretches) {
    stretch.noise_m = noise_m;
    stretch.is_straight = is_good_fit(stretch.squares_m2 / square(noise_m), line_freedom(stretch));
    stretch.one = one_phase_fit(stretch);
    if (stretch.frames.size() >= kFewestForTwoPhases) stretch.two = two_phase_fit(stretch);
  }
  return stretches;
}

}  // namespace autoref::logs
