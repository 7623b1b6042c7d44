// A robot dribbles the ball over more than 500 mm (in later editions, 1 m), "measured linearly from
// the ball location where the dribbling started" (Laws 12; 2026). Dribbling begins with the first
// contact and ends with an observable separation.
#include <fmt/format.h>

#include "referee/rules/rule.hpp"
#include "referee/touch/touch_candidates.hpp"

namespace autoref::referee {
namespace {

// If the dribbles of both sides differ by less than this, they count as equally long (rounding).
constexpr double kSame_m = 1e-9;

struct Dribble {
  std::optional<RobotId> robot;
  double path_m = 0;
  bool is_tied = false;  // a robot of the other side has dribbled equally far
};

// Records where the ball was when each robot gained it.
void watch_side(DribblingWatch& watch, const RefereeInput& input, Side side) {
  const auto former = watch.ball_from_m[side];
  auto& ball_from_m = watch.ball_from_m[side];
  ball_from_m.fill(std::nullopt);
  const TrackedBall& ball = *input.tracks.ball;
  for (const TrackedRobot& robot : input.tracks.robots[side]) {
    const auto number = static_cast<std::size_t>(robot.number);
    const bool had = former[number].has_value();
    // has_ball() has hysteresis: `had` widens its limits, so that noise does not end a dribble.
    if (!has_ball(robot, ball, had, input.configuration.noise)) continue;
    ball_from_m[number] = had ? former[number] : ball.position_m;
  }
}

void take_in(Dribble& longest, RobotId robot, double path_m) {
  if (path_m < longest.path_m - kSame_m) return;
  const bool is_longer = path_m > longest.path_m + kSame_m;
  longest.is_tied =
      !is_longer && longest.robot && (longest.is_tied || longest.robot->side != robot.side);
  longest.robot = robot;
  longest.path_m = path_m;
}

Dribble longest_dribble(const DribblingWatch& watch, const Vec2& ball_m) {
  Dribble longest;
  for (const Side side : kSides) {
    for (int number = 0; number < kMaxRobots; ++number) {
      const auto& from_m = watch.ball_from_m[side][static_cast<std::size_t>(number)];
      if (from_m) take_in(longest, {side, number}, (ball_m - *from_m).norm());
    }
  }
  return longest;
}

std::optional<Finding> find_bot_dribbled_ball_too_far(RefereeState& state,
                                                      const RefereeInput& input) {
  if (!input.tracks.ball) return std::nullopt;
  DribblingWatch& watch = state.watch.bot_dribbled_ball_too_far;
  for (const Side side : kSides) watch_side(watch, input, side);
  const Configuration& c = input.configuration;
  const Vec2& ball_m = input.tracks.ball->position_m;
  const Dribble dribble = longest_dribble(watch, ball_m);
  if (!dribble.robot || dribble.is_tied || dribble.path_m <= c.rules.dribbling_m) {
    return std::nullopt;
  }
  Finding finding = offence_of(Event::kBotDribbledBallTooFar, RuleId::kBotDribbledBallTooFar, c,
                               *dribble.robot, ball_m);
  finding.value = dribble.path_m;
  finding.details.dribble_from_m =
      watch.ball_from_m[dribble.robot->side][static_cast<std::size_t>(dribble.robot->number)];
  finding.evidence = fmt::format("{} has dribbled the ball over {:.0f} mm.",
                                 text_of(*dribble.robot), 1e3 * dribble.path_m);
  return finding;
}

}  // namespace

constinit const Rule kBotDribbledBallTooFarRule{{State::kRun}, find_bot_dribbled_ball_too_far};

}  // namespace autoref::referee
