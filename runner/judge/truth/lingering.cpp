#include "runner/judge/truth/lingering.hpp"

namespace autoref::runner::truth {

// Whether the grace is over just now.
bool Lingering::Watch::is_over(double time_s, bool offends, double grace_s, int spell) {
  if (!offends) {
    since_s.reset();
    return false;
  }
  if (!since_s) since_s = time_s;
  if (told == spell || time_s - *since_s < grace_s) return false;
  told = spell;
  return true;
}

void Lingering::watch(const Scene& scene, int spell, RobotId id, const sim::RobotState& robot,
                      double excess, double grace_s, Happenings& all) {
  grace_s -= scene.frame_s / 2;  // pictures are whole frames apart
  Watches& watches = watches_[id.side][id.number];
  if (watches.spell != spell) watches = {spell, {}, {}, {}};
  Happening lingers{name_, scene.time_s, id.side, id, robot.position_m};
  watches.clearly.is_over(scene.time_s, excess > margin_, grace_s, spell);
  if (watches.truly.is_over(scene.time_s, excess > 0, grace_s, spell)) {
    lingers.is_borderline = watches.clearly.told != spell;
    all.push_back(lingers);
  } else if (watches.nearly.is_over(scene.time_s, excess > -margin_, grace_s, spell) &&
             watches.truly.told != spell) {
    lingers.standing = Standing::kNearMiss;
    all.push_back(lingers);
  }
}

}  // namespace autoref::runner::truth
