// Bounces of the ball, found and measured in the detections around them.
#pragma once

#include <cstddef>
#include <vector>

#include "logs/fit/recorded_motion.hpp"
#include "sim/sim_configuration.hpp"
#include "soccer/geometry.hpp"

namespace autoref::logs {

// A restitution is the ratio of the speeds along the normal of the contact, after and before it.
struct Bounce {
  double restitution = 0;
  double weight = 0;  // how much it counts in an estimate
};

// A bounce with these speeds.
Bounce bounce_of(double closing_mps, double leaving_mps);

// Bounces off the walls around the field, which are where the log's geometry says. `ball` is how
// the ball slides and rolls: after a bounce it slides, until it rolls again.
std::vector<Bounce> wall_bounces_in(const RecordedMotion& motion, const sim::BallParameters& ball);

// Bounces off robots during play, except off their fronts, with plate and dribbler.
std::vector<Bounce> body_bounces_in(const RecordedMotion& motion, const sim::BallParameters& ball);

// A bounce is not measured with fewer detections of the ball before it, or after it.
inline constexpr std::size_t kLeastBounceSights = 5;

// Positions over time, each with the standard deviation of its components.
struct Points {
  std::vector<double> times_s;
  std::vector<Vec2> positions_m;
  std::vector<double> deviations_m;

  std::size_t size() const { return times_s.size(); }
  void add(double time_s, const Vec2& position_m, double deviation_m) {
    times_s.push_back(time_s);
    positions_m.push_back(position_m);
    deviations_m.push_back(deviation_m);
  }
};

// A straight motion at a constant velocity: the position at time 0 and the velocity. `residual` is
// the root mean square over points and components, in standard deviations.
struct Line {
  Vec2 position_m{0, 0};
  Vec2 velocity_mps{0, 0};
  double residual = 0;

  Vec2 at(double time_s) const { return position_m + time_s * velocity_mps; }
};

Line straight_line_through(const Points& points);

// Frames from the first to the last.
struct Stretch {
  std::size_t first = 0;
  std::size_t last = 0;
};

// The stretches in which `is_near` holds. Gaps of fewer than `gap` frames are part of a stretch.
template <typename Predicate>
std::vector<Stretch> stretches_of(std::size_t frames, std::size_t gap, const Predicate& is_near) {
  std::vector<Stretch> stretches;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    if (!is_near(frame)) continue;
    if (stretches.empty() || frame - stretches.back().last > gap)
      stretches.push_back({frame, frame});
    stretches.back().last = frame;
  }
  return stretches;
}

}  // namespace autoref::logs
