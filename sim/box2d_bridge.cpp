#include "sim/box2d_bridge.hpp"

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <cstdint>

#include "sim/box2d_shapes.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"

// Box2D reads the clock many times per step to profile itself, which takes about 40 % of the step
// (measured). These definitions of a stopped clock override the shared library's.
b2Timer::b2Timer() { Reset(); }
void b2Timer::Reset() {
  m_start_sec = 0;
  m_start_usec = 0;
}
float b2Timer::GetMilliseconds() const { return 0.0F; }

namespace autoref::sim {
namespace {

using namespace box2d;

static_assert(b2_maxTranslation == to_units(kLongestStep_m));

// Box2D's recommended values.
constexpr int kVelocityIterations = 8;
constexpr int kPositionIterations = 3;

// Only the ball collides with plates, and giving every robot one costs a quarter of a step's time.
// So a robot has a plate only while the ball is near enough to reach it in a step of 1/60 s. The
// two thresholds form a hysteresis: a ball at the limit does not toggle the plate.
constexpr double kPlateOn_m = 350_mm;
constexpr double kPlateOff_m = 500_mm;

// Decides and records what a contact between ball and robot does.
class BallContacts final : public b2ContactListener {
 public:
  explicit BallContacts(const ContactParameters& parameters)
      : body_(static_cast<float>(parameters.body_restitution)),
        plate_(static_cast<float>(parameters.plate_restitution)),
        dribbling_plate_(static_cast<float>(parameters.dribbling_restitution)) {}

  // Box2D calls this before it solves a touching contact, so the restitution can depend on the part
  // of the robot that is touched and on its dribbler.
  void PreSolve(b2Contact* contact, const b2Manifold* /*old*/) override {
    b2Fixture* a = contact->GetFixtureA();
    b2Fixture* b = contact->GetFixtureB();
    if (b->GetFilterData().categoryBits != kBall) std::swap(a, b);
    if (b->GetFilterData().categoryBits != kBall) return;
    b2Body& robot = *a->GetBody();
    if (robot.GetType() != b2_dynamicBody) return;
    meet(*contact, a->GetFilterData().categoryBits == kPlates, robot, *b->GetBody());
  }

  // Called before the step moves anything or solves any contact.
  void BeginContact(b2Contact* contact) override {
    b2Fixture& a = *contact->GetFixtureA();
    b2Fixture& b = *contact->GetFixtureB();
    if (a.GetFilterData().categoryBits != kRobots || b.GetFilterData().categoryBits != kRobots) {
      return;
    }
    if (collisions.size() == collisions.capacity()) return;
    collisions.push_back(collision(*a.GetBody(), *b.GetBody()));
  }

  boost::container::static_vector<int, 2 * kMaxRobots> touching;
  boost::container::static_vector<BodyCollision, 64> collisions;
  std::uint32_t dribbling = 0;  // one bit per robot

 private:
  static int index_of(b2Body& robot) { return static_cast<int>(robot.GetUserData().pointer) - 1; }

  static BodyCollision collision(b2Body& a, b2Body& b) {
    const bool in_order = index_of(a) < index_of(b);
    b2Body& one = in_order ? a : b;
    b2Body& other = in_order ? b : a;
    return {{index_of(one), index_of(other)},
            {from_units(one.GetLinearVelocity()), from_units(other.GetLinearVelocity())},
            {from_units(one.GetPosition()), from_units(other.GetPosition())}};
  }

  // In front of the plate the round hull is cut off, so only the plate collides there, in the
  // wedge from the centre through the plate's two corners.
  static bool is_before_plate(const b2Body& robot, const b2Body& ball) {
    const b2Vec2 p = robot.GetLocalPoint(ball.GetPosition());
    return p.x > 0.0F && std::abs(p.y) * to_units(kFrontDistance_m) < p.x * to_units(kHalfPlate_m);
  }

  void meet(b2Contact& contact, bool is_plate, b2Body& robot, const b2Body& ball) {
    if (!is_plate && is_before_plate(robot, ball)) {
      contact.SetEnabled(false);
      return;
    }
    const int index = index_of(robot);
    const bool dribbles = ((dribbling >> index) & 1U) != 0;
    contact.SetRestitution(!is_plate ? body_ : dribbles ? dribbling_plate_ : plate_);
    if (std::find(touching.begin(), touching.end(), index) == touching.end()) {
      touching.push_back(index);
    }
  }

  // Restitution coefficients.
  float body_;
  float plate_;
  float dribbling_plate_;
};

}  // namespace

double robot_inertia_kgm2(double mass_kg) {
  return mass_kg * kRobotRadius_m * kRobotRadius_m / 2.0;
}

struct Box2dBridge::Bodies {
  explicit Bodies(const ContactParameters& parameters)
      : contacts(parameters), surfaces(parameters) {}

  b2World world{b2Vec2_zero};
  BallContacts contacts;
  Surfaces surfaces;
  std::array<b2Body*, 2 * kMaxRobots> robots{};
  std::array<b2Fixture*, 2 * kMaxRobots> plates{};  // set for robots near the ball
  // The second half of each push_robot force, applied after the step: Box2D moves a body at its
  // speed at the end of the step (semi-implicit Euler).
  std::array<b2Vec2, 2 * kMaxRobots> half_forces;
  std::array<float, 2 * kMaxRobots> half_torques{};
  b2Body* ball = nullptr;
};

Box2dBridge::Box2dBridge(const Field& field, const ContactParameters& contacts, double ball_mass_kg,
                         std::span<const double> masses_kg)
    : bodies_(std::make_unique<Bodies>(contacts)),
      masses_kg_(masses_kg.begin(), masses_kg.end()),
      count_(static_cast<int>(masses_kg.size())) {
  bodies_->half_forces.fill(b2Vec2_zero);
  b2World& world = bodies_->world;
  world.SetContactListener(&bodies_->contacts);
  const b2BodyDef still;
  b2Body* ground = world.CreateBody(&still);
  for (const Side side : kSides) add_end(*ground, bodies_->surfaces, field, goal_sign(side));
  for (int i = 0; i < count_; ++i) {
    const auto index = static_cast<std::size_t>(i);
    bodies_->robots[index] = add_robot(world, bodies_->surfaces, masses_kg_[index], i);
  }
  bodies_->ball = add_ball(world, bodies_->surfaces, ball_mass_kg);
}

Box2dBridge::~Box2dBridge() = default;

void Box2dBridge::place_robot(int index, const BodyState& state) {
  b2Body* body = bodies_->robots[static_cast<std::size_t>(index)];
  body->SetTransform(to_units(state.position_m), static_cast<float>(angle_of(state.heading)));
  body->SetLinearVelocity(to_units(state.velocity_mps));
  body->SetAngularVelocity(static_cast<float>(state.angular_velocity_radps));
  read_robot(index);
}

void Box2dBridge::place_ball(const Vec2& position_m, const Vec2& velocity_mps) {
  bodies_->ball->SetTransform(to_units(position_m), 0.0F);
  set_ball_velocity(velocity_mps);
}

void Box2dBridge::set_on(int index, bool is_on) {
  const std::uint32_t bit = 1U << index;
  off_ = is_on ? off_ & ~bit : off_ | bit;
  b2Body* body = bodies_->robots[static_cast<std::size_t>(index)];
  body->SetLinearVelocity(b2Vec2_zero);
  body->SetAngularVelocity(0.0F);
  body->SetEnabled(is_on);
  read_robot(index);
}

void Box2dBridge::push_robot(int index, const Vec2& force_n, double torque_nm) {
  if (force_n.isZero(0.0) && torque_nm == 0.0) return;  // a robot at rest may sleep
  const auto i = static_cast<std::size_t>(index);
  bodies_->half_forces[i] = 0.5F * to_units(force_n);
  bodies_->half_torques[i] = static_cast<float>(torque_nm * kUnitsPerMetre * kUnitsPerMetre / 2);
  bodies_->robots[i]->ApplyForceToCenter(bodies_->half_forces[i], true);
  bodies_->robots[i]->ApplyTorque(bodies_->half_torques[i], true);
}

void Box2dBridge::push_robot_at(int index, const Vec2& force_n, const Vec2& point_m) {
  bodies_->robots[static_cast<std::size_t>(index)]->ApplyForce(to_units(force_n), to_units(point_m),
                                                               true);
}

void Box2dBridge::strike_robot(int index, const Vec2& impulse_ns) {
  bodies_->robots[static_cast<std::size_t>(index)]->ApplyLinearImpulseToCenter(to_units(impulse_ns),
                                                                               true);
  read_robot(index);
}

void Box2dBridge::set_ball_velocity(const Vec2& velocity_mps) {
  bodies_->ball->SetLinearVelocity(to_units(velocity_mps));
  read_ball();
}

void Box2dBridge::let_ball_meet(bool robots, bool goals) {
  b2Fixture* ball = bodies_->ball->GetFixtureList();
  b2Filter filter = ball->GetFilterData();
  const int mask = kWalls | (robots ? kRobots | kPlates : 0) | (goals ? kGoals : 0);
  // Skipped if nothing changes: a new filter makes Box2D check all of the ball's contacts again.
  if (filter.maskBits == mask) return;
  filter.maskBits = static_cast<std::uint16_t>(mask);
  ball->SetFilterData(filter);
}

void Box2dBridge::set_dribbling(int index, bool dribbles) {
  const std::uint32_t bit = 1U << index;
  std::uint32_t& all = bodies_->contacts.dribbling;
  all = dribbles ? all | bit : all & ~bit;
}

void Box2dBridge::fit_plates() {
  for (int i = 0; i < count_; ++i) {
    const auto index = static_cast<std::size_t>(i);
    b2Fixture*& plate = bodies_->plates[index];
    const double apart2_m2 = (robot(i).position_m - ball_.position_m).squaredNorm();
    b2Body& body = *bodies_->robots[index];
    if (plate == nullptr && apart2_m2 < kPlateOn_m * kPlateOn_m) {
      plate = add_plate(body, bodies_->surfaces);
    } else if (plate != nullptr && apart2_m2 > kPlateOff_m * kPlateOff_m) {
      body.DestroyFixture(plate);
      plate = nullptr;
      set_robot_mass(body, masses_kg_[index]);  // Box2D has just recomputed it from the fixtures
    }
  }
}

void Box2dBridge::step(double duration_s) {
  fit_plates();
  bodies_->contacts.touching.clear();
  bodies_->contacts.collisions.clear();
  bodies_->world.Step(static_cast<float>(duration_s), kVelocityIterations, kPositionIterations);
  for (int i = 0; i < count_; ++i) {
    push_on(i, static_cast<float>(duration_s));
    read_robot(i);
  }
  read_ball();
}

// Applies the second half of a push after the step has moved the robot.
void Box2dBridge::push_on(int index, float duration_s) {
  const auto i = static_cast<std::size_t>(index);
  b2Vec2& force = bodies_->half_forces[i];
  float& torque = bodies_->half_torques[i];
  if (force == b2Vec2_zero && torque == 0.0F) return;
  bodies_->robots[i]->ApplyLinearImpulseToCenter(duration_s * force, true);
  bodies_->robots[i]->ApplyAngularImpulse(duration_s * torque, true);
  force.SetZero();
  torque = 0.0F;
}

std::span<const int> Box2dBridge::touching() const {
  return {bodies_->contacts.touching.data(), bodies_->contacts.touching.size()};
}

std::span<const BodyCollision> Box2dBridge::collisions() const {
  return {bodies_->contacts.collisions.data(), bodies_->contacts.collisions.size()};
}

void Box2dBridge::read_robot(int index) {
  b2Body* body = bodies_->robots[static_cast<std::size_t>(index)];
  // A float angle loses precision as it grows.
  if (std::abs(body->GetAngle()) > 16.0F) {
    const double angle_rad = wrap_angle(static_cast<double>(body->GetAngle()));
    body->SetTransform(body->GetPosition(), static_cast<float>(angle_rad));
  }
  BodyState& state = robots_[static_cast<std::size_t>(index)];
  const b2Transform& pose = body->GetTransform();
  state.position_m = from_units(pose.p);
  state.heading = {static_cast<double>(pose.q.c), static_cast<double>(pose.q.s)};
  state.velocity_mps = from_units(body->GetLinearVelocity());
  state.angular_velocity_radps = static_cast<double>(body->GetAngularVelocity());
}

void Box2dBridge::read_ball() {
  ball_.position_m = from_units(bodies_->ball->GetPosition());
  ball_.velocity_mps = from_units(bodies_->ball->GetLinearVelocity());
}

}  // namespace autoref::sim
