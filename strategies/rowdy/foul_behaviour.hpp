// A foul behaviour: a way of breaking a rule, its opportunities, and what the team then does.
#pragma once

#include <optional>
#include <string_view>

#include "soccer/robot_command.hpp"
#include "soccer/team_requests.hpp"
#include "strategies/rowdy/scene.hpp"

namespace autoref::strategies::rowdy {

// A foul behaviour under way.
struct ActiveFoul {
  int robot = -1;      // number of the offending robot; -1: the whole team
  int other = -1;      // number of the opponent that is fouled
  double amount = 0;   // random in [0, 1): distance or duration, depending on the kind
  double begun_s = 0;  // view time
  Vec2 from_m{0, 0};  // position of the ball when it began, or another point, depending on the kind
  bool is_halfway = false;  // for kinds with two parts
};

// The commands and requests that the team is about to send.
struct TeamOutput {
  TeamCommands& commands;
  TeamRequests& requests;
  RobotCommand& command(int number) const { return commands[static_cast<std::size_t>(number)]; }
};

// A foul by `robot`; nullopt if `robot` is null.
inline std::optional<ActiveFoul> foul_by(const TrackedRobot* robot, const Vec2& from_m) {
  if (robot == nullptr) return std::nullopt;
  ActiveFoul foul;
  foul.robot = robot->number;
  foul.from_m = from_m;
  return foul;
}

// A foul by `robot` against an opponent.
inline ActiveFoul foul_against(const TrackedRobot& victim, const TrackedRobot& robot) {
  ActiveFoul foul = *foul_by(&robot, victim.position_m);
  foul.other = victim.number;
  return foul;
}

// The opponent that is fouled; nullptr if that robot is gone or the ball is not in play.
inline const TrackedRobot* victim_of(const ActiveFoul& foul, const Scene& scene) {
  return is_running(scene) ? find(scene.now.opponents, foul.other) : nullptr;
}

struct FoulBehaviour {
  std::string_view name;  // name of the parameter that sets `share`
  std::string_view about;
  double share;      // default fraction of opportunities taken
  double longest_s;  // the foul is given up after this time
  // The foul that is possible now, without `amount` and `begun_s`; nullopt if there is no
  // opportunity.
  std::optional<ActiveFoul> (*find_chance)(const Scene& scene);
  // Changes the team's output. Returns false once the foul is over. If the foul has a robot, the
  // robot is on the field.
  bool (*go_on)(const Scene& scene, ActiveFoul& foul, TeamOutput& output);
};

}  // namespace autoref::strategies::rowdy
