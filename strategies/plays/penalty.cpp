#include "strategies/tactics/penalty.hpp"

#include "strategies/plays/plays.hpp"

namespace autoref::strategies {

// Until the ball is in play only kicker and keeper count; the others wait behind it.
void penalty(Playbook& book, Cast& cast) {
  const Outlook& outlook = book.outlook;
  const Vec2& mark_m = outlook.place_m();
  const bool ours = outlook.now().ours;
  const int kicker = ours ? penalty_kicker(outlook.now(), mark_m) : -1;
  if (kicker >= 0 && outlook.now().play == Play::kPenalty) {
    cast.give(kicker, Part::kBall);
  } else {
    cast.give(kicker, Part::kStands, penalty_run_up(mark_m));
  }
  for (int i = 0; i < outlook.robots(); ++i) {
    if (!cast.is_free(i)) continue;
    const Waypoint place =
        i == 0 ? penalty_keeper(outlook.field(), mark_m)
               : penalty_spectator(outlook.field(), mark_m, outlook.rules().penalty_clearance_m,
                                   ours, i - 1);
    cast.give(i, Part::kStands, place);
  }
}

}  // namespace autoref::strategies
