#include "sim/world.hpp"

#include <cmath>

#include "sim/world_impl.hpp"

namespace autoref::sim {

World::World(const Field& field, const Configuration& configuration, const PerSide<TeamSpec>& specs,
             std::uint64_t seed) {
  validate(field);
  validate(configuration);
  validate(specs);
  impl_ = std::make_unique<Impl>(field, configuration, specs, seed);
}

World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

void World::step(const PerSide<TeamCommands>& commands, const std::optional<Placement>& placement) {
  impl_->step(commands, placement);
}

const WorldState& World::state() const { return impl_->state(); }
std::span<const Touch> World::touches() const { return impl_->touches(); }
std::span<const RobotCollision> World::collisions() const { return impl_->collisions(); }
void World::put_ball(const BallState& ball) { impl_->put_ball(ball); }
void World::put_robot(RobotId id, const RobotState& state) { impl_->put_robot(id, state); }

void World::take_off(RobotId id) { impl_->take_off(id); }
void World::put_on(RobotId id, const Vec2& position_m, const Vec2& heading) {
  impl_->put_on(id, {position_m, heading, Vec2(0, 0), 0.0});
}
bool World::is_on(RobotId id) const { return impl_->is_on(id); }
bool World::is_free(const Vec2& position_m) const { return impl_->is_free(position_m); }

bool World::is_finite() const {
  const WorldState& now = state();
  for (const auto& robots : now.robots.values) {
    for (const RobotState& robot : robots) {
      if (!autoref::is_finite(robot.position_m) || !autoref::is_finite(robot.heading) ||
          !autoref::is_finite(robot.velocity_mps) || !std::isfinite(robot.angular_velocity_radps)) {
        return false;
      }
    }
  }
  return autoref::is_finite(now.ball.position_m) && autoref::is_finite(now.ball.velocity_mps) &&
         std::isfinite(now.ball.height_m) && std::isfinite(now.ball.vertical_mps);
}

LatencySplit split_latency(const Configuration& configuration) {
  const double substeps =
      configuration.latency_s * configuration.frame_rate_hz * configuration.substeps;
  const int whole = static_cast<int>(std::lround(substeps));
  return {whole / configuration.substeps, whole % configuration.substeps};
}

}  // namespace autoref::sim
