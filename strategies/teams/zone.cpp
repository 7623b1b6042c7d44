// A team that defends zones. The field players stand in a formation that shifts with the ball. A
// robot leaves its zone only if it reaches the ball first; in the meantime, the zone stays empty.
#include <array>

#include "strategies/plays/formation_spots.hpp"
#include "strategies/teams/playbooks.hpp"

namespace autoref::strategies {
namespace {

// Positions when the ball is in the centre, as fractions of half the field's length and width.
// First come the positions of a 2-2-1 formation, then positions between and next to these.
constexpr std::array<std::array<double, 2>, 10> kZones = {{{-0.50, 0.22},
                                                           {-0.50, -0.22},
                                                           {-0.12, 0.45},
                                                           {-0.12, -0.45},
                                                           {0.30, 0.0},
                                                           {-0.25, 0.0},
                                                           {0.30, 0.6},
                                                           {0.30, -0.6},
                                                           {-0.40, 0.65},
                                                           {-0.40, -0.65}}};

void hold_zones(PlayContext& book, RoleAssignment& assignment) {
  const PredictedState& predicted = book.predicted;
  const Vec2 half_m(predicted.field().half_length_m(), predicted.field().half_width_m());
  const Vec2 shift_m(predicted.style().zone_along * predicted.position_m().x() +
                         (predicted.is_ours() ? predicted.style().zone_up * half_m.x() : 0),
                     predicted.style().zone_across * predicted.position_m().y());
  FormationSpots zones;
  const int field_players = predicted.robots() - (predicted.robots() > 1 ? 1 : 0);
  for (const auto& share : kZones) {
    const int order = static_cast<int>(zones.size());
    if (order >= field_players) break;
    const Vec2 zone_m(share[0] * half_m.x(), share[1] * half_m.y());
    zones.push_back({order + 1, off_their_area(predicted, zone_m + shift_m)});
  }
  fill_own_spots(book, assignment, zones);
  defend(book, assignment, assignment.free_robots(), 0);  // assigns the robots that have no zone
}

void zone_play(PlayContext& book, RoleAssignment& assignment) {
  give_goal_and_ball(book, assignment);
  hold_zones(book, assignment);
}

void await_zone(PlayContext& book, RoleAssignment& assignment) {
  give_goal_and_restart(book, assignment);
  hold_zones(book, assignment);
}

}  // namespace

TeamPlaybook zone_playbook() {
  Style style;
  style.carry = 0.6;
  return {style, zone_play, await_zone};
}

}  // namespace autoref::strategies
