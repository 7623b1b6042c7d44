#include "sim/box2d_bridge.hpp"

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <cstdint>

#include "sim/box2d_shapes.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"

// Box2D reads the clock many times per step to profile itself, which takes about 40 % of the step
// (measured). These definitions, which stop the clock, override those in the shared library.
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

// The number of further calls of gather() for which a body stays in Box2D although nothing is near
// it.
constexpr int kLingers = 12;

// A fast heading_of() for the turn in one step; it is accurate to 1e-14 for up to 0.1 rad.
Vec2 small_turn(double angle_rad) {
  if (std::abs(angle_rad) > 0.1) return heading_of(angle_rad);
  const double s = angle_rad * angle_rad;
  return {1.0 - s * (1.0 / 2.0 - s * (1.0 / 24.0 - s * (1.0 / 720.0 - s * (1.0 / 40320.0)))),
          angle_rad * (1.0 - s * (1.0 / 6.0 - s * (1.0 / 120.0 - s * (1.0 / 5040.0))))};
}

// Decides and records the effect of contacts between ball and robots.
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
  std::uint32_t dribbling = 0;  // robots whose dribbler is running, one bit per robot

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

  // In front of the plate, the round hull is cut off. There, in the wedge from the centre through
  // the plate's two corners, only the plate collides.
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
  b2Body* ball = nullptr;
};

Box2dBridge::Box2dBridge(const Field& field, const ContactParameters& contacts, double ball_mass_kg,
                         std::span<const double> masses_kg)
    : bodies_(std::make_unique<Bodies>(contacts)), count_(static_cast<int>(masses_kg.size())) {
  b2World& world = bodies_->world;
  world.SetContactListener(&bodies_->contacts);
  const b2BodyDef still;
  b2Body* ground = world.CreateBody(&still);
  for (const Side side : kSides) add_end(*ground, bodies_->surfaces, field, goal_sign(side));
  for (int i = 0; i < count_; ++i) {
    const auto index = static_cast<std::size_t>(i);
    inverse_masses_[index] = 1.0 / masses_kg[index];
    bodies_->robots[index] = add_robot(world, bodies_->surfaces, masses_kg[index], i);
    enabled_.add_robot(i);
  }
  bodies_->ball = add_ball(world, bodies_->surfaces, ball_mass_kg);
  enabled_.ball = true;
  gathered_ = enabled_;
  moved_ = enabled_;
}

Box2dBridge::~Box2dBridge() = default;

void Box2dBridge::place_robot(int index, const BodyState& state) {
  robots_[static_cast<std::size_t>(index)] = state;
  moved_.add_robot(index);
}

void Box2dBridge::place_ball(const Vec2& position_m, const Vec2& velocity_mps) {
  ball_.position_m = position_m;
  ball_.velocity_mps = velocity_mps;
  moved_.ball = true;
}

void Box2dBridge::set_on(int index, bool is_on) {
  const std::uint32_t bit = 1U << index;
  off_ = is_on ? off_ & ~bit : off_ | bit;
  BodyState& state = robots_[static_cast<std::size_t>(index)];
  state.velocity_mps.setZero();
  state.angular_velocity_radps = 0.0;
  moved_.add_robot(index);
  enable_robot(index, is_on);
}

void Box2dBridge::enable_robot(int index, bool is_enabled) {
  const std::uint32_t bit = 1U << index;
  enabled_.robots = is_enabled ? enabled_.robots | bit : enabled_.robots & ~bit;
  bodies_->robots[static_cast<std::size_t>(index)]->SetEnabled(is_enabled);
}

const BodySet& Box2dBridge::gather(const BodySet& bodies) {
  for (int i = 0; i < count_; ++i) {
    int& idle = idle_[static_cast<std::size_t>(i)];
    idle = bodies.has_robot(i) ? 0 : idle + 1;
    if (idle == 0 && !enabled_.has_robot(i)) enable_robot(i, true);
    if (idle > kLingers && enabled_.has_robot(i)) enable_robot(i, false);
  }
  ball_idle_ = bodies.ball ? 0 : ball_idle_ + 1;
  const bool keeps_ball = bodies.ball || (enabled_.ball && ball_idle_ <= kLingers);
  if (keeps_ball != enabled_.ball) bodies_->ball->SetEnabled(keeps_ball);
  enabled_.ball = keeps_ball;
  gathered_ = bodies.is_empty() ? BodySet{} : enabled_;
  return gathered_;
}

void Box2dBridge::push_robot(int index, const Vec2& force_n, double torque_nm) {
  Push& push = pushes_[static_cast<std::size_t>(index)];
  push.half_force_n = force_n / 2.0;
  push.half_torque_nm = torque_nm / 2.0;
}

void Box2dBridge::push_robot_at(int index, const Vec2& force_n, const Vec2& point_m) {
  Push& push = pushes_[static_cast<std::size_t>(index)];
  push.force_n += force_n;
  push.torque_nm += cross(point_m - robot(index).position_m, force_n);
}

void Box2dBridge::strike_robot(int index, const Vec2& impulse_ns) {
  robots_[static_cast<std::size_t>(index)].velocity_mps += inverse_mass(index) * impulse_ns;
  moved_.add_robot(index);
}

void Box2dBridge::set_ball_velocity(const Vec2& velocity_mps) { ball_.velocity_mps = velocity_mps; }

void Box2dBridge::let_ball_meet(bool robots, bool goals) {
  b2Fixture* ball = bodies_->ball->GetFixtureList();
  b2Filter filter = ball->GetFilterData();
  const int mask = kWalls | (robots ? kRobots | kPlates : 0) | (goals ? kGoals : 0);
  // This is skipped if nothing changes, because a new filter makes Box2D check all of the ball's
  // contacts again.
  if (filter.maskBits == mask) return;
  filter.maskBits = static_cast<std::uint16_t>(mask);
  ball->SetFilterData(filter);
}

void Box2dBridge::set_dribbling(int index, bool dribbles) {
  const std::uint32_t bit = 1U << index;
  std::uint32_t& all = bodies_->contacts.dribbling;
  all = dribbles ? all | bit : all & ~bit;
}

void Box2dBridge::move_free_robots(double duration_s) {
  for (int i = 0; i < count_; ++i) {
    if (is_on(i) && !gathered_.has_robot(i)) move_freely(i, duration_s);
  }
}

// Box2D moves a body that hits nothing in the same way, at its speed after the forces have acted.
void Box2dBridge::move_freely(int index, double duration_s) {
  BodyState& state = robots_[static_cast<std::size_t>(index)];
  const Push& push = pushes_[static_cast<std::size_t>(index)];
  const double per_mass = duration_s * inverse_mass(index);
  const double per_inertia = duration_s * inverse_inertia(index);
  state.velocity_mps += per_mass * (push.half_force_n + push.force_n);
  state.angular_velocity_radps += per_inertia * (push.half_torque_nm + push.torque_nm);
  state.position_m += duration_s * state.velocity_mps;
  state.heading = to_world(small_turn(duration_s * state.angular_velocity_radps), state.heading);
  finish_push(index, duration_s);
  moved_.add_robot(index);
}

// Applies the second half of a push after the motion, so the robot has moved at the mean of the
// speeds before and after the push.
void Box2dBridge::finish_push(int index, double duration_s) {
  BodyState& state = robots_[static_cast<std::size_t>(index)];
  Push& push = pushes_[static_cast<std::size_t>(index)];
  state.velocity_mps += duration_s * inverse_mass(index) * push.half_force_n;
  state.angular_velocity_radps += duration_s * inverse_inertia(index) * push.half_torque_nm;
  push = Push{};
}

void Box2dBridge::step(double duration_s) {
  bodies_->contacts.touching.clear();
  bodies_->contacts.collisions.clear();
  if (!gathered_.is_empty()) step_box2d(duration_s);
  if (!gathered_.ball) {
    ball_.position_m += duration_s * ball_.velocity_mps;
    moved_.ball = true;
  }
}

void Box2dBridge::step_box2d(double duration_s) {
  for (int i = 0; i < count_; ++i) {
    if (gathered_.has_robot(i)) give_robot(i);
  }
  if (gathered_.ball) give_ball();
  bodies_->world.Step(static_cast<float>(duration_s), kVelocityIterations, kPositionIterations);
  for (int i = 0; i < count_; ++i) {
    if (gathered_.has_robot(i)) take_robot(i, duration_s);
  }
  if (gathered_.ball) take_ball();
}

void Box2dBridge::give_robot(int index) {
  const auto i = static_cast<std::size_t>(index);
  const BodyState& state = robots_[i];
  const Push& push = pushes_[i];
  b2Body& body = *bodies_->robots[i];
  if (moved_.has_robot(index)) {
    moved_.robots &= ~(1U << index);
    body.SetTransform(to_units(state.position_m), static_cast<float>(angle_of(state.heading)));
  }
  // The second half of the last push has changed the velocity since Box2D saw it.
  body.SetLinearVelocity(to_units(state.velocity_mps));
  body.SetAngularVelocity(static_cast<float>(state.angular_velocity_radps));
  const Vec2 force_n = push.half_force_n + push.force_n;
  const double torque_nm = push.half_torque_nm + push.torque_nm;
  if (force_n.isZero(0.0) && torque_nm == 0.0) return;  // a robot at rest may sleep
  body.ApplyForceToCenter(to_units(force_n), true);
  body.ApplyTorque(static_cast<float>(torque_nm * kUnitsPerMetre * kUnitsPerMetre), true);
}

void Box2dBridge::give_ball() {
  if (moved_.ball) bodies_->ball->SetTransform(to_units(ball_.position_m), 0.0F);
  moved_.ball = false;
  bodies_->ball->SetLinearVelocity(to_units(ball_.velocity_mps));
}

void Box2dBridge::take_robot(int index, double duration_s) {
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
  finish_push(index, duration_s);
}

void Box2dBridge::take_ball() {
  ball_.position_m = from_units(bodies_->ball->GetPosition());
  ball_.velocity_mps = from_units(bodies_->ball->GetLinearVelocity());
}

std::span<const int> Box2dBridge::touching() const {
  return {bodies_->contacts.touching.data(), bodies_->contacts.touching.size()};
}

std::span<const BodyCollision> Box2dBridge::collisions() const {
  return {bodies_->contacts.collisions.data(), bodies_->contacts.collisions.size()};
}

}  // namespace autoref::sim
