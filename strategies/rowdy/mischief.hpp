// One way of breaking a rule: when there is an opportunity, and what is done with it.
#pragma once

#include <optional>
#include <string_view>

#include "soccer/robot_command.hpp"
#include "soccer/team_requests.hpp"
#include "strategies/rowdy/scene.hpp"

namespace autoref::strategies::rowdy {

// A mischief under way.
struct Deed {
  int robot = -1;           // number of who does it; -1: nobody in particular
  int other = -1;           // number of the opponent it is done to
  double amount = 0;        // drawn in [0, 1): how far, how long; the kind says
  double begun_s = 0;       // view time
  Vec2 from_m{0, 0};        // place of the ball, or what the kind says, when it began
  bool is_halfway = false;  // for kinds that have two parts
};

// What the team is about to order and to ask for.
struct Will {
  TeamOrders& orders;
  TeamRequests& requests;
  RobotCommand& order(int number) const { return orders[static_cast<std::size_t>(number)]; }
};

// A deed of `robot`, none where it is nullptr.
inline std::optional<Deed> deed_of(const TrackedRobot* robot, const Vec2& from_m) {
  if (robot == nullptr) return std::nullopt;
  Deed deed;
  deed.robot = robot->number;
  deed.from_m = from_m;
  return deed;
}

// A deed of `robot` against an opponent.
inline Deed deed_against(const TrackedRobot& victim, const TrackedRobot& robot) {
  Deed deed = *deed_of(&robot, victim.position_m);
  deed.other = victim.number;
  return deed;
}

// The opponent that it is done to; nullptr once play or that robot is gone.
inline const TrackedRobot* victim_of(const Deed& deed, const Scene& scene) {
  return is_running(scene) ? find(scene.now.opponents, deed.other) : nullptr;
}

struct Mischief {
  std::string_view name;  // of the parameter that holds its share
  std::string_view about;
  double share;      // of the opportunities taken, by default
  double longest_s;  // then it is given up
  // Who could do it now, `amount` and `begun_s` left out; none where there is no opportunity.
  std::optional<Deed> (*find_chance)(const Scene& scene);
  // Changes what the team wants. False once it is over. The deed's robot is on the field, if it has
  // one.
  bool (*go_on)(const Scene& scene, Deed& deed, Will& will);
};

}  // namespace autoref::strategies::rowdy
