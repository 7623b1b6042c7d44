// Predicts which bodies can collide during the next physics steps.
#pragma once

#include <boost/container/static_vector.hpp>

#include "sim/box2d_bridge.hpp"
#include "sim/sim_configuration.hpp"
#include "soccer/field.hpp"
#include "soccer/geometry.hpp"

namespace autoref::sim {

struct Encounters {
  BodySet bodies;  // bodies that can hit another body or a wall; all others move freely
  // Whether shorter steps are needed: something can hit the ball or a wall, or robots can collide
  // hard.
  bool need_short_steps = false;
};

// Predicts encounters in the next `duration_s`. Assumes constant velocities, with margins for the
// deviations that the robots' acceleration limits allow.
class ContactPrediction {
 public:
  ContactPrediction(const Field& field, const PerSide<TeamSpec>& specs, double duration_s);

  // The ball can hit a robot if it comes near the robot's hull or dribbler zone, at any height.
  // Robots that touch or collide gently need no shorter steps: longer ones give the same result
  // (tests/sim/contact_prediction_test.cpp). A ball held by ball placement does not collide with
  // robots, and a disabled robot does not collide with anything. `robots` is the number of robots
  // in the bridge.
  Encounters encounters(const Box2dBridge& bodies, int robots, bool is_ball_held) const;

 private:
  // A disc that contains a robot until the end of the predicted time span.
  struct Disc {
    Vec2 centre_m;
    double radius_m;
    int index;

    bool overlaps(const Vec2& other_m, double other_radius_m) const {
      const double near_m = radius_m + other_radius_m;
      return (other_m - centre_m).squaredNorm() < near_m * near_m;
    }
  };
  using Discs = boost::container::static_vector<Disc, 2 * kMaxRobots>;

  void add_pairs(const Box2dBridge& bodies, const Discs& discs, Encounters& found) const;
  void add_ball(const Box2dBridge& bodies, const Discs& discs, Encounters& found) const;
  bool can_meet(const BodyState& a, const BodyState& b, double touching_m) const;
  double reach_m(const BodyState& body, double radius_m) const;
  bool keeps_off_walls(const Vec2& at_m, double reach_m) const;

  Field field_;
  double duration_s_;
  double margin_m_;             // safety margin around each body
  double dribbler_zone_m_ = 0;  // reach of kicker and dribbler in front of a plate
};

}  // namespace autoref::sim
