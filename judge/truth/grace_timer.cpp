#include "judge/truth/grace_timer.hpp"

namespace autoref::judge::ground_truth {

// Returns true in the frame in which the grace period ends.
bool GraceTimer::Watch::is_over(double time_s, bool offends, double grace_s, int spell) {
  if (!offends) {
    since_s.reset();
    return false;
  }
  if (!since_s) since_s = time_s;
  if (reported == spell || time_s - *since_s < grace_s) return false;
  reported = spell;
  return true;
}

void GraceTimer::watch(const Scene& scene, RobotId id, const sim::RobotState& robot, double excess,
                       double grace_s, TrueEvents& all) {
  const int spell = scene.play.count;
  grace_s -= scene.frame_s / 2;  // half a frame of tolerance, since time is quantised to frames
  // Three timers per robot, for the limit and for the limit shifted by the margin either way: a
  // true event is borderline if the strict one has not expired, and there is a near miss if only
  // the lenient one has.
  Watches& watches = watches_[id.side][id.number];
  if (watches.spell != spell) watches = {spell, {}, {}, {}};
  TrueEvent is_due{name_, scene.time_s, id.side, id, robot.position_m};
  watches.clearly.is_over(scene.time_s, excess > margin_, grace_s, spell);
  if (watches.truly.is_over(scene.time_s, excess > 0, grace_s, spell)) {
    is_due.is_borderline = watches.clearly.reported != spell;
    all.push_back(is_due);
  } else if (watches.nearly.is_over(scene.time_s, excess > -margin_, grace_s, spell) &&
             watches.truly.reported != spell) {
    is_due.standing = Standing::kNearMiss;
    all.push_back(is_due);
  }
}

}  // namespace autoref::judge::ground_truth
