// The world's ball: kicks, dribblers, ball placement, nets and motion in the third dimension.
#include <algorithm>
#include <cmath>

#include "sim/ball.hpp"
#include "sim/kicker.hpp"
#include "sim/world_impl.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::sim {
namespace {

// Changes of the ball's velocity that are smaller than this are rounding errors, not collisions.
constexpr double kCollision_mps = 0.01;

}  // namespace

// Moves the carried ball by setting its velocity along the path rather than its position.
void World::Impl::hold_ball() {
  ball_.hold(step_s_);
  const BodyState& ball = bodies_.ball();
  if (hold_ == Hold::kCatching) {
    bodies_.let_ball_meet(false, ball_.height_m() < field_.goal_opening_height_m);
    const double speed_mps = ball.velocity_mps.norm();
    const double left_mps = speed_mps - configuration_.placement.catch_mps2 * step_s_;
    if (left_mps > 0.0) {
      bodies_.set_ball_velocity(ball.velocity_mps * (left_mps / speed_mps));
      return;
    }
    hold_ = Hold::kCarrying;
    carrier_.start(ball.position_m, placement_.target_m);
    bodies_.let_ball_meet(false, false);
  }
  const Vec2 path_m = carrier_.carry(step_s_) - ball.position_m;
  const bool is_there = path_m.norm() < 1e-6;
  bodies_.set_ball_velocity(is_there ? Vec2(0.0, 0.0) : Vec2(path_m / step_s_));
}

void World::Impl::move_ball(int substep) {
  const std::optional<Vec2> kick_mps = kicked(substep);
  const Pulls all = kick_mps ? Pulls{} : pulls();
  const Vec2 ball_mps = kick_mps ? *kick_mps : dribbled(bodies_.ball().velocity_mps, all);
  bodies_.set_ball_velocity(held_by_net(ball_.slowed(ball_mps, step_s_, rest_speed_mps(all))));
}

// The speed below which the ball comes to rest; 0 while a dribbler pulls it that cannot give a ball
// at rest this speed within a step.
double World::Impl::rest_speed_mps(const Pulls& pulls) const {
  const BallParameters& ball = configuration_.ball;
  const auto is_weak = [&](const Pull& pull) {
    // What the carpet leaves of the pull on a ball that starts to roll.
    const double gain_mps2 = ball.switch_ratio * pull.limit_n / ball.mass_kg - ball.roll_mps2;
    return gain_mps2 * step_s_ < ball.rest_mps;
  };
  return std::any_of(pulls.begin(), pulls.end(), is_weak) ? 0.0 : ball.rest_mps;
}

// The ball's velocity after a kick, if there was one. Simultaneous kicks add up, so their order
// does not matter.
std::optional<Vec2> World::Impl::kicked(int substep) {
  const BodyState ball = bodies_.ball();
  Vec2 sum_mps{0.0, 0.0};
  double vertical_mps = 0.0;
  bool is_kicked = false;
  double limit_mps = 0.0;
  const std::size_t first = touches_.size();
  for_each_near_ball([&](RobotId id, Robot& robot, int index) {
    const auto kick = robot.kicker.fire(robot.aim, bodies_.robot(index), ball, ball_.height_m(),
                                        substeps_, team(id.side).kicks);
    if (!kick) return;
    is_kicked = true;
    limit_mps = std::max(limit_mps, robot.kicker.speed_limit_mps());
    sum_mps += kick->velocity_mps;
    vertical_mps = std::max(vertical_mps, kick->vertical_mps);
    // The recoil on the robot, by conservation of momentum.
    bodies_.strike_robot(index,
                         configuration_.ball.mass_kg * (ball.velocity_mps - kick->velocity_mps));
    note({state_.frame + 1, substep, id, ball.position_m, true, {0.0, 0.0}, 0.0});
  });
  if (!is_kicked) return std::nullopt;
  ball_.kick(vertical_mps);
  const Vec2 ball_mps = clamp_norm(sum_mps, limit_mps);
  for (std::size_t i = first; i < touches_.size(); ++i) {
    touches_[i].ball_mps = ball_mps;
    touches_[i].vertical_mps = vertical_mps;
  }
  return ball_mps;
}

// The forces of all dribblers on the ball. A robot that has just kicked releases the ball that it
// held.
World::Impl::Pulls World::Impl::pulls() {
  Pulls pulls;
  const BodyState& ball = bodies_.ball();
  for_each_near_ball([&](RobotId id, Robot& robot, int index) {
    const bool holds = robot.dribbler.holds();
    if (!robot.aim.dribble || (holds && robot.kicker.is_recharging(substeps_))) return;
    const Vec2 force_n = robot.dribbler.force_n(bodies_.robot(index), ball, ball_.height_m(),
                                                step_s_, substeps_, team(id.side).dribblers);
    if (!force_n.isZero(0.0)) pulls.push_back({index, holds, force_n, robot.dribbler.limit_n()});
  });
  return pulls;
}

// The ball's velocity after the pull of all dribblers. Holding dribblers share the force, because
// otherwise two of them would make the ball oscillate.
Vec2 World::Impl::dribbled(Vec2 ball_mps, const Pulls& all) {
  const auto holders = std::count_if(all.begin(), all.end(), [](const Pull& p) { return p.holds; });
  for (const Pull& pull : all) {
    const Vec2 force_n =
        pull.holds ? Vec2(pull.force_n / static_cast<double>(holders)) : pull.force_n;
    ball_mps += force_n * (step_s_ / configuration_.ball.mass_kg);
    // The reaction force acts on the robot at the ball's position, so it also turns the robot.
    bodies_.push_robot_at(pull.index, -force_n, bodies_.ball().position_m);
  }
  return ball_mps;
}

// A net brakes the ball in its goal, but only its motion back towards the field.
Vec2 World::Impl::held_by_net(Vec2 ball_mps) const {
  const Vec2& at_m = bodies_.ball().position_m;
  const double outwards = -std::copysign(1.0, at_m.x());
  const double leaves_mps = ball_mps.x() * outwards;
  if (leaves_mps <= 0.0 || !is_in_goal(field_, at_m)) return ball_mps;
  if (std::abs(at_m.x()) < field_.half_length_m() + kBallRadius_m) return ball_mps;
  ball_mps.x() = outwards * std::max(0.0, leaves_mps - configuration_.ball.net_mps2 * step_s_);
  return ball_mps;
}

// Adds what the planar physics lacks: spin changes in collisions, and the third dimension.
void World::Impl::follow_ball(const BodyState& former) {
  // Box2D applies no forces to the ball, so only a collision changes its velocity in a step.
  const Vec2 change_mps = bodies_.ball().velocity_mps - former.velocity_mps;
  if (change_mps.squaredNorm() > kCollision_mps * kCollision_mps) ball_.collide(change_mps);
  if (!ball_.is_in_air()) return;
  const double former_height_m = ball_.height_m();
  bodies_.set_ball_velocity(ball_.flown(bodies_.ball().velocity_mps, step_s_));
  bounce_off_bar_and_tops(former, former_height_m);
  let_ball_meet_what_is_as_high();
}

void World::Impl::bounce_off_bar_and_tops(const BodyState& former, double former_height_m) {
  const ContactParameters& contacts = configuration_.contacts;
  const BallState before{former.position_m, former.velocity_mps, former_height_m};
  if (const auto met = bounced_off_bar(field_, contacts.bar_restitution, before, ball_state())) {
    bodies_.place_ball(met->position_m, met->velocity_mps);
    ball_.bounce_in_air(met->height_m, met->vertical_mps);
    return;
  }
  const auto bounced_mps =
      bounced_off_top(field_, contacts, bodies_, robots_, former_height_m, ball_);
  if (bounced_mps) bodies_.set_ball_velocity(*bounced_mps);
}

// Lets the ball fly over robots and goals that are lower than it.
void World::Impl::let_ball_meet_what_is_as_high() {
  bodies_.let_ball_meet(ball_.height_m() < kRobotHeight_m,
                        ball_.height_m() < field_.goal_opening_height_m);
}

BallState World::Impl::ball_state() const {
  const BodyState& ball = bodies_.ball();
  return {ball.position_m, ball.velocity_mps, ball_.height_m(), ball_.vertical_mps(),
          ball_.is_rolling()};
}

}  // namespace autoref::sim
