// A world without physics for tests of teams: robots do at once what they are told, the ball stays.
#pragma once

#include "soccer/team_view.hpp"
#include "soccer/trigonometry.hpp"
#include "strategies/strategy.hpp"

namespace autoref::strategies {

class StagedWorld {
 public:
  explicit StagedWorld(Play play, bool ours = false) {
    view.play = play;
    view.ours = ours;
  }

  StagedWorld& own(int number, const Vec2& position_m) {
    view.own.push_back({number, position_m, Vec2(1, 0), Vec2(0, 0), 0});
    return *this;
  }
  StagedWorld& opponent(int number, const Vec2& position_m) {
    view.opponents.push_back({number, position_m, Vec2(-1, 0), Vec2(0, 0), 0});
    return *this;
  }
  StagedWorld& six_against_six() {
    for (int i = 0; i < 6; ++i) {
      own(i, {-0.4 - 0.4 * i, 1.2 - 0.35 * i});
      opponent(i, {0.4 + 0.4 * i, -1.2 + 0.35 * i});
    }
    return *this;
  }

  // One frame of 1/60 s in which every robot moves exactly as ordered.
  const TeamOrders& step(Strategy& team) {
    orders.fill(RobotCommand{});
    team.decide(view, orders);
    for (TrackedRobot& robot : view.own) {
      const RobotCommand& order = orders[static_cast<std::size_t>(robot.number)];
      robot.velocity_mps = to_world(order.velocity_mps, robot.heading);
      robot.angular_velocity_radps = order.angular_velocity_radps;
      robot.position_m += robot.velocity_mps / 60;
      robot.heading = heading_of(angle_of(robot.heading) + order.angular_velocity_radps / 60);
    }
    ++view.frame;
    view.time_s += 1.0 / 60;
    return orders;
  }

  void run(Strategy& team, double seconds) {
    for (int i = 0; i < seconds * 60; ++i) step(team);
  }

  const TrackedRobot& robot(int number) const {
    for (const TrackedRobot& robot : view.own) {
      if (robot.number == number) return robot;
    }
    throw std::out_of_range("no such robot");
  }

  TeamView view;
  TeamOrders orders;
};

}  // namespace autoref::strategies
