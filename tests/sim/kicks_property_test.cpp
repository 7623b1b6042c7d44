// 4000 kicks at 8 m/s at robots, posts and walls.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/sim/bounces.hpp"
#include "tests/sim/chance.hpp"
#include "tests/sim/scene.hpp"

namespace autoref::sim {
namespace {

constexpr double kKick_mps = 8.0;
constexpr double kWatched_s = 0.5;  // after a kick

// A ball aimed at an obstacle, and a robot that may be the obstacle.
struct RandomShot {
  Vec2 from_m{0, 0};
  Vec2 direction{1, 0};
  RobotState robot{.position_m = {0, 0}};
  bool dribbles = false;
};

// A shot at a random point of a robot's outline: a third of the shots anywhere, a third at the
// plate, a third at the plate's corners.
RandomShot at_robot(RandomStream& random) {
  RandomShot shot;
  const double corner_rad = std::asin(kHalfPlate_m / kRobotRadius_m);
  const double part = random.uniform() * 3;
  double bearing_rad = between(random, -kPi, kPi);
  if (part < 1) bearing_rad = between(random, -corner_rad, corner_rad);
  if (part > 2) {
    bearing_rad = std::copysign(corner_rad, bearing_rad) + between(random, -0.1, 0.1);
  }
  shot.robot.heading = heading_of(between(random, -kPi, kPi));
  shot.dribbles = random.uniform() < 0.5;
  const Vec2 target_m = kRobotRadius_m * to_world(heading_of(bearing_rad), shot.robot.heading);
  const double slant_rad = between(random, -1.2, 1.2);
  shot.direction = to_world(heading_of(slant_rad), -target_m.normalized());
  shot.from_m = target_m - between(random, 0.1, 0.5) * shot.direction;
  return shot;
}

// A shot at a moving robot, aimed so that the ball still hits it.
RandomShot at_driving_robot(RandomStream& random, double least_mps, double most_mps) {
  RandomShot shot = at_robot(random);
  const double path_s = shot.from_m.norm() / kKick_mps;
  shot.robot.velocity_mps = shot.direction * between(random, least_mps, most_mps);
  shot.from_m += shot.robot.velocity_mps * path_s;
  return shot;
}

RandomShot at_standing_robot(RandomStream& random) { return at_robot(random); }
RandomShot at_coming_robot(RandomStream& random) { return at_driving_robot(random, -3, -0.5); }
RandomShot at_leaving_robot(RandomStream& random) { return at_driving_robot(random, 0.5, 3); }
RandomShot at_spinning_robot(RandomStream& random) {
  RandomShot shot = at_robot(random);
  shot.robot.angular_velocity_radps = between(random, -15, 15);
  return shot;
}

// A shot from a random position in one box towards a random position in another. Both boxes are in
// the quarter of the field with positive x and y; the shot is then mirrored to a random quarter.
// The robot is elsewhere.
RandomShot from_box_to_box(RandomStream& random, const Vec2& from_low_m, const Vec2& from_high_m,
                           const Vec2& to_low_m, const Vec2& to_high_m) {
  const double turned_x = random.uniform() < 0.5 ? -1 : 1;
  const double turned_y = random.uniform() < 0.5 ? -1 : 1;
  const Vec2 turned(turned_x, turned_y);
  const auto position_in = [&random](const Vec2& low_m, const Vec2& high_m) {
    const double x = between(random, low_m.x(), high_m.x());
    const double y = between(random, low_m.y(), high_m.y());
    return Vec2(x, y);
  };
  const Vec2 from_m = position_in(from_low_m, from_high_m);
  const Vec2 to_m = position_in(to_low_m, to_high_m);
  RandomShot shot;
  shot.from_m = from_m.cwiseProduct(turned);
  shot.direction = (to_m - from_m).cwiseProduct(turned).normalized();
  return shot;
}

// The field: lines at x = 3.025 and y = 2.025, walls at 3.7 and 2.7; the goal's side wall from y =
// 0.35 to 0.37, its back from x = 3.205 to 3.225.
RandomShot at_field_walls(RandomStream& random) {
  const bool along = random.uniform() < 0.5;
  return along ? from_box_to_box(random, {2, 0.5}, {3.6, 2.6}, {3.7, 0.5}, {3.7, 2.7})
               : from_box_to_box(random, {0.2, 1.5}, {3.6, 2.6}, {0.2, 2.7}, {3.7, 2.7});
}
RandomShot at_posts(RandomStream& random) {
  return from_box_to_box(random, {2.2, 0.2}, {2.9, 1.2}, {3.025, 0.34}, {3.03, 0.38});
}
RandomShot at_goal_sides_from_inside(RandomStream& random) {
  return from_box_to_box(random, {3.06, -0.3}, {3.18, 0.3}, {3.05, 0.35}, {3.2, 0.35});
}
RandomShot at_goal_sides_from_outside(RandomStream& random) {
  return from_box_to_box(random, {2.8, 0.5}, {3.6, 1.5}, {3.04, 0.37}, {3.22, 0.37});
}
RandomShot at_goal_backs(RandomStream& random) {
  const bool inside = random.uniform() < 0.5;
  return inside ? from_box_to_box(random, {2.5, 0.0}, {3.15, 0.3}, {3.205, 0.0}, {3.205, 0.34})
                : from_box_to_box(random, {3.3, 0.0}, {3.6, 1.0}, {3.225, 0.0}, {3.225, 0.36});
}

struct Target {
  const char* name;
  int kicks;
  double most_kept;  // fraction of the normal speed: 0.55 at a body, 0.3 at a wall, plus a margin
  RandomShot (*shoot)(RandomStream& random);
};

class HardShot : public Scene {
 public:
  HardShot(const Configuration& configuration, const RandomShot& shot)
      : Scene(configuration, specs(1, 0)) {
    world.put_robot(kWest0, shot.robot);
    put_ball(shot.from_m, kKick_mps * shot.direction);
    command(kWest0).velocity_mps = to_local(shot.robot.velocity_mps, shot.robot.heading);
    command(kWest0).angular_velocity_radps = shot.robot.angular_velocity_radps;
    command(kWest0).dribble = shot.dribbles;
  }
};

// Extremes of one kick, over all observed sub-steps or frames.
struct Seen {
  double deepest_m = 0;  // penetration of the ball's surface into a body or wall
  double least_path_m = std::numeric_limits<double>::infinity();  // path of the ball's centre
  int hits = 0;
  double gained_mps = -kKick_mps;  // along the normal, by impacts, beyond the effect of forces
  double most_kept = 0;            // fraction of the normal speed kept, if above 1 m/s
};

void note_depth(const HardShot& scene, Seen& seen) {
  const Vec2& at_m = scene.ball().position_m;
  const double nearest_m =
      std::min(distance_to_robot(scene.robot(kWest0), at_m), distance_to_walls(scene.field, at_m));
  seen.deepest_m = std::max(seen.deepest_m, kBallRadius_m - nearest_m);
}

void note_bounce(const Bounce& bounce, double forced_mps, Seen& seen) {
  ++seen.hits;
  seen.gained_mps =
      std::max(seen.gained_mps, bounce.after_mps - std::abs(bounce.before_mps) - forced_mps);
  if (bounce.before_mps > -1.0) return;
  seen.most_kept = std::max(seen.most_kept, (bounce.after_mps - forced_mps) / -bounce.before_mps);
}

void note_bounces(const HardShot& scene, const BallState& former, const RobotState& former_robot,
                  Seen& seen) {
  const Configuration configuration;
  const BallState& ball = scene.ball();
  if (!scene.world.touches().empty()) {
    const bool dribbles = scene.commands[Side::kWest][0].dribble;
    note_bounce(bounce_off_robot(former, ball, former_robot, scene.robot(kWest0)),
                forced_mps(configuration.ball, quiet_robot(), dribbles), seen);
    return;
  }
  const double carpet_mps = configuration.ball.slide_mps2 * kSubstep_s;
  const double net_mps = configuration.ball.net_mps2 * kSubstep_s;
  const bool is_hit =
      (ball.velocity_mps - former.velocity_mps).norm() > carpet_mps + net_mps + 0.01;
  if (is_hit) note_bounce(bounce_off_walls(scene.field, former, ball), carpet_mps, seen);
}

Seen watch_substeps(const RandomShot& shot) {
  HardShot scene(every_substep(quiet()), shot);
  Seen seen;
  for (int k = 0; k < std::lround(kWatched_s / kSubstep_s); ++k) {
    const BallState former = scene.ball();
    const RobotState former_robot = scene.robot(kWest0);
    scene.frame();
    note_depth(scene, seen);
    note_bounces(scene, former, former_robot, seen);
    const auto distance_m = [&](const Vec2& point_m, double share) {
      return std::min(distance_to_robot(moved_on(former_robot, share * kSubstep_s), point_m),
                      distance_to_walls(scene.field, point_m));
    };
    seen.least_path_m = std::min(
        seen.least_path_m, least_on_path_m(former.position_m, scene.ball().position_m, distance_m));
  }
  return seen;
}

// Between frames a robot may turn by a quarter of a radian, so its outline is approximated by a
// disc inside the hull.
Seen watch_frames(const RandomShot& shot) {
  constexpr double kWithin_m = kFrontDistance_m;
  HardShot scene(quiet(), shot);
  Seen seen;
  for (int f = 0; f < std::lround(kWatched_s * 60); ++f) {
    const Vec2 former_m = scene.ball().position_m;
    const Vec2 former_robot_m = scene.robot(kWest0).position_m;
    scene.frame();
    note_depth(scene, seen);
    const Vec2 robot_path_m = scene.robot(kWest0).position_m - former_robot_m;
    const auto distance_m = [&](const Vec2& point_m, double share) {
      const Vec2 robot_m = former_robot_m + share * robot_path_m;
      return std::min((point_m - robot_m).norm() - kWithin_m,
                      distance_to_walls(scene.field, point_m));
    };
    seen.least_path_m =
        std::min(seen.least_path_m, least_on_path_m(former_m, scene.ball().position_m, distance_m));
  }
  return seen;
}

constexpr double kSunk_m = 3_mm;  // the solver allows up to 2 mm

class FourThousandKicks : public testing::TestWithParam<Target> {};

// The numbers of the kicks whose ball gets too deep into a body or wall, or passes through it.
std::vector<int> kicks_that_sink(const Target& target, Seen (*watch)(const RandomShot&)) {
  RandomStream random(21);
  std::vector<int> sunk;
  for (int i = 0; i < target.kicks; ++i) {
    const Seen seen = watch(target.shoot(random));
    const bool is_outside = seen.deepest_m < kSunk_m && seen.least_path_m > kBallRadius_m - kSunk_m;
    if (!is_outside) sunk.push_back(i);
  }
  return sunk;
}
const std::vector<int> kNone;

// No ball gets stuck either: at the end of every sub-step it penetrates a body by at most 3 mm.
TEST_P(FourThousandKicks, NeverPassThroughABodyOrWall) {
  EXPECT_EQ(kicks_that_sink(GetParam(), watch_substeps), kNone);
}

TEST_P(FourThousandKicks, NeverPassThroughABodyOrWallInTheDefaultWorld) {
  EXPECT_EQ(kicks_that_sink(GetParam(), watch_frames), kNone);
}

TEST_P(FourThousandKicks, NeverLeaveFasterThanTheyCame) {
  RandomStream random(21);
  int hits = 0;
  for (int i = 0; i < GetParam().kicks; ++i) {
    const Seen seen = watch_substeps(GetParam().shoot(random));
    ASSERT_LE(seen.gained_mps, 0.0) << i;
    ASSERT_LT(seen.most_kept, GetParam().most_kept) << i;
    hits += seen.hits;
  }
  EXPECT_GT(hits, 0.9 * GetParam().kicks);
}

INSTANTIATE_TEST_SUITE_P(
    Targets, FourThousandKicks,
    testing::Values(Target{"StandingRobot", 800, 0.6, at_standing_robot},
                    Target{"ComingRobot", 600, 0.6, at_coming_robot},
                    Target{"LeavingRobot", 600, 0.6, at_leaving_robot},
                    Target{"SpinningRobot", 600, 0.6, at_spinning_robot},
                    Target{"FieldWalls", 400, 0.35, at_field_walls},
                    Target{"Posts", 300, 0.35, at_posts},
                    Target{"GoalSidesFromInside", 250, 0.35, at_goal_sides_from_inside},
                    Target{"GoalSidesFromOutside", 250, 0.35, at_goal_sides_from_outside},
                    Target{"GoalBacks", 200, 0.35, at_goal_backs}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace autoref::sim
