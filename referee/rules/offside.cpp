// The offside rule, for experiments. It is not part of any of the league's rule books.
// referee/README.md contains AutoRef's definition.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "referee/rules/rule.hpp"

namespace autoref::referee {
namespace {

// A robot is offside only if it is nearer to the opponents' goal line than the second-last
// opponent, the ball and the halfway line are, by more than this number of standard deviations of
// both positions.
constexpr double kOffsideBeyondNoise = 3;

// The second-largest distance of a side's robots from the halfway line towards their own goal;
// nullopt if vision sees fewer than two robots.
std::optional<double> second_last_m(const SeenRobots& robots, double end) {
  if (robots.size() < 2) return std::nullopt;
  boost::container::static_vector<double, kMaxRobots> depths_m;
  for (const RobotObservation& robot : robots) depths_m.push_back(end * robot.position_m.x());
  std::nth_element(depths_m.begin(), depths_m.begin() + 1, depths_m.end(), std::greater<>());
  return depths_m[1];
}

// The robots of `side` in an offside position while the ball is at `ball_m`.
RobotSet offside_robots(Side side, const PerSide<SeenRobots>& robots, const Vec2& ball_m,
                        const tracking::VisionNoise& noise) {
  const Side opponents = opponent_of(side);
  const double end = goal_sign(opponents);
  RobotSet offside;
  const std::optional<double> last_m = second_last_m(robots[opponents], end);
  if (!last_m) return offside;
  const double noise_m =
      kOffsideBeyondNoise * std::sqrt(2.0) * std::max(noise.robot_m, noise.ball_m);
  const double line_m = std::max({0.0, *last_m, end * ball_m.x()}) + noise_m;
  for (const RobotObservation& robot : robots[side]) {
    if (end * robot.position_m.x() > line_m) offside.add({side, robot.number});
  }
  return offside;
}

// Records which robots are in an offside position during the newest touch.
void watch(OffsideWatch& watch, const TouchHistory& touches, const RefereeInput& input) {
  const BallTouch& touch = *touches.newest();
  OffsideWatch::Pass& newest = watch.newest;
  if (newest.touch == touches.count() && newest.ended_s == touch.ended_s) return;
  // A pass is judged when it is received, which is the next touch. So the newest touch and the one
  // before it are kept.
  if (newest.touch < touches.count()) watch.before = newest;
  newest = {touches.count(), touch.ended_s, Side::kWest, {}};
  if (!touch.side) return;
  newest.side = *touch.side;
  newest.offside = offside_robots(*touch.side, input.frames.robots_at(touch.ended_s), touch.ended_m,
                                  input.configuration.noise);
}

std::optional<Finding> find_offside(RefereeState& state, const RefereeInput& input) {
  const TouchHistory& touches = state.play.touches;
  if (touches.newest() == nullptr) return std::nullopt;
  watch(state.watch.offside, touches, input);
  const OffsideWatch::Pass& pass = state.watch.offside.before;
  // A pass straight from a restart is never offside.
  const bool is_pass = touches.has(1) && pass.touch == touches.count() - 1 && pass.touch > 1;
  if (!is_pass || pass.ended_s != touches.at(1).ended_s) return std::nullopt;
  const BallTouch& received = *touches.newest();
  if (!received.robot || !touches.at(1).robot || received.side != touches.at(1).side ||
      received.robot == touches.at(1).robot || !is_settled(received, input.time_s()) ||
      !pass.offside.has(*received.robot)) {
    return std::nullopt;
  }
  Finding finding = offence_of(Event::kOffside, RuleId::kOffside, input.configuration,
                               *received.robot, received.began_m);
  finding.robots.push_back(*touches.at(1).robot);
  finding.evidence = fmt::format(
      "{} got the ball from {} and had been in an offside position at that touch, at {:.3f} s.",
      text_of(*received.robot), text_of(*touches.at(1).robot), pass.ended_s);
  return finding;
}

}  // namespace

constinit const Rule kOffsideRule{{State::kRun}, find_offside};

}  // namespace autoref::referee
