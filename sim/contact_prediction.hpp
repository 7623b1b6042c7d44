// Decides whether physics may take a longer step because no contact can occur within it.
#pragma once

#include "sim/box2d_bridge.hpp"
#include "sim/configuration.hpp"
#include "soccer/field.hpp"
#include "soccer/geometry.hpp"

namespace autoref::sim {

// Looks `duration_s` ahead. Assumes constant velocities, with margins for the deviations that the
// robots' acceleration limits allow.
class ContactPrediction {
 public:
  ContactPrediction(const Field& field, const PerSide<TeamSpec>& specs, double duration_s);

  // Whether the ball on the carpet stays away from every robot's hull and dribbler zone, from walls
  // and goals, and the robots from walls, goals and each other. Robots that touch or collide gently
  // are allowed: longer steps give the same result (tests/sim/contact_prediction_test.cpp). A ball
  // in ball placement collides with no robot, and a disabled robot with nothing. Returns false if
  // something is too fast for one Box2D step. `robots` is the bridge's number of robots.
  bool is_contact_free(const Box2dBridge& bodies, int robots, bool is_ball_held) const;

 private:
  double reach_m(const BodyState& body, double radius_m) const;
  bool keeps_off_walls(const Vec2& at_m, double reach_m) const;
  bool robots_keep_apart(const Box2dBridge& bodies, int robots) const;

  Field field_;
  double duration_s_;
  double margin_m_;             // around each body
  double dribbler_zone_m_ = 0;  // reach of kicker and dribbler in front of a plate
};

}  // namespace autoref::sim
