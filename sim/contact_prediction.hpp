// Whether physics may take a longer step, because nothing can meet anything before its end.
#pragma once

#include "sim/box2d_bridge.hpp"
#include "sim/configuration.hpp"
#include "soccer/field.hpp"
#include "soccer/geometry.hpp"

namespace autoref::sim {

// A look ahead over a stretch of `duration_s`. It takes everything to move on as it does; what
// the limits of acceleration let a robot stray from that is allowed for.
class ContactPrediction {
 public:
  ContactPrediction(const Field& field, const PerSide<TeamSpec>& specs, double duration_s);

  // Whether the ball on the carpet stays away from every robot's hull and mouth, from walls and
  // goals, and the robots from walls, goals and each other. Robots that touch or meet gently do no
  // harm: longer steps show the same (tests/sim/contact_prediction_test.cpp). A ball in ball
  // placement meets no robot, and a robot that is off meets nothing. What is too fast for one step
  // of Box2D is not calm. `robots` counts those of the bridge.
  bool is_contact_free(const Box2dBridge& bodies, int robots, bool is_ball_held) const;

 private:
  double reach_m(const BodyState& body, double radius_m) const;
  bool keeps_off_walls(const Vec2& at_m, double reach_m) const;
  bool robots_keep_apart(const Box2dBridge& bodies, int robots) const;

  Field field_;
  double duration_s_;
  double margin_m_;             // around each body
  double dribbler_zone_m_ = 0;  // how far before a plate kicker and dribbler reach
};

}  // namespace autoref::sim
