// The bodies' shapes, masses and surfaces, in Box2D's terms. For box2d_bridge.cpp alone.
#pragma once

#include <box2d/box2d.h>

#include <cstdint>

#include "sim/configuration.hpp"
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

// What a fixture is, for the filter of contacts.
enum Category : std::uint16_t { kRobots = 1, kPlates = 2, kBall = 4, kWalls = 8, kGoals = 16 };

// What fixtures are given of the contacts' parameters. Box2D takes a pair's greater restitution;
// that of a ball and a robot is decided at the contact.
struct Surfaces {
  explicit Surfaces(const ContactParameters& contacts);

  float robot;  // restitutions
  float wall;
  float net;
  float friction;
  float bounces_from;  // speed in units
};

// Walls and goal at the end where x has this sign. Made for one end and turned for the other.
void add_end(b2Body& ground, const Surfaces& surfaces, const Field& field, double sign);

// A robot without its plate. Its user data is `index` + 1.
b2Body* add_robot(b2World& world, const Surfaces& surfaces, double mass_kg, int index);
void set_robot_mass(b2Body& body, double mass_kg);
b2Fixture* add_plate(b2Body& robot, const Surfaces& surfaces);

b2Body* add_ball(b2World& world, const Surfaces& surfaces, double mass_kg);

}  // namespace autoref::sim::box2d
