// The referee favours neither side: if the frames are rotated by 180 degrees and the sides swapped,
// the calls are rotated as well and come in the same frames.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "soccer/random.hpp"
#include "tests/referee/support/scripted_game.hpp"

namespace autoref::referee {
namespace {

constexpr double kMirroredFrame_s = 1.0 / 60;

// A rough game without strategy: robots chase the ball or wander, a robot at the ball kicks it in a
// random direction, and ball placement follows one of the two referees.
class RoughGame {
 public:
  explicit RoughGame(std::uint64_t seed) : random_(seed) {
    frame_.ball = BallObservation{Vec2(0, 0), 0.0};
    for (Side side : kSides) {
      for (int i = 0; i < 6; ++i) {
        const Vec2 position(goal_sign(side) * (0.5 + 0.3 * i), -1.5 + 0.5 * i);
        frame_.robots[side].push_back({i, position, Vec2(-goal_sign(side), 0)});
      }
    }
  }

  const Frame& next(const RefereeSignal& signal) {
    ++frame_.number;
    frame_.time_s = static_cast<double>(frame_.number) * kMirroredFrame_s;
    const bool rests = signal.placement && frame_.number % 1800 > 300;
    if (!rests) move_robots();
    move_ball(signal);
    look();
    return seen_;
  }

 private:
  void move_robots() {
    for (Side side : kSides) {
      for (RobotObservation& robot : frame_.robots[side]) {
        const Vec2 wander(random_.uniform() - 0.5, random_.uniform() - 0.5);
        const Vec2 goal = robot.number < 3 ? frame_.ball->position_m : wander * 6;
        const Vec2 direction = direction_of(goal - robot.position_m, robot.heading);
        robot.heading = direction_of(robot.heading + direction * 0.2, direction);
        // Slightly different speeds, so that two robots never tie in every respect.
        const double own_mps = side == Side::kWest ? 0 : 0.03;
        robot.position_m += direction * (1.5 + 0.5 * robot.number / 6 + own_mps) * kMirroredFrame_s;
      }
    }
  }

  void move_ball(const RefereeSignal& signal) {
    Vec2& ball_m = frame_.ball->position_m;
    if (signal.placement) {
      ball_mps_ = Vec2(0, 0);
      const Vec2 direction = signal.placement->target_m - ball_m;
      ball_m += signal.placement->at_once ? direction : clamp_norm(direction, 0.05);
      return;
    }
    for (Side side : kSides) {
      for (const RobotObservation& robot : frame_.robots[side]) bounce(robot);
    }
    ball_mps_ *= 0.995;
    ball_m += ball_mps_ * kMirroredFrame_s;
    const bool at_wall = std::abs(ball_m.x()) > 3.7 || std::abs(ball_m.y()) > 2.7;
    if (at_wall) ball_mps_ = -ball_mps_;
  }

  void bounce(const RobotObservation& robot) {
    Vec2& ball_m = frame_.ball->position_m;
    const double gap = distance_to_hull(ball_m, robot.position_m, robot.heading) - kBallRadius_m;
    if (gap > 0.004) return;
    const Vec2 away = direction_of(ball_m - robot.position_m, robot.heading);
    ball_m += away * std::max(0.0, -gap);
    ball_mps_ = away * (1 + 5 * random_.uniform());
  }

  // Occasionally the camera misses the ball or a robot, and some balls fly.
  void look() {
    seen_ = frame_;
    if (random_.uniform() < 0.02) seen_.ball.reset();
    if (random_.uniform() < 0.1) seen_.robots[Side::kWest].pop_back();
    if (random_.uniform() < 0.1) seen_.robots[Side::kEast].pop_back();
    if (seen_.ball && frame_.number % 1000 > 900) seen_.ball->height_m = 0.2;
    if (seen_.ball && frame_.number % 1000 > 950) seen_.ball->height_m.reset();
  }

  RandomStream random_;
  Frame frame_;
  Frame seen_;
  Vec2 ball_mps_{0, 0};
};

std::optional<Side> turned(const std::optional<Side>& side) {
  return side ? std::optional(opponent_of(*side)) : std::nullopt;
}

RobotId turned(RobotId robot) { return {opponent_of(robot.side), robot.number}; }

std::optional<Command> turned(const std::optional<Command>& command) {
  return command ? std::optional(mirrored(*command)) : std::nullopt;
}

void expect_turned(const std::optional<Vec2>& a, const std::optional<Vec2>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (a) {
    EXPECT_LE((*a + *b).norm(), 1e-6);
  }
}

void expect_turned(const LastTouch& a, const LastTouch& b) {
  EXPECT_EQ(turned(a.side), b.side);
  ASSERT_EQ(a.robot.has_value(), b.robot.has_value());
  if (a.robot) {
    EXPECT_EQ(turned(*a.robot), *b.robot);
  }
  ASSERT_EQ(a.runner_up.has_value(), b.runner_up.has_value());
  if (a.runner_up) {
    EXPECT_EQ(turned(*a.runner_up), *b.runner_up);
  }
  EXPECT_NEAR(a.gap_m, b.gap_m, 1e-6);
  EXPECT_NEAR(a.time_s, b.time_s, 1e-6);
}

void expect_turned(const Decision& a, const Decision& b) {
  SCOPED_TRACE(a.transition);
  EXPECT_EQ(a.transition, b.transition);
  EXPECT_EQ(a.frame, b.frame);
  EXPECT_EQ(turned(a.command), b.command);
  EXPECT_EQ(turned(a.finding.offender), b.finding.offender);
  EXPECT_NEAR(a.finding.value, b.finding.value, 1e-6);
  expect_turned(a.finding.position_m, b.finding.position_m);
  expect_turned(a.last_touch, b.last_touch);
  std::vector<RobotId> robots;
  for (const RobotId robot : a.finding.robots) robots.push_back(turned(robot));
  std::sort(robots.begin(), robots.end());
  std::vector<RobotId> others(b.finding.robots.begin(), b.finding.robots.end());
  std::sort(others.begin(), others.end());
  EXPECT_EQ(robots, others);
}

void expect_turned(const RefereeSignal& a, const RefereeSignal& b) {
  EXPECT_EQ(mirrored(a.command), b.command);
  EXPECT_EQ(a.command_counter, b.command_counter);
  EXPECT_EQ(a.stage, b.stage);
  EXPECT_EQ(a.stage_time_left_s, b.stage_time_left_s);
  EXPECT_EQ(a.shootout_goals[Side::kWest], b.shootout_goals[Side::kEast]);
  EXPECT_EQ(a.shootout_goals[Side::kEast], b.shootout_goals[Side::kWest]);
  EXPECT_EQ(a.robots_allowed[Side::kWest], b.robots_allowed[Side::kEast]);
  EXPECT_EQ(a.robots_allowed[Side::kEast], b.robots_allowed[Side::kWest]);
  EXPECT_EQ(a.goals[Side::kWest], b.goals[Side::kEast]);
  EXPECT_EQ(a.goals[Side::kEast], b.goals[Side::kWest]);
  EXPECT_EQ(turned(a.next_command), b.next_command);
  ASSERT_EQ(a.placement.has_value(), b.placement.has_value());
  if (a.placement) {
    EXPECT_LE((a.placement->target_m + b.placement->target_m).norm(), 1e-6);
  }
}

struct RoughSetup {
  int seed;
  const char* book;
};

Configuration rough_configuration(const RoughSetup& setup, Side first_kickoff) {
  Configuration configuration;
  configuration.rules = find_rule_book(setup.book).value();
  configuration.rules.in_force[RuleId::kOffside] = configuration.rules.name != "paper";
  configuration.half_s = 60;
  configuration.after_game = AfterGame::kNewGame;
  configuration.first_kickoff = first_kickoff;
  return configuration;
}

// Cards, timeouts and knockout games with the clock of the 2026 rules; teams request timeouts at
// random.
Configuration rough_knockout(const RoughSetup& setup, Side first_kickoff) {
  Configuration configuration = rough_configuration(setup, first_kickoff);
  for (const RuleId rule : {RuleId::kCards, RuleId::kTimeouts, RuleId::kTooManyRobots}) {
    configuration.rules.in_force[rule] = true;
  }
  configuration.rules.clock_stops = true;
  configuration.rules.timeouts_s = 5;
  configuration.rules.extra_half_s = 4;
  configuration.half_s = 6;
  configuration.knockout = true;
  return configuration;
}

std::vector<std::string_view> transitions_of(const AutoRef& referee) {
  std::vector<std::string_view> transitions;
  for (const Decision& decision : referee.decisions()) transitions.push_back(decision.transition);
  return transitions;
}

// Two referees see the same game, one of them turned by 180 degrees.
class Pair {
 public:
  // `turned_configuration` is `configuration` with the sides swapped.
  Pair(const Configuration& configuration, const Configuration& turned_configuration)
      : referee_(configuration), other_(turned_configuration) {}

  void judge(RoughGame& game, const PerSide<TeamRequests>& requests) {
    const Frame& frame = game.next(signal_);
    signal_ = referee_.update(frame, requests);
    const PerSide<TeamRequests> turned_requests{{requests[Side::kEast], requests[Side::kWest]}};
    const RefereeSignal turned_signal = other_.update(mirrored(frame), turned_requests);
    expect_turned(signal_, turned_signal);
    EXPECT_EQ(referee_.is_ball_in_play(), other_.is_ball_in_play());
    ASSERT_EQ(transitions_of(referee_), transitions_of(other_)) << "frame " << frame.number;
    for (std::size_t k = 0; k < referee_.decisions().size(); ++k) {
      const Decision& decision = referee_.decisions()[k];
      expect_turned(decision, other_.decisions()[k]);
      ++events_[static_cast<std::size_t>(decision.finding.event)];
      calls_ += is_call(decision.finding.event) ? 1 : 0;
    }
  }

  int calls() const { return calls_; }
  int count(Event event) const { return events_[static_cast<std::size_t>(event)]; }

 private:
  AutoRef referee_;
  AutoRef other_;
  RefereeSignal signal_;
  int calls_ = 0;
  std::array<int, kEventCount> events_{};
};

class Mirrored : public testing::TestWithParam<RoughSetup> {};

TEST_P(Mirrored, FramesGiveMirroredCallsInTheSameFrames) {
  RoughGame game(static_cast<std::uint64_t>(GetParam().seed));
  Pair referees(rough_configuration(GetParam(), Side::kWest),
                rough_configuration(GetParam(), Side::kEast));
  for (int i = 0; i < 12000 && !HasFailure(); ++i) referees.judge(game, {});
  EXPECT_GT(referees.calls(), 8);  // otherwise nothing was tested
}

TEST_P(Mirrored, FramesAndRequestsGiveMirroredTimeoutsAndShootouts) {
  RoughGame game(static_cast<std::uint64_t>(GetParam().seed));
  RandomStream random(static_cast<std::uint64_t>(GetParam().seed) + 100);
  Pair referees(rough_knockout(GetParam(), Side::kWest), rough_knockout(GetParam(), Side::kEast));
  PerSide<TeamRequests> requests;
  for (int i = 0; i < 12000 && !HasFailure(); ++i) {
    for (const Side side : kSides) {
      const double chance = random.uniform();
      if (chance < 0.01) requests[side].timeout = chance < 0.005;
    }
    referees.judge(game, requests);
  }
  EXPECT_GT(referees.count(Event::kTimeout), 0);
}

std::string name_of_setup(const testing::TestParamInfo<RoughSetup>& info) {
  std::string name = std::string(info.param.book) + "_" + std::to_string(info.param.seed);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::vector<RoughSetup> setups() {
  std::vector<RoughSetup> all;
  for (int seed = 1; seed <= 8; ++seed) all.push_back({seed, "paper"});
  for (int seed = 9; seed <= 12; ++seed) all.push_back({seed, "2014"});
  for (int seed = 13; seed <= 16; ++seed) all.push_back({seed, "2026-b"});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Games, Mirrored, testing::ValuesIn(setups()), name_of_setup);

}  // namespace
}  // namespace autoref::referee
