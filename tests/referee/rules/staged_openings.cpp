// How a staged game reaches the starting point of its case.
//
// Additional robots, numbers 14 and 15, play the events that lead to it, so that these do not
// affect the robots of the case. A ball that reappears outside the field without a touch leads to a
// force start; kicks over the lines and a foul lead to the other restarts.
#include <stdexcept>

#include "soccer/robot_shape.hpp"
#include "tests/referee/rules/staged_game.hpp"

namespace autoref::referee {
namespace {

constexpr int kCastNumber = 15;
constexpr double kLongest_s = 60;
constexpr double kUnseen_s = 1.0;  // longer than the tracker keeps unseen robots
constexpr double kOutside_m = 0.1;
constexpr double kAtPosition_m = 0.02;

double sign_of(double x) { return x < 0 ? -1 : 1; }

}  // namespace

void StagedGame::run_until(State state, double limit_s) {
  for (int i = 0; i < limit_s * 60; ++i) {
    step();
    if (referee_.state() == state) return;
  }
  throw std::runtime_error("the starting point was not reached: no " + std::string(name_of(state)));
}

// Hides the ball and all robots for a while, as if somebody stood in front of the camera.
void StagedGame::curtain(double seconds) {
  bodies_.clear_robots();
  bodies_.show_ball(false);
  run(seconds);
  bodies_.show_ball(true);
}

void StagedGame::open() {
  if (case_.opening == Opening::kKickoff) {
    show_robots();
    bodies_.put_ball({0, 0});
  } else {
    line_up_assignment();
  }
  run_until(State::kRun, kLongest_s);
  if (case_.opening == Opening::kKickoff) return;
  score_goals();
  play_on_from_force_start();
  if (case_.opening == Opening::kRunning) {
    curtain(kUnseen_s);
    bodies_.put_ball(case_.ball_m);
    show_robots();
    return;
  }
  play_to_the_stop();
  check_beginning();
  bodies_.clear_robots();
  if (!case_.from_the_stop) bodies_.put_ball(case_.ball_m);
  show_robots();
  if (!case_.from_the_stop) run_until(State::kRun, kLongest_s);
}

void StagedGame::line_up_assignment() {
  for (const Side side : kSides) {
    for (const int number : {kCastNumber - 1, kCastNumber}) {
      const Vec2 position(goal_sign(side) * 1.5, goal_sign(side) * (number - 14.5));
      bodies_.put({side, number}, position, Vec2(-goal_sign(side), 0));
    }
  }
}

void StagedGame::show_robots() {
  for (const StagedRobot& robot : case_.robots) {
    const Vec2 heading = heading_of(to_radians(robot.facing_deg));
    if (robot.at_m) {
      bodies_.put(robot.id, *robot.at_m, heading);
    } else {
      bodies_.put_behind_ball(robot.id, heading);
    }
  }
}

void StagedGame::play_on_from_force_start() {
  curtain(kUnseen_s);
  bodies_.put_ball({0, field_.half_width_m() + kOutside_m});
  line_up_assignment();
  run_until(State::kWaitStop, 1);
  if (all_.back().decision.finding.event != Event::kTouchLineUnknown) {
    throw std::runtime_error("the ball went out untouched: expected touch_line_unknown, got " +
                             std::string(name_of(all_.back().decision.finding.event)));
  }
  run_until(State::kRun, kLongest_s);
}

void StagedGame::score_goals() {
  for (const Side side : kSides) {
    for (int i = 0; i < case_.score[side]; ++i) score_goal(side);
  }
}

// The ball first enters play in the middle, where nobody is near an area.
void StagedGame::score_goal(Side scorer) {
  curtain(kUnseen_s);
  bodies_.put_ball({0.6, 0.6});
  run(0.2);
  const double sign = goal_sign(opponent_of(scorer));
  const double from_goal_m = field_.defence_area.depth_m + 0.5;
  kick_out({sign * (field_.half_length_m() - from_goal_m), 0}, {scorer, kCastNumber}, {sign, 0});
  run_until(State::kDelayWait, 5);
  bodies_.clear_robots();
  line_up_assignment();
  run_until(State::kRun, kLongest_s);
}

void StagedGame::kick_out(const Vec2& from_m, RobotId kicker, const Vec2& direction) {
  curtain(kUnseen_s);
  bodies_.put_ball(from_m);
  bodies_.put_behind_ball(kicker, direction);
  if (case_.from_the_stop) show_robots();  // the readiness check compares with their last positions
  run(0.2);
  Cue kick;
  kick.kind = Cue::Kind::kKick;
  kick.robot = kicker;
  kick.speed = 3;
  bodies_.obey(kick);
}

// A defender other than the keeper kicks the ball back from inside its own area.
void StagedGame::foul_for_penalty() {
  const double sign = goal_sign(opponent_of(case_.taken_by));
  const double goal_x_m = sign * field_.half_length_m();
  kick_out({goal_x_m - sign * 1.6, 0}, {case_.taken_by, kCastNumber}, {sign, 0});
  bodies_.put({opponent_of(case_.taken_by), kCastNumber}, {goal_x_m - sign * 0.3, 0}, {-sign, 0});
}

void StagedGame::play_to_the_stop() {
  const RobotId kicker{opponent_of(case_.taken_by), kCastNumber};
  const double x_sign = sign_of(case_.ball_m.x());
  const double y_sign = sign_of(case_.ball_m.y());
  const Vec2 near_corner_m(x_sign * (field_.half_length_m() - 0.3),
                           y_sign * (field_.half_width_m() - 0.4));
  const Vec2 near_touch_line_m(case_.ball_m.x(), y_sign * (field_.half_width_m() - 0.3));
  switch (case_.opening) {
    case Opening::kThrowIn:
      kick_out(near_touch_line_m, kicker, {0, y_sign});
      break;
    case Opening::kGoalKick:
    case Opening::kCornerKick:
      kick_out(near_corner_m, kicker, {x_sign, 0});
      break;
    case Opening::kPenalty:
      foul_for_penalty();
      break;
    case Opening::kRunning:
    case Opening::kKickoff:
      return;
  }
  run_until(State::kWaitStop, 5);
}

void StagedGame::check_beginning() const {
  const Event event = all_.back().decision.finding.event;
  const std::optional<Command> next = all_.back().next;
  if (!next || next->side != case_.taken_by) {
    throw std::runtime_error("the starting point was not reached: " + std::string(name_of(event)) +
                             " gives the restart to the other side");
  }
  const std::optional<Vec2> ball_m = all_.back().ball_m;
  if (!ball_m || (*ball_m - case_.ball_m).norm() > kAtPosition_m) {
    throw std::runtime_error("the referee places the ball elsewhere");
  }
}

}  // namespace autoref::referee
