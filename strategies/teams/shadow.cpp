// A man-marking team. Each field player follows its own opponent everywhere, no matter which team
// has the ball. One robot goes for the ball, and a few leave their opponents to attack with it.
#include <algorithm>
#include <cmath>
#include <limits>

#include "strategies/plays/formation_spots.hpp"
#include "strategies/tactics/defend.hpp"
#include "strategies/teams/playbooks.hpp"

namespace autoref::strategies {
namespace {

// Index of the opponent nearest to its own goal, presumably the keeper.
int their_keeper(const PredictedState& predicted) {
  const TrackedRobots& all = predicted.now().opponents;
  const Vec2 goal_m = predicted.field().goal_centre_m(Side::kEast);
  int keeper = -1;
  double best_m = std::numeric_limits<double>::infinity();
  for (int i = 0; i < static_cast<int>(all.size()); ++i) {
    const double distance_m = (all[static_cast<std::size_t>(i)].position_m - goal_m).norm();
    if (distance_m >= best_m) continue;
    best_m = distance_m;
    keeper = i;
  }
  return keeper;
}

// A spot next to each opponent except the keeper, starting with those nearest to this team's own
// goal.
FormationSpots men(const PredictedState& predicted) {
  const TrackedRobots& all = predicted.now().opponents;
  const int keeper = their_keeper(predicted);
  FormationSpots spots;
  for (int i = 0; i < static_cast<int>(all.size()); ++i) {
    if (i == keeper) continue;
    const int key = all[static_cast<std::size_t>(i)].number + 1;
    spots.push_back({key, off_their_area(predicted, mark_position(predicted, i).position_m,
                                         predicted.style().way_around_m)});
  }
  const Vec2 goal_m = predicted.field().goal_centre_m(Side::kWest);
  const auto to_goal_m = [&](const FormationSpot& spot) {
    return (spot.waypoint.position_m - goal_m).norm();
  };
  std::sort(spots.begin(), spots.end(), [&](const FormationSpot& a, const FormationSpot& b) {
    return to_goal_m(a) < to_goal_m(b);
  });
  return spots;
}

void shadow_men(PlayContext& book, RoleAssignment& assignment, int free_of_men) {
  const FormationSpots spots = men(book.predicted);
  fill_own_spots(book, assignment, spots, static_cast<int>(spots.size()) - free_of_men);
  send_ahead(book, assignment, free_of_men);
  defend(book, assignment, assignment.free_robots(), 0);
}

void shadow_play(PlayContext& book, RoleAssignment& assignment) {
  give_goal_and_ball(book, assignment);
  const int runs = static_cast<int>(std::lround(book.predicted.style().receivers));
  shadow_men(book, assignment, book.predicted.is_ours() ? runs : 0);
}

void await_shadow(PlayContext& book, RoleAssignment& assignment) {
  give_goal_and_restart(book, assignment);
  shadow_men(book, assignment, 0);
}

}  // namespace

TeamPlaybook shadow_playbook() {
  Style style;
  style.receivers = 2;
  return {style, shadow_play, await_shadow};
}

}  // namespace autoref::strategies
