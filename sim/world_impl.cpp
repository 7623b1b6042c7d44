#include "sim/world_impl.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "sim/bar.hpp"
#include "sim/dribbler.hpp"
#include "sim/lids.hpp"
#include "sim/line_up.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::sim {
namespace {

// Less change of the ball's velocity is rounding, not a collision.
constexpr double kCollision_mps = 0.01;

// The west's robots, then the east's.
std::vector<double> masses_kg(const PerSide<TeamSheet>& sheets) {
  std::vector<double> masses;
  masses.reserve(2 * kMaxRobots);
  for (const TeamSheet& sheet : sheets.values) {
    for (const RobotSheet& robot : sheet.robots) masses.push_back(robot.body.mass_kg);
  }
  return masses;
}

}  // namespace

World::Impl::Team World::Impl::make_team(Side side, const TeamSheet& sheet,
                                         std::uint64_t seed) const {
  Team made{0,
            {},
            RandomStream::of(seed, RandomPurpose::kMotors, side),
            RandomStream::of(seed, RandomPurpose::kKicker, side),
            RandomStream::of(seed, RandomPurpose::kRadio, side)};
  const double substeps_per_s = configuration_.frame_rate_hz * configuration_.substeps;
  for (const RobotSheet& robot : sheet.robots) {
    made.robots.push_back(
        {Drive(robot), Kicker(robot.kicker, substeps_per_s), robot.dribbler, RobotCommand{}, 0});
  }
  return made;
}

World::Impl::Impl(const Field& field, const Configuration& configuration,
                  const PerSide<TeamSheet>& sheets, std::uint64_t seed)
    : field_(field),
      configuration_(configuration),
      substep_s_(1.0 / (configuration.frame_rate_hz * configuration.substeps)),
      long_step_(std::max(1, configuration.substeps / configuration.calm_substeps)),
      order_delay_substeps_(split_latency(configuration).substeps),
      hold_frames_(static_cast<int>(
          std::ceil(configuration.radio.hold_s * configuration.frame_rate_hz - 1e-9))),
      robots_(
          static_cast<int>(sheets[Side::kWest].robots.size() + sheets[Side::kEast].robots.size())),
      teams_{make_team(Side::kWest, sheets[Side::kWest], seed),
             make_team(Side::kEast, sheets[Side::kEast], seed)},
      bodies_(field, masses_kg(sheets)),
      ball_(configuration.ball),
      carrier_(field, configuration.placement),
      calm_(field, sheets, long_step_ * substep_s_) {
  team(Side::kEast).first = static_cast<int>(team(Side::kWest).robots.size());
  for_each_robot([&](RobotId id, Robot&, int index) {
    bodies_.place_robot(index, place_in_line_up(field_, id));
  });
  put_ball({});
}

void World::Impl::step(const PerSide<TeamOrders>& orders,
                       const std::optional<Placement>& placement) {
  touches_.clear();
  touched_in_frame_ = 0;
  obey(placement);
  for (int k = 0; k < configuration_.substeps;) {
    if (k == order_delay_substeps_) accept(orders);
    const int length = may_step_long(k) ? long_step_ : 1;
    advance(k, length);
    k += length;
  }
  ++state_.frame;
  publish();
}

void World::Impl::accept(const PerSide<TeamOrders>& orders) {
  for_each_robot([&](RobotId id, Robot& robot, int index) {
    const RobotCommand& order = orders[id.side][static_cast<std::size_t>(id.number)];
    assert(autoref::is_finite(order));
    if (hears(robot, team(id.side).radio)) {
      robot.aim = robot.drive.accept(order, team(id.side).motors);
    } else if (robot.unheard_frames >= hold_frames_) {
      robot.aim = RobotCommand{};
    }
    bodies_.set_dribbling(index, robot.aim.dribble);
  });
}

// A robot goes on as last ordered until it has heard nothing for a while.
bool World::Impl::hears(Robot& robot, RandomStream& radio) const {
  const double loss = configuration_.radio.command_loss;
  const bool is_lost = loss > 0.0 && radio.uniform() < loss;
  robot.unheard_frames = is_lost ? robot.unheard_frames + 1 : 0;
  return !is_lost;
}

void World::Impl::obey(const std::optional<Placement>& placement) {
  if (!placement) {
    if (hold_ != Hold::kFree) let_ball_meet_what_is_as_high();
    hold_ = Hold::kFree;
    return;
  }
  const bool is_known = hold_ != Hold::kFree && placement->target_m == placement_.target_m &&
                        placement->at_once == placement_.at_once;
  if (is_known) return;
  assert(autoref::is_finite(placement->target_m));
  placement_ = *placement;
  hold_ = Hold::kCatching;
  if (!placement_.at_once) return;
  bodies_.place_ball(placement_.target_m, {0.0, 0.0});
  ball_.set({});
}

// Orders take effect at their sub-step, which no longer step may pass over.
bool World::Impl::may_step_long(int substep) const {
  const int end = substep + long_step_;
  if (long_step_ == 1 || end > configuration_.substeps) return false;
  if (substep < order_delay_substeps_ && order_delay_substeps_ < end) return false;
  return !ball_.is_in_air() && calm_.lasts(bodies_, robots_, hold_ != Hold::kFree);
}

void World::Impl::advance(int substep, int substeps) {
  step_s_ = substeps * substep_s_;
  drive();
  if (hold_ == Hold::kFree) {
    move_ball(substep);
  } else {
    hold_ball();
  }
  const BodyState former = bodies_.ball();
  bodies_.step(step_s_);
  if (hold_ == Hold::kFree) follow_ball(former);
  note_contacts(substep);
  substeps_ += substeps;
}

void World::Impl::drive() {
  for_each_robot([this](RobotId, Robot& robot, int index) {
    const DriveForce drive = robot.drive.force(robot.aim, bodies_.robot(index), step_s_);
    bodies_.push_robot(index, drive.force_n, drive.torque_nm);
  });
}

// The carried ball moves at the speed that brings it along its way, rather than by jumps.
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
  const Vec2 way_m = carrier_.carry(step_s_) - ball.position_m;
  const bool is_there = way_m.norm() < 1e-6;
  bodies_.set_ball_velocity(is_there ? Vec2(0.0, 0.0) : Vec2(way_m / step_s_));
}

void World::Impl::move_ball(int substep) {
  const std::optional<Vec2> kick_mps = kicked(substep);
  const Vec2 ball_mps = kick_mps ? *kick_mps : dribbled(bodies_.ball().velocity_mps);
  bodies_.set_ball_velocity(held_by_net(ball_.slowed(ball_mps, step_s_)));
}

// The ball's velocity after a kick, if there was one. Several kickers that fire at once push the
// ball together, whoever is asked first.
std::optional<Vec2> World::Impl::kicked(int substep) {
  const BodyState ball = bodies_.ball();
  Vec2 sum_mps{0.0, 0.0};
  double vertical_mps = 0.0;
  bool is_kicked = false;
  double limit_mps = 0.0;
  for_each_robot([&](RobotId id, Robot& robot, int index) {
    const auto kick = robot.kicker.fire(robot.aim, bodies_.robot(index), ball.position_m,
                                        ball_.height_m(), substeps_, team(id.side).kicks);
    if (!kick) return;
    is_kicked = true;
    limit_mps = std::max(limit_mps, robot.kicker.speed_limit_mps());
    sum_mps += kick->velocity_mps;
    vertical_mps = std::max(vertical_mps, kick->vertical_mps);
    bodies_.strike_robot(index, kBallMass_kg * (ball.velocity_mps - kick->velocity_mps));
    note({state_.frame + 1, substep, id, ball.position_m, true});
  });
  if (!is_kicked) return std::nullopt;
  ball_.kick(vertical_mps);
  return clamp_norm(sum_mps, limit_mps);
}

// The ball's velocity after the pull of all dribblers. Those that hold it share it, or two of them
// would throw it to and fro; a robot that has just kicked lets go.
Vec2 World::Impl::dribbled(Vec2 ball_mps) {
  struct Pull {
    int index;
    bool holds;
    Vec2 force_n;
  };
  boost::container::static_vector<Pull, 2 * kMaxRobots> pulls;
  const BodyState& ball = bodies_.ball();
  int holders = 0;
  for_each_robot([&](RobotId, const Robot& robot, int index) {
    const bool holds = robot.dribbler.holds;
    if (!robot.aim.dribble || (holds && robot.kicker.is_recharging(substeps_))) return;
    const Vec2 force_n =
        dribbler_force_n(robot.dribbler, bodies_.robot(index), ball, ball_.height_m(), step_s_);
    if (force_n.isZero(0.0)) return;
    pulls.push_back({index, holds, force_n});
    holders += holds ? 1 : 0;
  });
  for (const Pull& pull : pulls) {
    const Vec2 force_n = pull.holds ? Vec2(pull.force_n / holders) : pull.force_n;
    ball_mps += force_n * (step_s_ / kBallMass_kg);
    bodies_.push_robot_at(pull.index, -force_n, ball.position_m);
  }
  return ball_mps;
}

Vec2 World::Impl::held_by_net(Vec2 ball_mps) const {
  const Vec2& at_m = bodies_.ball().position_m;
  const double outwards = -std::copysign(1.0, at_m.x());
  const double leaves_mps = ball_mps.x() * outwards;
  if (leaves_mps <= 0.0 || !is_in_goal(field_, at_m)) return ball_mps;
  if (std::abs(at_m.x()) < field_.half_length_m() + kBallRadius_m) return ball_mps;
  ball_mps.x() = outwards * std::max(0.0, leaves_mps - configuration_.ball.net_mps2 * step_s_);
  return ball_mps;
}

// What the plane's physics does not know: spin lost in collisions, and the third dimension.
void World::Impl::follow_ball(const BodyState& former) {
  const Vec2 change_mps = bodies_.ball().velocity_mps - former.velocity_mps;
  if (change_mps.squaredNorm() > kCollision_mps * kCollision_mps) ball_.collide(change_mps);
  if (!ball_.is_in_air()) return;
  const double former_height_m = ball_.height_m();
  bodies_.set_ball_velocity(ball_.flown(bodies_.ball().velocity_mps, step_s_));
  meet_bar_and_lids(former, former_height_m);
  let_ball_meet_what_is_as_high();
}

void World::Impl::meet_bar_and_lids(const BodyState& former, double former_height_m) {
  const BallState before{former.position_m, former.velocity_mps, former_height_m};
  if (const auto met = bounced_off_bar(field_, before, ball_state())) {
    bodies_.place_ball(met->position_m, met->velocity_mps);
    ball_.bounce_in_air(met->height_m, met->vertical_mps);
    return;
  }
  const auto bounced_mps = bounced_off_lid(field_, bodies_, robots_, former_height_m, ball_);
  if (bounced_mps) bodies_.set_ball_velocity(*bounced_mps);
}

// The ball flies over robots and goals that are lower than it.
void World::Impl::let_ball_meet_what_is_as_high() {
  bodies_.let_ball_meet(ball_.height_m() < kRobotHeight_m,
                        ball_.height_m() < field_.goal_opening_height_m);
}

void World::Impl::note_contacts(int substep) {
  std::uint32_t now = 0;
  for (const int index : bodies_.touching()) {
    const std::uint32_t bit = 1U << index;
    now |= bit;
    if ((touching_ & touched_in_frame_ & bit) != 0) continue;
    touched_in_frame_ |= bit;
    const bool is_west = index < team(Side::kEast).first;
    const RobotId id = is_west ? RobotId{Side::kWest, index}
                               : RobotId{Side::kEast, index - team(Side::kEast).first};
    note({state_.frame + 1, substep, id, bodies_.ball().position_m, false});
  }
  touching_ = now;
}

void World::Impl::note(const Touch& touch) {
  if (touches_.size() < touches_.capacity()) touches_.push_back(touch);
}

void World::Impl::put_ball(const BallState& ball) {
  bodies_.place_ball(ball.position_m, ball.velocity_mps);
  ball_.set(ball);
  hold_ = Hold::kFree;
  let_ball_meet_what_is_as_high();
  publish();
}

void World::Impl::put_robot(RobotId id, const RobotState& state) {
  assert(id.number >= 0 && id.number < static_cast<int>(team(id.side).robots.size()));
  bodies_.place_robot(
      team(id.side).first + id.number,
      {state.position_m, state.heading, state.velocity_mps, state.angular_velocity_radps});
  publish();
}

void World::Impl::publish() {
  for (const Side side : kSides) state_.robots[side].clear();
  for_each_robot([this](RobotId id, Robot&, int index) {
    const BodyState& body = bodies_.robot(index);
    state_.robots[id.side].push_back({id.number, body.position_m, body.heading.normalized(),
                                      body.velocity_mps, body.angular_velocity_radps});
  });
  state_.ball = ball_state();
}

BallState World::Impl::ball_state() const {
  const BodyState& ball = bodies_.ball();
  return {ball.position_m, ball.velocity_mps, ball_.height_m(), ball_.vertical_mps(),
          ball_.is_rolling()};
}

}  // namespace autoref::sim
