#include "benchmarks/bare_box2d_benchmark.hpp"

#include <box2d/box2d.h>

#include <array>

#include "soccer/random.hpp"
#include "soccer/trigonometry.hpp"
#include "soccer/units.hpp"

namespace autoref::benchmarks {
namespace {

constexpr float kScale = 10.0F;  // units per metre
constexpr int kBareRobots = 12;
constexpr int kStepsPerFrame = 4;
constexpr float kStep_s = 1.0F / 240.0F;
constexpr float kHalfLength_m = 4.5F;
constexpr float kHalfWidth_m = 3.0F;
constexpr float kHalfGoal_m = 0.5F;
constexpr float kGoalDepth_m = 0.18F;
constexpr float kRobotSpeed_mps = 2.5F;
constexpr float kReached_m = 0.15F;  // distance at which a target or the ball counts as reached
constexpr float kKick_mps = 6.0F;

b2Vec2 units(float x_m, float y_m) { return {x_m * kScale, y_m * kScale}; }

// A disc of radius 90 mm with its front cut off flat at 75 mm, approximated by the eight vertices
// that Box2D allows.
b2PolygonShape robot_shape() {
  constexpr double kFrontCorner_rad = 0.58568554;  // acos(75 / 90)
  constexpr double kArc_rad = 2 * (kPi - kFrontCorner_rad);
  std::array<b2Vec2, 8> vertices;
  for (int i = 0; i < 8; ++i) {
    const auto [s, c] = sin_cos(kFrontCorner_rad + kArc_rad * i / 7);
    vertices[i] = units(0.09F * static_cast<float>(c), 0.09F * static_cast<float>(s));
  }
  b2PolygonShape shape;
  shape.Set(vertices.data(), 8);
  return shape;
}

}  // namespace

class BareBox2dBenchmark::Impl {
 public:
  explicit Impl(std::uint64_t seed) : world_(b2Vec2(0, 0)), random_(seed) {
    add_edges();
    for (int i = 0; i < kBareRobots; ++i) add_robot(i);
    add_ball();
  }

  void step_frame() {
    for (int i = 0; i < kBareRobots; ++i) drive(i);
    if (is_out(ball_->GetPosition())) place_ball_at_centre();
    for (int i = 0; i < kStepsPerFrame; ++i) world_.Step(kStep_s, 8, 3);
  }

  double checksum_m() const {
    double sum = ball_->GetPosition().x;
    for (const b2Body* robot : robots_) sum += robot->GetPosition().x * robot->GetPosition().y;
    return sum / kScale;
  }

 private:
  void add_edge(b2Body& ground, const b2Vec2& from, const b2Vec2& to) {
    b2EdgeShape shape;
    shape.SetTwoSided(from, to);
    ground.CreateFixture(&shape, 0);
  }

  // Four walls, and two goals of three edges each.
  void add_edges() {
    const b2BodyDef definition;
    b2Body& ground = *world_.CreateBody(&definition);
    const float x = kHalfLength_m + 0.7F;
    const float y = kHalfWidth_m + 0.7F;
    add_edge(ground, units(-x, -y), units(x, -y));
    add_edge(ground, units(x, -y), units(x, y));
    add_edge(ground, units(x, y), units(-x, y));
    add_edge(ground, units(-x, y), units(-x, -y));
    for (const float sign : {-1.0F, 1.0F}) {
      const float front = sign * kHalfLength_m;
      const float back = sign * (kHalfLength_m + kGoalDepth_m);
      add_edge(ground, units(front, kHalfGoal_m), units(back, kHalfGoal_m));
      add_edge(ground, units(back, kHalfGoal_m), units(back, -kHalfGoal_m));
      add_edge(ground, units(back, -kHalfGoal_m), units(front, -kHalfGoal_m));
    }
  }

  void add_robot(int i) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = units(-3.3F + 0.6F * static_cast<float>(i), i % 2 == 0 ? 1.0F : -1.0F);
    robots_[i] = world_.CreateBody(&definition);
    const b2PolygonShape shape = robot_shape();
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.density = 1.0F;
    fixture.friction = 0.22F;
    fixture.restitution = 0.2F;
    robots_[i]->CreateFixture(&fixture);
    targets_[i] = random_point();
  }

  void add_ball() {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.bullet = true;
    definition.linearDamping = 0.3F;
    ball_ = world_.CreateBody(&definition);
    b2CircleShape shape;
    shape.m_radius = 0.0215F * kScale;
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.density = 0.3F;
    fixture.restitution = 0.5F;
    ball_->CreateFixture(&fixture);
  }

  b2Vec2 random_point() {
    const auto x = static_cast<float>(2 * random_.uniform() - 1);
    const auto y = static_cast<float>(2 * random_.uniform() - 1);
    return units(x * kHalfLength_m, y * kHalfWidth_m);
  }

  void drive(int i) {
    b2Body& robot = *robots_[i];
    b2Vec2 direction = targets_[i] - robot.GetPosition();
    if (direction.Normalize() < kReached_m * kScale) targets_[i] = random_point();
    robot.SetLinearVelocity(kRobotSpeed_mps * kScale * direction);
    robot.SetAngularVelocity(i % 2 == 0 ? 2.0F : -2.0F);
    if (b2Distance(robot.GetPosition(), ball_->GetPosition()) < kReached_m * kScale) kick();
  }

  static bool is_out(const b2Vec2& p) {
    return b2Abs(p.x) > kHalfLength_m * kScale || b2Abs(p.y) > kHalfWidth_m * kScale;
  }

  // Called when the ball leaves the field, where no robot could reach it.
  void place_ball_at_centre() {
    ball_->SetTransform(b2Vec2(0, 0), 0);
    ball_->SetLinearVelocity(b2Vec2(0, 0));
  }

  void kick() {
    b2Vec2 direction = random_point() - ball_->GetPosition();
    direction.Normalize();
    ball_->SetLinearVelocity(kKick_mps * kScale * direction);
  }

  b2World world_;
  RandomStream random_;
  std::array<b2Body*, kBareRobots> robots_{};
  std::array<b2Vec2, kBareRobots> targets_{};
  b2Body* ball_ = nullptr;
};

BareBox2dBenchmark::BareBox2dBenchmark(std::uint64_t seed) : impl_(std::make_unique<Impl>(seed)) {}
BareBox2dBenchmark::~BareBox2dBenchmark() = default;
void BareBox2dBenchmark::step_frame() { impl_->step_frame(); }
double BareBox2dBenchmark::checksum_m() const { return impl_->checksum_m(); }

}  // namespace autoref::benchmarks
