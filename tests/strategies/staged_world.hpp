// A world without physics for tests of teams: robots follow their commands instantly, and the ball
// stays or moves freely.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "soccer/robot_shape.hpp"
#include "soccer/team_view.hpp"
#include "soccer/trigonometry.hpp"
#include "strategies/strategy.hpp"
#include "strategies/tactics/predicted_state.hpp"

namespace autoref::strategies {

inline constexpr double kBallGap_m = 0.5 + kRobotRadius_m;  // Laws: 500 mm from hull to ball

inline constexpr double kStagedFrame_s = 1.0 / 60;
inline constexpr double kHeldBall_m = kFrontDistance_m + kBallRadius_m;  // from robot to ball

// A ball kicked over the carpet of sim/README.md: it slides with a deceleration of 3.4 m/s^2 until
// 0.67 of its speed is left, then rolls with 0.30 m/s^2.
struct CarpetBall {
  static constexpr double kSlide_mps2 = 3.4;
  static constexpr double kRoll_mps2 = 0.30;
  static constexpr double kRollsFrom = 0.67;

  Vec2 start_m{0, 0};
  Vec2 direction{1, 0};
  double kick_mps = 0;

  double rolls_mps() const { return kRollsFrom * kick_mps; }
  double slide_m() const {
    return (kick_mps * kick_mps - rolls_mps() * rolls_mps()) / (2 * kSlide_mps2);
  }
  double longest_m() const { return slide_m() + rolls_mps() * rolls_mps() / (2 * kRoll_mps2); }

  TrackedBall at(double time_s) const {
    const double slide_s = (kick_mps - rolls_mps()) / kSlide_mps2;
    if (time_s < slide_s) {
      return {start_m + direction * (kick_mps * time_s - kSlide_mps2 * time_s * time_s / 2),
              direction * (kick_mps - kSlide_mps2 * time_s)};
    }
    const double t = std::min(time_s - slide_s, rolls_mps() / kRoll_mps2);
    return {start_m + direction * (slide_m() + rolls_mps() * t - kRoll_mps2 * t * t / 2),
            direction * (rolls_mps() - kRoll_mps2 * t)};
  }
};

// Moves a robot for one frame exactly as commanded.
inline void obey(TrackedRobot& robot, const RobotCommand& command) {
  robot.velocity_mps = to_world(command.velocity_mps, robot.heading);
  robot.angular_velocity_radps = command.angular_velocity_radps;
  robot.position_m += robot.velocity_mps * kStagedFrame_s;
  robot.heading =
      heading_of(angle_of(robot.heading) + command.angular_velocity_radps * kStagedFrame_s);
}

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

  // A world with that many robots per team, each team in a row from west to east.
  StagedWorld& rows_of(int robots) {
    for (int i = 0; i < robots; ++i)
      own(i, {-2.5 + 0.3 * i, 1.0}).opponent(i, {-2.5 + 0.3 * i, -1.0});
    return *this;
  }

  // One frame of 1/60 s in which every robot moves exactly as commanded.
  const TeamCommands& step(Strategy& team) {
    commands.fill(RobotCommand{});
    team.decide(view, commands);
    for (TrackedRobot& robot : view.own) {
      obey(robot, commands[static_cast<std::size_t>(robot.number)]);
    }
    pass_frame();
    return commands;
  }

  void run(Strategy& team, double seconds) {
    for (int i = 0; i < seconds * 60; ++i) step(team);
  }

  // Advances time by a frame; a kicked ball moves on.
  void pass_frame() {
    ++view.frame;
    view.time_s += kStagedFrame_s;
    if (kicked) view.ball = kicked->at(view.time_s - kicked_at_s);
  }

  // Kicks the ball from where it lies.
  StagedWorld& kick(const Vec2& velocity_mps) {
    kicked = CarpetBall{view.ball.position_m, direction_of(velocity_mps, Vec2(1, 0)),
                        velocity_mps.norm()};
    kicked_at_s = view.time_s;
    view.ball = kicked->at(0);
    return *this;
  }
  StagedWorld& ball(const Vec2& position_m) {
    view.ball = {position_m, Vec2(0, 0)};
    kicked.reset();
    return *this;
  }

  const TrackedRobot& robot(int number) const {
    for (const TrackedRobot& robot : view.own) {
      if (robot.number == number) return robot;
    }
    throw std::out_of_range("no such robot");
  }

  TeamView view;
  TeamCommands commands;
  std::optional<CarpetBall> kicked;
  double kicked_at_s = 0;
};

// Numbers of robots. A test that compares them with kNobody names the robots that break a rule.
using Numbers = std::vector<int>;
inline const Numbers kNobody;

template <typename Condition>
Numbers numbers_of(const TrackedRobots& robots, Condition condition) {
  Numbers numbers;
  for (const TrackedRobot& robot : robots) {
    if (condition(robot)) numbers.push_back(robot.number);
  }
  return numbers;
}

inline bool is_beyond_own_half(const TrackedRobot& robot) {
  return !(robot.position_m.x() <= -kRobotRadius_m);
}
inline bool is_nowhere(const TrackedRobot& robot) { return !is_finite(robot.position_m); }

// The own robots whose centres are less than `distance_m` from the point.
inline Numbers robots_within(const StagedWorld& world, const Vec2& point_m, double distance_m) {
  return numbers_of(world.view.own, [&](const TrackedRobot& robot) {
    return !((robot.position_m - point_m).norm() >= distance_m);
  });
}

// The same without robot 0, because the keeper may stay in its goal.
inline Numbers field_players_within(const StagedWorld& world, const Vec2& point_m,
                                    double distance_m) {
  Numbers numbers = robots_within(world, point_m, distance_m);
  std::erase(numbers, 0);
  return numbers;
}

// The own robots whose centres are less than `distance_m` from the opponents' defence area.
inline Numbers near_their_area(const StagedWorld& world, double distance_m) {
  return numbers_of(world.view.own, [&](const TrackedRobot& robot) {
    return !(distance_to_defence_area(Field{}, Side::kEast, robot.position_m) >= distance_m);
  });
}

// The own robots that have moved by at least `distance_m`.
inline Numbers moved_since(const TeamView& before, const StagedWorld& world, double distance_m) {
  return numbers_of(world.view.own, [&](const TrackedRobot& robot) {
    const auto same = [&](const TrackedRobot& former) { return former.number == robot.number; };
    const auto former = std::find_if(before.own.begin(), before.own.end(), same);
    return !((robot.position_m - former->position_m).norm() < distance_m);
  });
}

// The robots with a command to move or to kick.
inline Numbers active_robots(const TeamCommands& commands) {
  Numbers numbers;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (commands[i].velocity_mps != Vec2(0, 0) || commands[i].kick_mps != 0)
      numbers.push_back(static_cast<int>(i));
  }
  return numbers;
}

// Lets the team play for `seconds`. Returns the smallest distance of its robots from the point.
inline double least_gap_m(StagedWorld& world, Strategy& team, double seconds, const Vec2& point_m) {
  double least_m = 10;
  for (int frame = 0; frame < seconds * 60; ++frame) {
    world.step(team);
    for (const TrackedRobot& robot : world.view.own)
      least_m = std::min(least_m, (robot.position_m - point_m).norm());
  }
  return least_m;
}

// A position in millimetres as part of a test's name: "West2900North1900".
inline std::string place_name(const Vec2& position_m) {
  const auto part = [](double metres, const char* plus, const char* minus) {
    return (metres < 0 ? minus : plus) + std::to_string(std::lround(std::abs(metres) * 1000));
  };
  return part(position_m.x(), "East", "West") + part(position_m.y(), "North", "South");
}
inline std::string name_of_place(const testing::TestParamInfo<Vec2>& info) {
  return place_name(info.param);
}
inline std::string name_of_rule_book(const testing::TestParamInfo<const char*>& info) {
  std::string name = info.param;
  std::erase(name, '-');
  return name;
}

// A staged world and a team's predicted state of it.
struct StagedPrediction {
  explicit StagedPrediction(Play play, bool ours = false, const TeamContext& context = {},
                            const Style& style = {})
      : world(play, ours), predicted(context, style) {}

  // Observes the world for a number of frames in which no robot moves. Opponents are updated
  // alternately, so one frame is not enough for all of them.
  const PredictedState& look(int frames = 4) {
    for (int i = 0; i < frames; ++i) {
      predicted.update(world.view);
      world.pass_frame();
    }
    return predicted;
  }

  StagedWorld world;
  PredictedState predicted;
};

// A team with robots that cannot chip.
inline TeamContext context_without_chips() {
  TeamContext context;
  for (Abilities& robot : context.robots) robot.chip_mps = 0;
  return context;
}

// The team context for a game under that rule book.
inline TeamContext team_context_of(const char* rules) {
  TeamContext context;
  context.rules = find_rule_book(rules).value();
  context.field = find_game_setup(rules).value().field;
  return context;
}

}  // namespace autoref::strategies
