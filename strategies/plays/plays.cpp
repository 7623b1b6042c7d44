#include "strategies/plays/plays.hpp"

#include <algorithm>
#include <limits>

#include "soccer/robot_shape.hpp"

namespace autoref::strategies {
namespace {

constexpr int kTries = 4;

}  // namespace

int RoleAssignment::free_robots() const {
  int count = 0;
  for (int i = 0; i < predicted_->robots(); ++i) count += is_free(i) ? 1 : 0;
  return count;
}

void RoleAssignment::give(int index, Role role, const Waypoint& waypoint) {
  if (index >= 0) tasks_[static_cast<std::size_t>(index)] = {role, waypoint};
}

int RoleAssignment::nearest_free(const Vec2& position_m) const {
  int best = -1;
  double best2 = std::numeric_limits<double>::infinity();
  for (int i = 0; i < predicted_->robots(); ++i) {
    if (!is_free(i)) continue;
    const TrackedRobot& robot = predicted_->robot(i);
    const double d2 =
        (robot.position_m + robot.velocity_mps * predicted_->style().moves_on_s - position_m)
            .squaredNorm();
    if (d2 >= best2) continue;
    best2 = d2;
    best = i;
  }
  return best;
}

// Robots with a lower index keep their positions. Each later robot moves away from the first
// position that it overlaps, and tries again a few times, since it may then overlap another robot.
void RoleAssignment::spread() {
  const Limits limits = predicted_->limits();
  boost::container::static_vector<Vec2, kMaxRobots> taken_m;
  for (int i = 0; i < predicted_->robots(); ++i) {
    Task& task = tasks_[static_cast<std::size_t>(i)];
    if (task.role < Role::kReceiver) continue;
    Vec2& position_m = task.waypoint.position_m;
    position_m =
        permitted_by_all(predicted_->field(), position_m, predicted_->position_m(), limits);
    for (int tries = 0; tries < kTries; ++tries) {
      const auto too_near = std::find_if(taken_m.begin(), taken_m.end(), [&](const Vec2& other_m) {
        return (other_m - position_m).squaredNorm() <
               (2 * kRobotRadius_m + predicted_->style().places_gap_m) *
                   (2 * kRobotRadius_m + predicted_->style().places_gap_m);
      });
      if (too_near == taken_m.end()) break;
      const Vec2 beside = left_of(direction_of(*too_near - predicted_->position_m(), Vec2(1, 0)));
      const Vec2 off = position_m - *too_near;
      const Vec2 away =
          direction_of(off + beside * (off.dot(beside) < 0 ? -predicted_->style().rather_beside_m
                                                           : predicted_->style().rather_beside_m),
                       beside);
      position_m = permitted_by_all(
          predicted_->field(),
          *too_near + away * ((2 * kRobotRadius_m + predicted_->style().places_gap_m) + 10_mm),
          predicted_->position_m(), limits);
    }
    taken_m.push_back(position_m);
  }
}

void RoleAssignment::send_nearest(const Waypoint& waypoint) {
  give(nearest_free(waypoint.position_m), Role::kStands, waypoint);
}

}  // namespace autoref::strategies
