#include "sim/box2d_shapes.hpp"

#include "sim/box2d_bridge.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::sim::box2d {
namespace {

constexpr double kSkin_m = b2_polygonRadius / kUnitsPerMetre;  // Box2D's skin around polygons
constexpr double kWallThickness_m = 1_m;  // outer walls: thick enough to prevent tunnelling

b2FixtureDef fixture(const b2Shape& shape, const Surfaces& surfaces, std::uint16_t category,
                     int mask, float restitution) {
  b2FixtureDef definition;
  definition.shape = &shape;
  definition.friction = surfaces.friction;
  definition.restitution = restitution;
  definition.restitutionThreshold = surfaces.bounces_from;
  definition.filter.categoryBits = category;
  definition.filter.maskBits = static_cast<std::uint16_t>(mask);
  return definition;
}

// A box between two corners, including its skin.
b2PolygonShape box(const Vec2& low_m, const Vec2& high_m) {
  b2PolygonShape shape;
  const Vec2 half = (high_m - low_m) / 2.0 - Vec2(kSkin_m, kSkin_m);
  shape.SetAsBox(to_units(half.x()), to_units(half.y()), to_units(Vec2((low_m + high_m) / 2.0)),
                 0.0F);
  return shape;
}

void add_box(b2Body& ground, const Surfaces& surfaces, const Vec2& a_m, const Vec2& b_m,
             Category category, float restitution) {
  const b2PolygonShape shape = box(a_m.cwiseMin(b_m), a_m.cwiseMax(b_m));
  const b2FixtureDef definition = fixture(shape, surfaces, category, kRobots | kBall, restitution);
  ground.CreateFixture(&definition);
}

void set_mass(b2Body& body, double mass_kg, double inertia_kgm2) {
  b2MassData mass;
  mass.mass = static_cast<float>(mass_kg);
  mass.center.SetZero();
  mass.I = static_cast<float>(inertia_kgm2 * kUnitsPerMetre * kUnitsPerMetre);
  body.SetMassData(&mass);
}

}  // namespace

Surfaces::Surfaces(const ContactParameters& contacts)
    : robot(static_cast<float>(contacts.robot_restitution)),
      wall(static_cast<float>(contacts.wall_restitution)),
      net(static_cast<float>(contacts.net_restitution)),
      friction(static_cast<float>(contacts.friction)),
      bounces_from(to_units(contacts.least_bounce_mps)) {}

void add_end(b2Body& ground, const Surfaces& surfaces, const Field& field, double sign) {
  const double line = field.half_length_m();
  const double back = line + field.goal_depth_m;
  const double outside = back + field.goal_wall_thickness_m;
  const double inner = field.half_goal_m();
  const double outer = inner + field.goal_wall_thickness_m;
  // The other end of the field is this end rotated by 180 degrees, so each end also adds one of the
  // two long walls.
  const auto at = [sign](double x, double y) { return Vec2(sign * x, sign * y); };
  // The walls overlap at the corners, and no wall ends flush with another wall's face, because a
  // ball rolling along a wall would catch in the groove between two rounded edges.
  const double end =
      field.goal_sides_reach_wall ? field.wall_x_m() + kWallThickness_m / 2 : outside - kSkin_m;
  const double back_half = outer - kSkin_m;
  add_box(ground, surfaces, at(line, inner), at(end, outer), kGoals, surfaces.wall);
  add_box(ground, surfaces, at(line, -inner), at(end, -outer), kGoals, surfaces.wall);
  add_box(ground, surfaces, at(back, -back_half), at(outside, back_half), kGoals, surfaces.net);

  const double x = field.wall_x_m();
  const double y = field.wall_y_m();
  const double t = kWallThickness_m;
  add_box(ground, surfaces, at(x, -y - t), at(x + t, y + t), kWalls, surfaces.wall);
  add_box(ground, surfaces, at(-x - t, y), at(x + t, y + t), kWalls, surfaces.wall);
}

b2Body* add_robot(b2World& world, const Surfaces& surfaces, double mass_kg, int index) {
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.userData.pointer = static_cast<std::uintptr_t>(index) + 1;
  b2Body* body = world.CreateBody(&definition);
  b2CircleShape hull;
  hull.m_radius = to_units(kRobotRadius_m);
  const b2FixtureDef round =
      fixture(hull, surfaces, kRobots, kRobots | kBall | kWalls | kGoals, surfaces.robot);
  body->CreateFixture(&round);
  const b2PolygonShape front = box({0.0, -kHalfPlate_m}, {kFrontDistance_m, kHalfPlate_m});
  const b2FixtureDef plate = fixture(front, surfaces, kPlates, kBall, 0.0F);
  body->CreateFixture(&plate);
  set_mass(*body, mass_kg, robot_inertia_kgm2(mass_kg));
  return body;
}

b2Body* add_ball(b2World& world, const Surfaces& surfaces, double mass_kg) {
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  // A bullet in Box2D gets continuous collision detection against moving robots, too. Box2D does
  // not turn the ball, since ball.hpp models its spin.
  definition.bullet = true;
  definition.fixedRotation = true;
  b2Body* body = world.CreateBody(&definition);
  b2CircleShape shape;
  shape.m_radius = to_units(kBallRadius_m);
  // Box2D takes the larger restitution of two fixtures, so that of the wall or net applies. For
  // robots, the contact listener sets it.
  const b2FixtureDef round =
      fixture(shape, surfaces, kBall, kWalls | kGoals | kRobots | kPlates, 0.0F);
  body->CreateFixture(&round);
  set_mass(*body, mass_kg, 0.0);
  return body;
}

}  // namespace autoref::sim::box2d
