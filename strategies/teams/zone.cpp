// Zones. The field players stand in a formation that shifts with the ball; each leaves its zone
// only for the ball, when it is there first, and its zone waits for it.
#include <array>

#include "strategies/plays/posts.hpp"
#include "strategies/teams/plans.hpp"

namespace autoref::strategies {
namespace {

// As shares of the half's length and width, with the ball in the centre: 2-2-1 first, then those
// who come between and beside them.
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

void hold_zones(Playbook& book, Cast& cast) {
  const Outlook& outlook = book.outlook;
  const Vec2 half_m(outlook.field().half_length_m(), outlook.field().half_width_m());
  const Vec2 shift_m(outlook.style().zone_along * outlook.place_m().x() +
                         (outlook.is_ours() ? outlook.style().zone_up * half_m.x() : 0),
                     outlook.style().zone_across * outlook.place_m().y());
  Posts zones;
  const int field_players = outlook.robots() - (outlook.robots() > 1 ? 1 : 0);
  for (const auto& share : kZones) {
    const int order = static_cast<int>(zones.size());
    if (order >= field_players) break;
    const Vec2 zone_m(share[0] * half_m.x(), share[1] * half_m.y());
    zones.push_back({order + 1, off_their_area(outlook, zone_m + shift_m)});
  }
  man_own_posts(book, cast, zones);
  defend(book, cast, cast.free_robots(), 0);  // who finds no zone
}

void zone_play(Playbook& book, Cast& cast) {
  give_goal_and_ball(book, cast);
  hold_zones(book, cast);
}

void await_zone(Playbook& book, Cast& cast) {
  give_goal_and_restart(book, cast);
  hold_zones(book, cast);
}

}  // namespace

Plan zone_plan() {
  Style style;
  style.carry = 0.6;
  return {style, zone_play, await_zone};
}

}  // namespace autoref::strategies
