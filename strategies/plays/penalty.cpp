#include "strategies/tactics/penalty.hpp"

#include "strategies/plays/plays.hpp"

namespace autoref::strategies {

// Until the ball is in play, only kicker and keeper matter; the other robots wait behind the ball.
void penalty(PlayContext& book, RoleAssignment& assignment) {
  const PredictedState& predicted = book.predicted;
  const Vec2& mark_m = predicted.position_m();
  const bool is_attacking = predicted.now().ours;
  const int kicker = is_attacking ? penalty_kicker(predicted.now(), mark_m) : -1;
  if (kicker >= 0 && predicted.now().play == Play::kPenalty) {
    assignment.give(kicker, Role::kBall);
  } else {
    assignment.give(kicker, Role::kStands, penalty_run_up(mark_m));
  }
  for (int i = 0; i < predicted.robots(); ++i) {
    if (!assignment.is_free(i)) continue;
    if (i == 0 && !is_attacking && predicted.style().penalty_on_line) {
      assignment.give(i, Role::kGoalLine, penalty_keeper(predicted.field(), mark_m));
      continue;
    }
    const Waypoint waypoint =
        i == 0 ? penalty_keeper(predicted.field(), mark_m)
               : penalty_spectator(predicted.field(), mark_m, predicted.rules().penalty_clearance_m,
                                   is_attacking, i - 1);
    assignment.give(i, Role::kStands, waypoint);
  }
}

}  // namespace autoref::strategies
