// The teams in strategies/README.md. readme_test.cpp compares the README's code with the code
// between the marks here, and tests/game/loop/readme_game_test.cpp plays the teams.
#pragma once

#include <memory>

#include "strategies/plays/squad.hpp"
#include "strategies/skills/limits.hpp"
#include "strategies/skills/play_ball.hpp"
#include "strategies/skills/prediction.hpp"
#include "strategies/strategy.hpp"

namespace autoref::strategies::readme {

// [mine]
inline constexpr Tunable kShot = {{"shot_mps", {1, 8}, "Speed of shots."}, 6};

class Mine final : public Strategy {
 public:
  explicit Mine(const TeamContext& context)
      : context_(context), shot_mps_(value_of(kShot, context.params)) {}

  void decide(const TeamView& view, TeamCommands& commands) override {
    look_ahead(view, now_);  // the field as it will be when these commands take effect
    if (!now_.own.empty()) requests_.keeper = now_.own.front().number;
    const int chaser = may_play() ? nearest_to_ball() : -1;
    for (int i = 0; i < static_cast<int>(now_.own.size()); ++i) {
      const TrackedRobot& robot = now_.own[i];
      commands[robot.number] = i == chaser ? shoot(robot) : drive_to(robot, waypoint_of(i), {}, {});
    }
  }

  TeamRequests requests() const override { return requests_; }

 private:
  bool may_play() const {
    return now_.play == Play::kRunning || (is_restart(now_.play) && now_.ours);
  }

  int nearest_to_ball() const {
    // In its own area only the keeper may play the ball.
    if (distance_to_defence_area(context_.field, Side::kWest, ball_m()) < 0.1) return 0;
    int nearest = -1;
    for (int i = 1; i < static_cast<int>(now_.own.size()); ++i) {
      const auto path_m = [&](int k) { return (now_.own[k].position_m - ball_m()).norm(); };
      if (nearest < 0 || path_m(i) < path_m(nearest)) nearest = i;
    }
    return nearest;
  }

  RobotCommand shoot(const TrackedRobot& robot) const {
    const Vec2 goal_m = context_.field.goal_centre_m(Side::kEast);  // the opponents'
    return play_ball(robot, now_.ball, ball_m(), {goal_m, shot_mps_}, {}, {});
  }

  // The keeper in front of its goal, the others in a row across their half, all facing the ball.
  // Indices are not robot numbers: without robot 0, index 0 is robot 1, which is then the keeper.
  Waypoint waypoint_of(int index) const {
    const double half_m = context_.field.half_length_m();
    const Vec2 wanted_m = index == 0 ? Vec2(0.15 - half_m, 0) : Vec2(-1, 0.4 * (index - 3));
    Limits limits;
    limits.may_enter_own_area = index == 0;
    if (!may_play()) limits.keep_from_ball_m = 0.65;  // 500 mm from the hull, plus a margin
    const Vec2 position_m = permitted(context_.field, wanted_m, ball_m(), limits);
    return {position_m, direction_of(ball_m() - position_m, Vec2(1, 0))};
  }

  const Vec2& ball_m() const { return now_.ball.position_m; }

  TeamContext context_;
  double shot_mps_;
  TeamView now_;
  TeamRequests requests_;
};
// [mine]

// [bus]
// One robot plays the ball, three form a wall, and the others run for passes.
inline void park(PlayContext& book, RoleAssignment& assignment) {
  give_goal_and_ball(book, assignment);
  defend(book, assignment, 3, 0);
  run_for_passes(book, assignment);
}

inline TeamPlaybook bus_playbook() {
  Style style;
  style.carry = 0.2;
  return {style, park};
}
// [bus]

}  // namespace autoref::strategies::readme
