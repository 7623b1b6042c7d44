// An hour of robots that drive randomly, chase the ball, dribble and spin, but do not kick.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <boost/container/static_vector.hpp>
#include <cmath>
#include <iostream>
#include <limits>

#include "tests/sim/bounces.hpp"
#include "tests/sim/chance.hpp"
#include "tests/sim/scene.hpp"

namespace autoref::sim {
namespace {

constexpr int kRobots = 6;                    // per side
constexpr int kPlayed_s = AUTOREF_TRAFFIC_S;  // an hour, or 1/30 of it if sanitizers slow it down

// Robots with random behaviour: each chases the ball, drives to a position or spins, with its
// dribbler on or off, for a random time. A ball that lies at a wall or that no robot reaches is
// replaced.
class Traffic : public Scene {
 public:
  explicit Traffic(const Configuration& configuration)
      : Scene(configuration, specs(kRobots, kRobots)), rate_hz_(configuration.frame_rate_hz) {}

  // Gives new commands, and replaces a lost ball.
  void steer() {
    for (const Side side : kSides) {
      for (int n = 0; n < kRobots; ++n) decide({side, n});
    }
    if (idle_s_ > 1.0) throw_in();
  }

  void step() {
    frame();
    const bool is_free = distance_to_walls(field, ball().position_m) > 0.1;
    const bool is_touched = !world.touches().empty();
    idle_s_ = is_free && is_touched ? 0.0 : idle_s_ + (is_free ? 0.2 : 1.0) / rate_hz_;
  }

 private:
  enum class Kind { kChase, kDrive, kSpin };
  struct Whim {
    std::int64_t until = 0;  // frame
    Kind kind = Kind::kChase;
    bool dribbles = false;
    Vec2 target_m{0, 0};
    double speed_mps = 0;
    double turn_radps = 0;
  };

  void think(Whim& whim) {
    whim.until = world.state().frame + std::lround(between(random_, 0.2, 3) * rate_hz_);
    const double kind = random_.uniform();
    whim.kind = kind < 0.5 ? Kind::kChase : kind < 0.8 ? Kind::kDrive : Kind::kSpin;
    whim.dribbles = random_.uniform() < 0.5;
    const double x = between(random_, -field.wall_x_m(), field.wall_x_m());
    const double y = between(random_, -field.wall_y_m(), field.wall_y_m());
    whim.target_m = {x, y};
    whim.speed_mps = between(random_, 0.2, 3);
    whim.turn_radps = between(random_, -15, 15);
  }

  void decide(RobotId id) {
    Whim& whim = whims_[id.side][static_cast<std::size_t>(id.number)];
    if (world.state().frame >= whim.until) think(whim);
    const RobotState& its = robot(id);
    const Vec2 target_m = whim.kind == Kind::kChase ? ball().position_m : whim.target_m;
    const Vec2 direction = direction_of(target_m - its.position_m, its.heading);
    RobotCommand& command = this->command(id);
    command.velocity_mps = to_local(direction * whim.speed_mps, its.heading);
    command.angular_velocity_radps =
        whim.kind == Kind::kSpin ? whim.turn_radps : 6.0 * angle_between(its.heading, direction);
    command.dribble = whim.dribbles;
  }

  void throw_in() {
    const double x = between(random_, -2.5, 2.5);
    const double y = between(random_, -1.5, 1.5);
    for (const auto& robots : world.state().robots.values) {
      for (const RobotState& its : robots) {
        if ((its.position_m - Vec2(x, y)).norm() < 0.13) return;
      }
    }
    const Vec2 direction = heading_of(between(random_, -kPi, kPi));
    put_ball({x, y}, between(random_, 0, 8) * direction);
    idle_s_ = 0.0;
  }

  double rate_hz_;
  RandomStream random_{32};
  PerSide<std::array<Whim, kRobots>> whims_;
  double idle_s_ = 0.0;
};

// The longest duration of a condition, in frames.
class Spell {
 public:
  void note(bool goes_on) {
    now_ = goes_on ? now_ + 1 : 0;
    longest_ = std::max(longest_, now_);
  }
  int longest() const { return longest_; }

 private:
  int now_ = 0;
  int longest_ = 0;
};

// The worst values over all states of the traffic.
class Watch {
 public:
  void note(const Traffic& traffic) {
    const WorldState& state = traffic.world.state();
    is_finite = is_finite && traffic.world.is_finite();
    nearest_wall_m =
        std::min(nearest_wall_m, distance_to_walls(traffic.field, state.ball.position_m));
    boost::container::static_vector<RobotState, 2 * kRobots> all;
    for (const auto& robots : state.robots.values)
      all.insert(all.end(), robots.begin(), robots.end());
    std::size_t pair = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      nearest_robot_m = std::min(nearest_robot_m, distance_to_robot(all[i], state.ball.position_m));
      robots_out_m = std::max(robots_out_m,
                              kRobotRadius_m - distance_to_walls(traffic.field, all[i].position_m));
      for (std::size_t k = 0; k < i; ++k) {
        const double overlap_m =
            2 * kRobotRadius_m - (all[i].position_m - all[k].position_m).norm();
        most_overlap_m = std::max(most_overlap_m, overlap_m);
        overlaps_[pair].note(overlap_m > 5_mm);
        longest_overlap = std::max(longest_overlap, overlaps_[pair++].longest());
      }
    }
  }

  bool is_finite = true;
  double nearest_wall_m = std::numeric_limits<double>::infinity();  // of the ball's centre
  double nearest_robot_m = std::numeric_limits<double>::infinity();
  double robots_out_m = 0;  // penetration of their hulls into walls
  double most_overlap_m = 0;
  int longest_overlap = 0;  // deeper than 5 mm, in frames

 private:
  std::array<Spell, kRobots*(2 * kRobots - 1)> overlaps_;
};

const RobotState& robot_of(const WorldState& state, RobotId id) {
  return state.robots[id.side][static_cast<std::size_t>(id.number)];
}

// The maximum velocity change in a sub-step by the carpet and by dribblers that may hold the ball.
double pulled_mps(const WorldState& former, const Traffic& traffic) {
  const Configuration configuration;
  double force_n = 0.0;
  for (const Side side : kSides) {
    for (const RobotState& robot : former.robots[side]) {
      const bool dribbles = traffic.commands[side][static_cast<std::size_t>(robot.number)].dribble;
      const bool is_near = (robot.position_m - former.ball.position_m).norm() < 0.2;
      if (dribbles && is_near) force_n += quiet_robot().dribbler.force_n;
    }
  }
  return kSubstep_s * (configuration.ball.slide_mps2 + force_n / configuration.ball.mass_kg);
}

// The change of the velocity of a robot's surface.
double surface_change_mps(const RobotState& before, const RobotState& after) {
  return (after.velocity_mps - before.velocity_mps).norm() +
         kRobotRadius_m * std::abs(after.angular_velocity_radps - before.angular_velocity_radps);
}

// The part of a ball's tangential motion along a robot that becomes radial, because both rotate
// within a sub-step.
double turned_mps(const BallState& ball, const RobotState& robot) {
  const Vec2 arm_m = ball.position_m - robot.position_m;
  const Vec2 relative_mps =
      ball.velocity_mps - robot.velocity_mps - robot.angular_velocity_radps * left_of(arm_m);
  const double along_mps = std::abs(cross(arm_m.normalized(), relative_mps));
  return along_mps * kSubstep_s *
         (std::abs(robot.angular_velocity_radps) + along_mps / kRobotRadius_m);
}

// The ball's speed gains from impacts beyond the allowed limits; at most 0 if correct.
class Gains {
 public:
  void note(const WorldState& former, const Traffic& traffic) {
    const WorldState& now = traffic.world.state();
    const double reach_m = kBallRadius_m + 1_mm + former.ball.velocity_mps.norm() * kSubstep_s;
    const bool meets_wall = distance_to_walls(traffic.field, former.ball.position_m) < reach_m;
    const auto touches = traffic.world.touches();
    if (touches.empty()) {
      if (!meets_wall) return;
      note_bounce(bounce_off_walls(traffic.field, former.ball, now.ball),
                  pulled_mps(former, traffic));
      return;
    }
    const RobotState& before = robot_of(former, touches[0].robot);
    const RobotState& after = robot_of(now, touches[0].robot);
    const double change_mps = surface_change_mps(before, after);
    const double recoil_mps = (now.ball.velocity_mps - former.ball.velocity_mps).norm() *
                              BallParameters{}.mass_kg / RobotParameters{}.mass_kg;
    if (touches.size() > 1 || meets_wall || change_mps > kDriven_mps + 3 * recoil_mps) {
      note_squeeze(former, traffic);
      return;
    }
    note_bounce(bounce_off_robot(former.ball, now.ball, before, after),
                pulled_mps(former, traffic) + change_mps + turned_mps(former.ball, before));
  }

  int bounces = 0;            // at one robot or wall
  int squeezes = 0;           // between several, or at a robot that was itself hit
  double bounced_mps = -10;   // along the normal, in addition to its speed before
  double squeezed_mps = -10;  // over ground

 private:
  // Twice the effect of braking at 5 m/s^2 and turning at 40 rad/s^2. If a robot's motion changes
  // by more than this plus three times the ball's recoil (to allow for rotation), the robot has
  // collided.
  static constexpr double kDriven_mps = 2 * kSubstep_s * (5.0 + 40.0 * kRobotRadius_m);

  void note_bounce(const Bounce& bounce, double allowed_mps) {
    ++bounces;
    bounced_mps =
        std::max(bounced_mps, bounce.after_mps - std::abs(bounce.before_mps) - allowed_mps);
  }

  // A surface moving at s adds at most (1 + 0.55) s to the speed of a ball it hits. Within a
  // sub-step a ball may be hit twice, by a robot that is itself hit as well.
  void note_squeeze(const WorldState& former, const Traffic& traffic) {
    constexpr double kNear_m = 3 * kRobotRadius_m + kBallRadius_m + 30_mm;
    ++squeezes;
    const WorldState& now = traffic.world.state();
    double surfaces_mps = 0.0;
    for (const Side side : kSides) {
      for (const RobotState& robot : now.robots[side]) {
        if ((robot.position_m - now.ball.position_m).norm() > kNear_m) continue;
        const RobotState& before = robot_of(former, {side, robot.number});
        surfaces_mps += std::max(fastest_mps(before), fastest_mps(robot));
      }
    }
    const double gained_mps = now.ball.velocity_mps.norm() - former.ball.velocity_mps.norm();
    squeezed_mps =
        std::max(squeezed_mps, gained_mps - 2 * 1.55 * surfaces_mps - pulled_mps(former, traffic));
  }

  static double fastest_mps(const RobotState& robot) {
    return robot.velocity_mps.norm() + kRobotRadius_m * std::abs(robot.angular_velocity_radps);
  }
};

constexpr double kSolver_mps = 0.01;  // residual error of the iterative solver

// Squeezed by robots of 2.5 kg, the ball penetrates by up to 3 mm. Two robots that collide at 6 m/s
// may overlap by the 25 mm that they travel in a sub-step, and separate within a few.
void expect_bodies_apart(const Watch& watch, double rate_hz) {
  EXPECT_TRUE(watch.is_finite);
  EXPECT_GT(watch.nearest_wall_m, kBallRadius_m - 4_mm);
  EXPECT_GT(watch.nearest_robot_m, kBallRadius_m - 4_mm);
  EXPECT_LT(watch.robots_out_m, 5_mm);
  EXPECT_LT(watch.most_overlap_m, 25_mm);
  EXPECT_LE(watch.longest_overlap, 0.05 * rate_hz);
}

// Plays for `seconds` and observes the world after every frame.
void play(Traffic& traffic, double seconds, double rate_hz, Watch& watch, Gains* gains = nullptr) {
  for (std::int64_t f = 0; f < std::lround(seconds * rate_hz); ++f) {
    traffic.steer();
    const WorldState former = traffic.world.state();
    traffic.step();
    watch.note(traffic);
    if (gains != nullptr) gains->note(former, traffic);
  }
}

TEST(Traffic, OfAnHourKeepsBodiesApartAndNeverSpeedsTheBallUp) {
  Traffic traffic(every_substep(quiet()));
  Watch watch;
  Gains gains;
  play(traffic, kPlayed_s, 1 / kSubstep_s, watch, &gains);
  expect_bodies_apart(watch, 1 / kSubstep_s);
  EXPECT_LE(gains.bounced_mps, kSolver_mps);
  EXPECT_LE(gains.squeezed_mps, kSolver_mps);
  EXPECT_GT(gains.bounces, 10 * kPlayed_s);
  std::cout << fmt::format("played {} s: {} sub-steps at one robot or wall, {} squeezed\n",
                           kPlayed_s, gains.bounces, gains.squeezes);
}

TEST(Traffic, OfAnHourKeepsBodiesApartInTheDefaultWorld) {
  const Configuration configuration = quiet();
  Traffic traffic(configuration);
  Watch watch;
  play(traffic, kPlayed_s, configuration.frame_rate_hz, watch);
  expect_bodies_apart(watch, configuration.frame_rate_hz);
}

}  // namespace
}  // namespace autoref::sim
