#include "game/play_counts/situation_value.hpp"

#include <algorithm>
#include <cmath>

#include "game/play_counts/rule_book_models.hpp"
#include "soccer/trigonometry.hpp"
#include "soccer/units.hpp"

namespace autoref::game {
namespace {

// Over these distances, the influence of a robot near the ball, and that of the ball's distance
// from the opponents' goal, fall by a factor of e.
constexpr double kAtBall_m = 300_mm;
constexpr double kNearGoal_m = 2.0_m;
constexpr double kFastBall_mps = 4.0_mps;  // a faster ball does not matter more
constexpr int kMostRobotsMore = 3;

constexpr ValueModel kValueModels[] = {
#define AUTOREF_SITUATION_VALUES(...) {__VA_ARGS__},
#define AUTOREF_COEFFICIENTS(...) \
  { __VA_ARGS__ }
#include "game/play_counts/situation_values.def"
#undef AUTOREF_COEFFICIENTS
#undef AUTOREF_SITUATION_VALUES
};

struct NearestRobot {
  int number = -1;  // if no robot is within kNoOpponent_m
  double distance_m = kNoOpponent_m;
};

NearestRobot nearest_robot(const sim::WorldState& now, Side side) {
  NearestRobot nearest;
  for (const sim::RobotState& robot : now.robots[side]) {
    const double distance_m = (robot.position_m - now.ball.position_m).norm();
    if (distance_m < nearest.distance_m) nearest = {robot.number, distance_m};
  }
  return nearest;
}

// 1 for a robot at the ball, 0 for one far away.
double closeness(double distance_m) { return exponential(-distance_m / kAtBall_m); }

}  // namespace

std::array<double, kValueFeatures> value_features(const BallOwner& owner,
                                                  const sim::WorldState& now, const Field& field) {
  const Side opponents = opponent_of(owner.team);
  const auto more_robots = static_cast<double>(std::clamp(
      static_cast<int>(std::ssize(now.robots[owner.team]) - std::ssize(now.robots[opponents])),
      -kMostRobotsMore, kMostRobotsMore));
  if (owner.is_restart) return {1, 0, 1, owner.is_penalty ? 1.0 : 0, 0, 0, 0, 0, 0, more_robots};
  const Vec2 ball_m = now.ball.position_m;
  const double forward = -goal_sign(owner.team);
  const NearestRobot own = nearest_robot(now, owner.team);
  const double opening_rad = widest_opening_rad({owner.team, own.number}, ball_m, now, field);
  const double goal_m = (field.goal_centre_m(opponents) - ball_m).norm();
  const double forward_mps = forward * now.ball.velocity_mps.x();
  return {1,
          forward * ball_m.x() / field.half_length_m(),
          0,
          0,
          exponential(-goal_m / kNearGoal_m),
          std::sqrt(opening_rad),
          closeness(nearest_robot(now, opponents).distance_m),
          closeness(own.distance_m),
          std::clamp(forward_mps / kFastBall_mps, -1.0, 1.0),
          more_robots};
}

SituationValue ValueModel::value(const std::array<double, kValueFeatures>& features,
                                 std::optional<double> shot_chance) const {
  const SituationValue value = {probability(scores, features), probability(concedes, features)};
  // The two models are fitted separately.
  const double sum = std::max(value.scores + value.concedes, 1.0);
  const double shot = shot_chance.value_or(0);
  return {shot + (1 - shot) * value.scores / sum, (1 - shot) * value.concedes / sum};
}

const ValueModel& value_model(std::string_view rules) {
  return model_for<ValueModel>(rules, kValueModels);
}

}  // namespace autoref::game
