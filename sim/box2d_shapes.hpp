// The bodies' shapes, masses and surfaces in Box2D's terms. Only for box2d_bridge.cpp.
#pragma once

#include <box2d/box2d.h>

#include <cstdint>

#include "sim/sim_configuration.hpp"
#include "soccer/field.hpp"
#include "soccer/geometry.hpp"

namespace autoref::sim::box2d {

// Box2D's tolerances fit objects of 0.1 to 10 units.
inline constexpr double kUnitsPerMetre = 10.0;

constexpr float to_units(double metres) { return static_cast<float>(metres * kUnitsPerMetre); }
inline b2Vec2 to_units(const Vec2& v) { return {to_units(v.x()), to_units(v.y())}; }
inline Vec2 from_units(const b2Vec2& v) {
  return {static_cast<double>(v.x) / kUnitsPerMetre, static_cast<double>(v.y) / kUnitsPerMetre};
}

// Category of a fixture, for contact filtering.
enum Category : std::uint16_t { kRobots = 1, kPlates = 2, kBall = 4, kWalls = 8, kGoals = 16 };

// The contact parameters of fixtures. For a pair of fixtures, Box2D uses the greater restitution;
// for a ball and a robot, the contact listener sets the restitution.
struct Surfaces {
  explicit Surfaces(const ContactParameters& contacts);

  float robot;  // restitution coefficients
  float wall;
  float net;
  float friction;
  float bounces_from;  // minimum closing speed at which bodies bounce, in units per second
};

// Adds the walls and the goal at the end of the field where x has the given sign. Shapes are built
// for one end and rotated for the other.
void add_end(b2Body& ground, const Surfaces& surfaces, const Field& field, double sign);

// Adds a robot: a round hull, and a front plate that only the ball collides with. Its user data is
// `index` + 1.
b2Body* add_robot(b2World& world, const Surfaces& surfaces, double mass_kg, int index);

b2Body* add_ball(b2World& world, const Surfaces& surfaces, double mass_kg);

}  // namespace autoref::sim::box2d
