// One way of breaking a rule: when there is an opportunity, and what is done with it.
#pragma once

#include <optional>
#include <string_view>

#include "soccer/robot_command.hpp"
#include "soccer/team_requests.hpp"
#include "strategies/rowdy/scene.hpp"

namespace autoref::strategies::rowdy {

// A foul behaviour under way.
struct ActiveFoul {
  int robot = -1;           // number of who does it; -1: nobody in particular
  int other = -1;           // number of the opponent it is done to
  double amount = 0;        // drawn in [0, 1): how far, how long; the kind says
  double begun_s = 0;       // view time
  Vec2 from_m{0, 0};        // place of the ball, or what the kind says, when it began
  bool is_halfway = false;  // for kinds that have two parts
};

// What the team is about to order and to ask for.
struct TeamOutput {
  TeamCommands& commands;
  TeamRequests& requests;
  RobotCommand& command(int number) const { return commands[static_cast<std::size_t>(number)]; }
};

// A foul of `robot`, none where it is nullptr.
inline std::optional<ActiveFoul> foul_by(const TrackedRobot* robot, const Vec2& from_m) {
  if (robot == nullptr) return std::nullopt;
  ActiveFoul foul;
  foul.robot = robot->number;
  foul.from_m = from_m;
  return foul;
}

// A foul of `robot` against an opponent.
inline ActiveFoul foul_against(const TrackedRobot& victim, const TrackedRobot& robot) {
  ActiveFoul foul = *foul_by(&robot, victim.position_m);
  foul.other = victim.number;
  return foul;
}

// The opponent that it is done to; nullptr once play or that robot is gone.
inline const TrackedRobot* victim_of(const ActiveFoul& foul, const Scene& scene) {
  return is_running(scene) ? find(scene.now.opponents, foul.other) : nullptr;
}

struct FoulBehaviour {
  std::string_view name;  // of the parameter that holds its share
  std::string_view about;
  double share;      // of the opportunities taken, by default
  double longest_s;  // then it is given up
  // Who could do it now, `amount` and `begun_s` left out; none where there is no opportunity.
  std::optional<ActiveFoul> (*find_chance)(const Scene& scene);
  // Changes what the team wants. False once it is over. The foul's robot is on the field, if it has
  // one.
  bool (*go_on)(const Scene& scene, ActiveFoul& foul, TeamOutput& output);
};

}  // namespace autoref::strategies::rowdy
