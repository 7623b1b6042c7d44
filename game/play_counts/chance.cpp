#include "game/play_counts/chance.hpp"

#include <algorithm>
#include <cmath>

#include "game/play_counts/rule_book_models.hpp"
#include "soccer/geometry.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"
#include "soccer/units.hpp"

namespace autoref::game {
namespace {

// Number of parts of the goal's width that are checked for robots.
constexpr int kGoalParts = 41;
// A robot nearer than this to the ball's path touches the ball.
constexpr double kTouching_m = kRobotRadius_m + kBallRadius_m;

// Limits of the features: beyond them, more does not matter.
constexpr double kLongest_m = 5.0_m;
constexpr double kLongest_s = 1.5_s;
constexpr double kKeeperAside_m = 1.0_m;
constexpr double kKeeperOut_m = 2.0_m;
constexpr double kFastest_mps = 2.0_mps;
constexpr double kKeeperReach_m = 500_mm;
constexpr double kOthersReach_m = 300_mm;

constexpr double kPressure_m = 300_mm;  // pressure falls by a factor of e over this distance

using Robots = decltype(sim::WorldState::robots);

// Calls `action` with every robot except the kicker.
void for_each_except(RobotId kicker, const Robots& robots, const auto& action) {
  for (const Side side : kSides) {
    for (const sim::RobotState& robot : robots[side])
      if (side != kicker.side || robot.number != kicker.number) action(robot);
  }
}

const sim::RobotState* nearest_to(const Vec2& point_m, const auto& robots) {
  const sim::RobotState* nearest = nullptr;
  double distance2 = square(kNoOpponent_m);
  for (const sim::RobotState& robot : robots) {
    const double robot2 = (robot.position_m - point_m).squaredNorm();
    if (robot2 >= distance2) continue;
    distance2 = robot2;
    nearest = &robot;
  }
  return nearest;
}

constexpr ChanceModel kModels[] = {
#define AUTOREF_CHANCES(...) {__VA_ARGS__},
#define AUTOREF_CHANCE_MODEL(upper_limit, ...) \
  {                                            \
    upper_limit, { __VA_ARGS__ }               \
  }
#include "game/play_counts/chances.def"
#undef AUTOREF_CHANCE_MODEL
#undef AUTOREF_CHANCES
};

}  // namespace

double widest_opening_rad(RobotId robot, const Vec2& ball_m, const sim::WorldState& now,
                          const Field& field) {
  const Vec2 centre_m = field.goal_centre_m(opponent_of(robot.side));
  const double half_m = field.half_goal_m() - kBallRadius_m;
  // In the order in which the shooter sees them, so that the sums are the same for both teams.
  const double signed_half_m = goal_sign(robot.side) * half_m;
  const auto seen_m = [&](double share) {
    return Vec2(centre_m + Vec2(0, signed_half_m * share) - ball_m);
  };
  double widest_rad = 0;
  double run_rad = 0;
  for (int i = 0; i < kGoalParts; ++i) {
    const double share = (2.0 * i + 1) / kGoalParts - 1;  // the middle of the part
    const double half_part = 1.0 / kGoalParts;
    const Vec2 target_m = ball_m + seen_m(share);
    bool is_covered = false;
    for_each_except(robot, now.robots, [&](const sim::RobotState& other) {
      is_covered |= distance_to_segment(other.position_m, ball_m, target_m) < kTouching_m;
    });
    const double part_rad =
        std::abs(angle_between(seen_m(share - half_part), seen_m(share + half_part)));
    run_rad = is_covered ? 0 : run_rad + part_rad;
    widest_rad = std::max(widest_rad, run_rad);
  }
  return widest_rad;
}

ShotSituation shot_situation(const sim::Touch& kick, const ShotPath& path,
                             const sim::WorldState& now, const Field& field) {
  const Side defenders = opponent_of(kick.robot.side);
  const Vec2 goal_m = field.goal_centre_m(defenders);
  ShotSituation situation;
  situation.path = path;
  situation.distance_m = (goal_m - kick.ball_m).norm();
  situation.time_s = situation.distance_m / std::max(kick.ball_mps.norm(), 1e-3);
  situation.is_chip = kick.vertical_mps > 0;
  situation.opening_rad = widest_opening_rad(kick.robot, kick.ball_m, now, field);
  const sim::RobotState* keeper = nearest_to(goal_m, now.robots[defenders]);
  if (keeper != nullptr) {
    situation.keeper_m = distance_to_segment(keeper->position_m, kick.ball_m, goal_m);
    situation.keeper_out_m = (keeper->position_m - goal_m).norm();
    situation.keeper_mps = keeper->velocity_mps.norm();
    situation.keeper_to_path_m =
        distance_to_segment(keeper->position_m, kick.ball_m, path.crossing_m);
  }
  if (const sim::RobotState* nearest = nearest_to(kick.ball_m, now.robots[defenders]))
    situation.opponent_m = (nearest->position_m - kick.ball_m).norm();
  for_each_except(kick.robot, now.robots, [&](const sim::RobotState& robot) {
    if (&robot == keeper) return;
    situation.others_to_path_m =
        std::min(situation.others_to_path_m,
                 distance_to_segment(robot.position_m, kick.ball_m, path.crossing_m));
  });
  return situation;
}

std::array<double, kChanceFeatures> chance_features(const ShotSituation& situation) {
  return {1,
          std::sqrt(situation.opening_rad),
          std::min(situation.distance_m / kLongest_m, 1.0),
          std::min(situation.time_s, kLongest_s),
          std::min(situation.keeper_m, kKeeperAside_m),
          std::min(situation.keeper_out_m, kKeeperOut_m),
          std::min(situation.keeper_mps, kFastest_mps),
          exponential(-situation.opponent_m / kPressure_m),
          situation.is_chip ? 1.0 : 0.0};
}

std::array<double, kTargetFeatures> target_features(const ShotSituation& situation) {
  const double keeper_m = std::min(situation.keeper_to_path_m, kKeeperReach_m);
  const double others_m = std::min(situation.others_to_path_m, kOthersReach_m);
  const double time_s = std::min(situation.path.time_s, kLongest_s);
  return {1,
          keeper_m,
          others_m,
          time_s,
          square(time_s),
          keeper_m * time_s,
          others_m * time_s,
          keeper_m < kTouching_m ? 1.0 : 0.0,
          others_m < kTouching_m ? 1.0 : 0.0,
          std::min(situation.keeper_mps, kFastest_mps),
          exponential(-situation.opponent_m / kPressure_m),
          situation.is_chip ? 1.0 : 0.0};
}

double ChanceModel::chance(const ShotSituation& situation) const {
  return without_path.probability(chance_features(situation));
}

double ChanceModel::chance_on_target(const ShotSituation& situation) const {
  return situation.path.is_on_target ? with_path.probability(target_features(situation)) : 0;
}

std::span<const ChanceModel> chance_models() { return kModels; }

const ChanceModel& chance_model(std::string_view rules) {
  return model_for(rules, chance_models());
}

}  // namespace autoref::game
