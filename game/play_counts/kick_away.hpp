// Classifies a kick when it is fired, by the path of the kicked ball. play_statistics.hpp tracks
// its outcome.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "game/play_counts/chance.hpp"
#include "sim/sim_configuration.hpp"
#include "sim/world.hpp"
#include "soccer/field.hpp"
#include "soccer/geometry.hpp"

namespace autoref::game {

// The straight path of a kicked ball that nobody touches, in closed form from sim::BallParameters.
// If a rolling ball's deceleration grows with its speed, the mean deceleration over its path is
// used.
//
// After a flat kick the ball slides, then rolls. After a chip kick it flies, then rolls; later hops
// are neglected, which makes the path a few per cent too long.
class BallTrajectory {
 public:
  // The path of a ball that starts at `from_m` with `velocity_mps` in the plane and `vertical_mps`
  // upwards.
  BallTrajectory(const Vec2& from_m, const Vec2& velocity_mps, double vertical_mps,
                 const sim::BallParameters& ball);

  Vec2 point_m(double path_m) const { return from_m_ + path_m * direction_; }
  const Vec2& from_m() const { return from_m_; }
  const Vec2& direction() const { return direction_; }  // unit vector
  // Length of the first flight; 0 for a flat kick.
  double flight_m() const { return flight_m_; }
  // Length of the path until the ball is at rest.
  double reach_m() const { return phases_[0].length_m + phases_[1].length_m; }

  // The speed at distance `path_m` along the path, from 0 to reach_m().
  double speed_mps(double path_m) const;
  double time_s(double path_m) const;
  double height_m(double path_m) const;  // height of the ball's bottom during its first flight

 private:
  // A phase with constant deceleration.
  struct Phase {
    double speed_mps = 0;  // at the start of the phase
    double slowing_mps2 = 0;
    double length_m = 0;

    double speed_at_mps(double path_m) const;
    double time_at_s(double path_m) const;
  };

  Vec2 from_m_;
  Vec2 direction_;
  double vertical_mps_;
  double flight_m_ = 0;
  std::array<Phase, 2> phases_;
};

struct KickAway {
  RobotId robot;
  std::int64_t frame = 0;  // as in sim::Touch
  Vec2 from_m{0, 0};
  // Only if the kick's path is that of a shot.
  std::optional<ShotSituation> shot{};
  bool is_for_mate = false;  // whether the kick's path is that of a pass
};

// Returns nullopt if the ball does not leave the robot fast enough. `now` is the world at the end
// of the kick's frame. Definitions and thresholds are in play_counts.hpp.
std::optional<KickAway> kick_away(const sim::Touch& kick, const sim::WorldState& now,
                                  const Field& field, const sim::BallParameters& ball);

}  // namespace autoref::game
