#include "sim/world_impl.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "sim/box2d_bridge.hpp"
#include "sim/sim_configuration.hpp"
#include "soccer/field.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/side.hpp"

namespace autoref::sim {
namespace {

constexpr int kRow = 8;  // robots per row; a full team fills two

// The pose of a robot: in a row in its own half, along the touch line to the right of its keeper,
// facing the opponents' goal. This is not a formation, so teams have to move. The two sides'
// positions are 180-degree rotations of each other.
BodyState pose_in_line_up(const Field& field, const LineUpParameters& line_up, RobotId id) {
  const double room_m =
      field.half_length_m() - line_up.from_halfway_line_m - line_up.from_goal_line_m;
  const double gap_m = std::min(line_up.gap_m, room_m / (kRow - 1));
  const double x = -line_up.from_halfway_line_m - gap_m * (id.number % kRow);
  const int row = id.number / kRow;
  const double y = -field.half_width_m() + line_up.from_touch_line_m + line_up.gap_m * row;
  const double turn = -goal_sign(id.side);  // 1 for west, -1 for east
  BodyState pose;
  pose.position_m = {turn * x, turn * y};
  pose.heading = {turn, 0.0};
  return pose;
}

// The masses of west's robots, followed by those of east's robots.
std::vector<double> masses_kg(const PerSide<TeamSpec>& specs) {
  std::vector<double> masses;
  masses.reserve(2 * kMaxRobots);
  for (const TeamSpec& spec : specs.values) {
    for (const RobotSpec& robot : spec.robots) masses.push_back(robot.body.mass_kg);
  }
  return masses;
}

}  // namespace

World::Impl::Team World::Impl::make_team(Side side, const TeamSpec& spec,
                                         std::uint64_t seed) const {
  Team made{0,
            {},
            RandomStream::of(seed, RandomPurpose::kMotors, side),
            RandomStream::of(seed, RandomPurpose::kKicker, side),
            RandomStream::of(seed, RandomPurpose::kDribbler, side),
            RandomStream::of(seed, RandomPurpose::kRadio, side)};
  const double substeps_per_s = configuration_.frame_rate_hz * configuration_.substeps;
  for (const RobotSpec& robot : spec.robots) {
    made.robots.push_back({Drive(robot), Kicker(robot.kicker, substeps_per_s),
                           Dribbler(robot.dribbler, configuration_.ball.mass_kg, substeps_per_s),
                           RobotCommand{}, 0});
  }
  return made;
}

World::Impl::Impl(const Field& field, const Configuration& configuration,
                  const PerSide<TeamSpec>& specs, std::uint64_t seed)
    : field_(field),
      configuration_(configuration),
      substep_s_(1.0 / (configuration.frame_rate_hz * configuration.substeps)),
      block_(std::max(1, configuration.substeps / configuration.contact_free_substeps)),
      command_delay_substeps_(split_latency(configuration).substeps),
      // The 1e-9 absorbs rounding, which could otherwise add a frame.
      hold_frames_(static_cast<int>(
          std::ceil(configuration.radio.hold_s * configuration.frame_rate_hz - 1e-9))),
      robots_(
          static_cast<int>(specs[Side::kWest].robots.size() + specs[Side::kEast].robots.size())),
      teams_{make_team(Side::kWest, specs[Side::kWest], seed),
             make_team(Side::kEast, specs[Side::kEast], seed)},
      bodies_(field, configuration.contacts, configuration.ball.mass_kg, masses_kg(specs)),
      ball_(configuration.ball),
      carrier_(field, configuration.placement),
      contact_prediction_(field, specs, block_ * substep_s_) {
  team(Side::kEast).first = static_cast<int>(team(Side::kWest).robots.size());
  for_each_robot([&](RobotId id, Robot&, int index) {
    bodies_.place_robot(index, pose_in_line_up(field_, configuration_.line_up, id));
  });
  put_ball({});
}

void World::Impl::step(const PerSide<TeamCommands>& commands,
                       const std::optional<Placement>& placement) {
  touches_.clear();
  collisions_.clear();
  touched_in_frame_ = 0;
  obey(placement);
  for (int k = 0; k < configuration_.substeps;) {
    if (k == command_delay_substeps_) accept(commands);
    const int length = block_from(k);
    advance(k, length);
    k += length;
  }
  ++state_.frame;
  publish();
}

void World::Impl::accept(const PerSide<TeamCommands>& commands) {
  for_each_robot([&](RobotId id, Robot& robot, int index) {
    const RobotCommand& command = commands[id.side][static_cast<std::size_t>(id.number)];
    assert(autoref::is_finite(command));
    // A robot off the field draws its random numbers too, so that the other robots' numbers do not
    // change.
    if (hears(robot, team(id.side).radio)) {
      robot.aim = robot.drive.accept(command, team(id.side).motors);
    } else if (robot.unheard_frames >= hold_frames_) {
      robot.aim = RobotCommand{};
    }
    if (!bodies_.is_on(index)) robot.aim = RobotCommand{};
    bodies_.set_dribbling(index, robot.aim.dribble);
  });
}

// A robot keeps executing its last command until it has received no new command for a while.
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

// A block does not extend beyond the frame, or beyond the sub-step in which commands take effect.
int World::Impl::block_from(int substep) const {
  const int end = substep < command_delay_substeps_
                      ? std::min(command_delay_substeps_, configuration_.substeps)
                      : configuration_.substeps;
  return std::min(block_, end - substep);
}

// Bodies that cannot hit anything until the end of the block take one step; the others take as many
// steps as their encounters require.
void World::Impl::advance(int substep, int substeps) {
  Encounters found = contact_prediction_.encounters(bodies_, robots_, hold_ != Hold::kFree);
  if (!configuration_.free_motion) found.bodies = everything();
  bodies_.gather(found.bodies);
  drive(false, substeps * substep_s_);
  bodies_.move_free_robots(substeps * substep_s_);
  const int stride = found.need_short_steps || ball_.is_in_air() ? 1 : substeps;
  for (int k = 0; k < substeps; k += stride) step_once(substep + k, stride);
}

// This is operator splitting: drives, kicks and the carpet act first, then Box2D's contacts, then
// the effects that planar physics lacks.
void World::Impl::step_once(int substep, int substeps) {
  step_s_ = substeps * substep_s_;
  drive(true, step_s_);
  if (hold_ == Hold::kFree) {
    move_ball(substep);
  } else {
    hold_ball();
  }
  const BodyState former = bodies_.ball();
  bodies_.step(step_s_);
  if (hold_ == Hold::kFree) follow_ball(former);
  note_contacts(substep);
  note_collisions(substep);
  substeps_ += substeps;
}

BodySet World::Impl::everything() const {
  BodySet all{0, true};
  for (int i = 0; i < robots_; ++i) {
    if (bodies_.is_on(i)) all.add_robot(i);
  }
  return all;
}

// Drives either the robots that are gathered or all other robots.
void World::Impl::drive(bool gathered, double duration_s) {
  for_each_on_field([&](RobotId, const Robot& robot, int index) {
    if (bodies_.gathered().has_robot(index) != gathered) return;
    const DriveForce drive = robot.drive.force(robot.aim, bodies_.robot(index), duration_s);
    bodies_.push_robot(index, drive.force_n, drive.torque_nm);
  });
}

// A new contact is recorded when it begins, and a continuing contact once per frame.
void World::Impl::note_contacts(int substep) {
  std::uint32_t now = 0;
  for (const int index : bodies_.touching()) {
    const std::uint32_t bit = 1U << index;
    now |= bit;
    if ((touching_ & touched_in_frame_ & bit) != 0) continue;
    touched_in_frame_ |= bit;
    note({state_.frame + 1, substep, id_of(index), bodies_.ball().position_m, false,
          bodies_.ball().velocity_mps, ball_.vertical_mps()});
  }
  touching_ = now;
}

void World::Impl::note(const Touch& touch) {
  if (touches_.size() < touches_.capacity()) touches_.push_back(touch);
}

void World::Impl::note_collisions(int substep) {
  for (const BodyCollision& met : bodies_.collisions()) {
    if (collisions_.size() == collisions_.capacity()) return;
    collisions_.push_back({state_.frame + 1,
                           substep,
                           {id_of(met.robots[0]), id_of(met.robots[1])},
                           met.velocities_mps,
                           met.centres_m});
  }
}

RobotId World::Impl::id_of(int index) const {
  const int east = team(Side::kEast).first;
  return index < east ? RobotId{Side::kWest, index} : RobotId{Side::kEast, index - east};
}

void World::Impl::put_ball(const BallState& ball) {
  bodies_.place_ball(ball.position_m, ball.velocity_mps);
  ball_.set(ball);
  hold_ = Hold::kFree;
  let_ball_meet_what_is_as_high();
  publish();
}

void World::Impl::put_robot(RobotId id, const RobotState& state) {
  assert(is_on(id));
  bodies_.place_robot(index_of(id), {state.position_m, state.heading, state.velocity_mps,
                                     state.angular_velocity_radps});
  publish();
}

void World::Impl::take_off(RobotId id) {
  const int index = index_of(id);
  team(id.side).robots[static_cast<std::size_t>(id.number)].aim = RobotCommand{};
  bodies_.set_dribbling(index, false);
  bodies_.set_on(index, false);
  publish();
}

void World::Impl::put_on(RobotId id, const BodyState& pose) {
  assert(!is_on(id) && is_free(pose.position_m));
  bodies_.set_on(index_of(id), true);
  bodies_.place_robot(index_of(id), pose);
  publish();
}

bool World::Impl::is_free(const Vec2& position_m) const {
  const auto is_clear_of = [&](const Vec2& other_m, double reach_m) {
    return (position_m - other_m).norm() >= kRobotRadius_m + reach_m;
  };
  for (int i = 0; i < robots_; ++i) {
    if (bodies_.is_on(i) && !is_clear_of(bodies_.robot(i).position_m, kRobotRadius_m)) return false;
  }
  return is_clear_of(bodies_.ball().position_m, kBallRadius_m);
}

int World::Impl::index_of(RobotId id) const {
  const Team& its_team = teams_[static_cast<std::size_t>(id.side)];
  assert(id.number >= 0 && id.number < static_cast<int>(its_team.robots.size()));
  return its_team.first + id.number;
}

void World::Impl::publish() {
  for (const Side side : kSides) state_.robots[side].clear();
  for_each_on_field([this](RobotId id, Robot&, int index) {
    const BodyState& body = bodies_.robot(index);
    // Box2D's float sine and cosine do not form an exact unit vector.
    state_.robots[id.side].push_back({id.number, body.position_m, body.heading.normalized(),
                                      body.velocity_mps, body.angular_velocity_radps});
  });
  state_.ball = ball_state();
}

}  // namespace autoref::sim
