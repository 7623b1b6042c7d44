// How ball placement brings the ball to where play goes on ("the simulator can then drag the
// ball smoothly to the desired location", paper, section 4.1).
#pragma once

#include <boost/container/static_vector.hpp>

#include "sim/configuration.hpp"
#include "soccer/field.hpp"
#include "soccer/geometry.hpp"

namespace autoref::sim {

// The way of a carried ball: corners to pass one by one, the target last.
using Route = boost::container::static_vector<Vec2, 5>;

// A way from `start_m` to `target_m` that never passes a goal's walls or net: into and out of a
// goal it leads through the mouth, to and from a place behind a goal around its side, at
// `clearance_m` from both.
Route route_between(const Field& field, const Vec2& start_m, const Vec2& target_m,
                    double clearance_m);

// Carries a ball along a route at limited speed and acceleration. It starts from rest and comes to
// rest at each corner and at the target.
class Carrier {
 public:
  Carrier(const Field& field, const PlacementParameters& parameters)
      : field_(field), parameters_(parameters) {}

  void start(const Vec2& from_m, const Vec2& target_m);

  // Goes on for `duration_s`; where the ball is then.
  Vec2 carry(double duration_s);

 private:
  double leg_length_m() const;
  double leg_duration_s() const;
  double path_m(double time_s) const;  // from the leg's begin

  Field field_;
  PlacementParameters parameters_;
  Route route_;
  std::size_t next_ = 0;  // corner ahead
  Vec2 from_m_{0, 0};     // the leg's begin
  double time_s_ = 0;     // since then
};

}  // namespace autoref::sim
