#include "strategies/plays/cast.hpp"

#include <algorithm>
#include <limits>

#include "soccer/robot_shape.hpp"

namespace autoref::strategies {
namespace {

constexpr int kTries = 4;

}  // namespace

int Cast::free_robots() const {
  int count = 0;
  for (int i = 0; i < outlook_->robots(); ++i) count += is_free(i) ? 1 : 0;
  return count;
}

void Cast::give(int index, Part part, const Waypoint& place) {
  if (index >= 0) tasks_[static_cast<std::size_t>(index)] = {part, place};
}

int Cast::nearest_free(const Vec2& place_m) const {
  int best = -1;
  double best2 = std::numeric_limits<double>::infinity();
  for (int i = 0; i < outlook_->robots(); ++i) {
    if (!is_free(i)) continue;
    const TrackedRobot& robot = outlook_->robot(i);
    const double d2 =
        (robot.position_m + robot.velocity_mps * outlook_->style().moves_on_s - place_m)
            .squaredNorm();
    if (d2 >= best2) continue;
    best2 = d2;
    best = i;
  }
  return best;
}

void Cast::spread() {
  const Limits limits = outlook_->limits();
  boost::container::static_vector<Vec2, kMaxRobots> taken_m;
  for (int i = 0; i < outlook_->robots(); ++i) {
    Task& task = tasks_[static_cast<std::size_t>(i)];
    if (task.part < Part::kReceiver) continue;
    Vec2& place_m = task.place.position_m;
    place_m = permitted_by_all(outlook_->field(), place_m, outlook_->place_m(), limits);
    for (int tries = 0; tries < kTries; ++tries) {
      const auto too_near = std::find_if(taken_m.begin(), taken_m.end(), [&](const Vec2& other_m) {
        return (other_m - place_m).squaredNorm() <
               (2 * kRobotRadius_m + outlook_->style().places_gap_m) *
                   (2 * kRobotRadius_m + outlook_->style().places_gap_m);
      });
      if (too_near == taken_m.end()) break;
      const Vec2 beside = left_of(direction_of(*too_near - outlook_->place_m(), Vec2(1, 0)));
      const Vec2 off = place_m - *too_near;
      const Vec2 away =
          direction_of(off + beside * (off.dot(beside) < 0 ? -outlook_->style().rather_beside_m
                                                           : outlook_->style().rather_beside_m),
                       beside);
      place_m = permitted_by_all(
          outlook_->field(),
          *too_near + away * ((2 * kRobotRadius_m + outlook_->style().places_gap_m) + 10_mm),
          outlook_->place_m(), limits);
    }
    taken_m.push_back(place_m);
  }
}

void Cast::send_nearest(const Waypoint& place) {
  give(nearest_free(place.position_m), Part::kStands, place);
}

}  // namespace autoref::strategies
