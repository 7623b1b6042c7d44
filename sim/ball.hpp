// Ball dynamics: deceleration on the carpet, flight, landings, and bounces off robots and goals.
//
// On the carpet the ball slides after a kick and rolls later. Its spin is stored as the surface
// speed. While the surface speed differs from the ball's velocity, friction slows the ball and
// spins it up. Once they are equal, the ball rolls. A ball kicked without spin at v therefore
// starts to roll at switch_ratio * v, as in the closed forms of the league's two-phase model. The
// same law applies to a ball that rebounds or is pushed.
#pragma once

#include <optional>
#include <span>

#include "sim/box2d_bridge.hpp"
#include "sim/sim_configuration.hpp"
#include "sim/world.hpp"
#include "soccer/field.hpp"
#include "soccer/geometry.hpp"

namespace autoref::sim {

class Ball {
 public:
  explicit Ball(const BallParameters& parameters);

  double height_m() const { return height_m_; }  // height of the lowest point
  double vertical_mps() const { return vertical_mps_; }
  bool is_rolling() const { return is_rolling_; }
  bool is_in_air() const { return height_m_ > 0.0 || vertical_mps_ != 0.0; }

  // Sets the state. A rolling ball spins as fast as it moves; any other ball does not spin.
  void set(const BallState& state);
  // Starts a kick without spin; `vertical_mps` is positive for a chip.
  void kick(double vertical_mps);
  // Simulates `duration_s` of a ball held by ball placement: it falls to the carpet, without spin
  // or bounces.
  void hold(double duration_s);

  // Returns the velocity after `duration_s` on the carpet; unchanged in the air. A rolling ball
  // that is slower than `rest_mps` comes to rest.
  Vec2 slowed(const Vec2& velocity_mps, double duration_s, double rest_mps);
  // Returns the velocity after `duration_s` of flight, including landings; unchanged on the carpet.
  Vec2 flown(const Vec2& velocity_mps, double duration_s);
  // Applies a collision that changed the velocity by `change_mps`, so that contact friction changes
  // the spin.
  void collide(const Vec2& change_mps);
  // Makes the flying ball leave a collision at `height_m` with vertical speed `vertical_mps`.
  void bounce_in_air(double height_m, double vertical_mps);

 private:
  Vec2 land(const Vec2& velocity_mps);

  BallParameters parameters_;
  double inertia_;  // ratio of the ball's spin-up to its deceleration, both by friction
  Vec2 spin_mps_{0, 0};
  double height_m_ = 0;
  double vertical_mps_ = 0;
  bool is_rolling_ = true;
  bool has_landed_ = false;  // whether the ball has landed since the last kick
};

// Whether the point is above a goal, including its walls.
bool is_over_goal(const Field& field, const Vec2& point_m);
// Whether the point is between a goal's walls, or on the goal line there.
bool is_in_goal(const Field& field, const Vec2& point_m);

// Keeps a ball that has just flown from `former_height_m` from passing through the top of a robot
// or goal. A ball that lands on a top bounces outwards, so that it does not stay there. The net
// stops a ball that rises inside a goal. Returns the ball's new velocity if it hit a top. `robots`
// is the number of robots in the bridge.
std::optional<Vec2> bounced_off_top(const Field& field, const ContactParameters& contacts,
                                    const Box2dBridge& bodies, int robots, double former_height_m,
                                    Ball& ball);

// Collides a flying ball with the bar, which is round and runs from post to post above the goal's
// opening (Laws 2014, law 1). The two given states are less than a frame apart. Returns the ball's
// state at the point of contact, with its velocity reflected along the line between the centres, or
// nullopt if the ball misses the bar. `restitution` is the ratio of separation speed to closing
// speed.
std::optional<BallState> bounced_off_bar(const Field& field, double restitution,
                                         const BallState& former, const BallState& now);

}  // namespace autoref::sim
