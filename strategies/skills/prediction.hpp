// Simple prediction of robots and ball to compensate for the view's latency.
#pragma once

#include <array>

#include "soccer/team_view.hpp"

namespace autoref::strategies {

// The ball's position `ahead_s` from now, at a constant deceleration between the carpet's sliding
// and rolling values.
Vec2 ball_after(const TrackedBall& ball, double ahead_s);

// `view` extrapolated by its latency, to when commands given now take effect.
void look_ahead(const TeamView& view, TeamView& ahead);

// A rough estimate of the time in seconds that a robot needs to reach a point, from rest to rest,
// at the teams' usual speeds.
double travel_time_s(const TrackedRobot& robot, const Vec2& point_m);

struct Interception {
  Vec2 point_m{0, 0};
  double time_s = 0;  // time until the robot arrives
};

// The rolling ball's position now and at each step of the next 2 s, computed once for all robots.
// For a ball at rest, only the current position.
class BallSamples {
 public:
  static constexpr int kSteps = 20;
  static constexpr double time_s(int step) { return 2.0 * step / kSteps; }

  explicit BallSamples(const TrackedBall& ball);

  bool lies_still() const { return lies_still_; }  // whether the ball is slower than 0.1 m/s
  const Vec2& at(int step) const { return points_m_[static_cast<std::size_t>(step)]; }

 private:
  bool lies_still_;
  std::array<Vec2, kSteps + 1> points_m_;
};

// Where `robot` can first meet the rolling ball; if it cannot catch up with the ball, the ball's
// position in 2 s.
Interception intercept(const TrackedRobot& robot, const BallSamples& ball);
Interception intercept(const TrackedRobot& robot, const TrackedBall& ball);

}  // namespace autoref::strategies
