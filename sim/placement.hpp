// Moves the ball to the position of the next restart ("the simulator can then drag the ball
// smoothly to the desired location", paper, section 4.1).
#pragma once

#include <boost/container/static_vector.hpp>

#include "sim/sim_configuration.hpp"
#include "soccer/field.hpp"
#include "soccer/geometry.hpp"

namespace autoref::sim {

// The path of a carried ball: its corners in order, ending with the target.
using Route = boost::container::static_vector<Vec2, 5>;

// A path from `start_m` to `target_m` that never crosses a goal's walls or net. It enters and
// leaves a goal through the opening, and it reaches and leaves a position behind a goal around the
// goal's side, at a distance of `clearance_m`.
Route route_between(const Field& field, const Vec2& start_m, const Vec2& target_m,
                    double clearance_m);

// Carries a ball along a route with limited speed and acceleration. The ball starts from rest and
// stops at each corner and at the target.
class Carrier {
 public:
  Carrier(const Field& field, const PlacementParameters& parameters)
      : field_(field), parameters_(parameters) {}

  void start(const Vec2& from_m, const Vec2& target_m);

  // Advances by `duration_s` and returns the ball's position.
  Vec2 carry(double duration_s);

 private:
  double leg_length_m() const;
  double leg_duration_s() const;
  double path_m(double time_s) const;  // distance travelled since the start of the leg

  Field field_;
  PlacementParameters parameters_;
  Route route_;
  std::size_t next_ = 0;  // index of the next corner
  Vec2 from_m_{0, 0};     // start of the leg
  double time_s_ = 0;     // time since the start of the leg
};

}  // namespace autoref::sim
