#include "runner/truth/lingering.hpp"

namespace autoref::runner::truth {

// Whether the grace is over just now.
bool Lingering::Watch::is_over(double time_s, bool offends, double grace_s, int count) {
  if (!offends) {
    since_s.reset();
    return false;
  }
  if (!since_s) since_s = time_s;
  if (told == count || time_s - *since_s < grace_s) return false;
  told = count;
  return true;
}

void Lingering::watch(const Scene& scene, RobotId id, const sim::RobotState& robot, double excess,
                      double grace_s, Happenings& all) {
  grace_s -= scene.frame_s / 2;  // pictures are whole frames apart
  Watches& watches = watches_[id];
  const int count = scene.play.stops;
  if (watches.count != count) watches = {count, {}, {}, {}};
  Happening lingers{name_, scene.time_s, id.side, id, robot.position_m};
  watches.clearly.is_over(scene.time_s, excess > margin_, grace_s, count);
  if (watches.truly.is_over(scene.time_s, excess > 0, grace_s, count)) {
    lingers.is_borderline = watches.clearly.told != count;
    all.push_back(lingers);
  } else if (watches.nearly.is_over(scene.time_s, excess > -margin_, grace_s, count) &&
             watches.truly.told != count) {
    lingers.standing = Standing::kNearMiss;
    all.push_back(lingers);
  }
}

}  // namespace autoref::runner::truth
