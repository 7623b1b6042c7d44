// World's implementation: the sequence of events in a frame. Only for the world's sources.
#pragma once

#include <array>
#include <cstdint>

#include "sim/ball.hpp"
#include "sim/box2d_bridge.hpp"
#include "sim/contact_prediction.hpp"
#include "sim/drive.hpp"
#include "sim/kicker.hpp"
#include "sim/placement.hpp"
#include "sim/world.hpp"
#include "soccer/random.hpp"

namespace autoref::sim {

class World::Impl {
 public:
  Impl(const Field& field, const Configuration& configuration, const PerSide<TeamSpec>& specs,
       std::uint64_t seed);

  void step(const PerSide<TeamCommands>& commands, const std::optional<Placement>& placement);
  const WorldState& state() const { return state_; }
  std::span<const Touch> touches() const { return {touches_.data(), touches_.size()}; }
  std::span<const RobotCollision> collisions() const {
    return {collisions_.data(), collisions_.size()};
  }
  void put_ball(const BallState& ball);
  void put_robot(RobotId id, const RobotState& state);
  void take_off(RobotId id);
  void put_on(RobotId id, const BodyState& pose);
  bool is_on(RobotId id) const { return bodies_.is_on(index_of(id)); }
  bool is_free(const Vec2& position_m) const;

 private:
  struct Robot {
    Drive drive;
    Kicker kicker;
    Dribbler dribbler;
    RobotCommand aim;        // command in force, limited to what the robot can do
    int unheard_frames = 0;  // frames since the last command was received
  };
  // A side's robots and their random streams.
  struct Team {
    int first = 0;  // index in the bridge of the team's robot 0
    boost::container::static_vector<Robot, kMaxRobots> robots;
    RandomStream motors;
    RandomStream kicks;
    RandomStream dribblers;
    RandomStream radio;
  };
  // The force of a robot's dribbler on the ball.
  struct Pull {
    int index;  // index of the robot in the bridge
    bool holds;
    Vec2 force_n;
    double limit_n;  // the dribbler's maximum force
  };
  using Pulls = boost::container::static_vector<Pull, 2 * kMaxRobots>;
  // Whether the ball is free or held by ball placement. Ball placement first stops the ball, then
  // carries it to the target and keeps it there.
  enum class Hold { kFree, kCatching, kCarrying };

  Team make_team(Side side, const TeamSpec& spec, std::uint64_t seed) const;
  Team& team(Side side) { return teams_[static_cast<std::size_t>(side)]; }
  const Team& team(Side side) const { return teams_[static_cast<std::size_t>(side)]; }

  void accept(const PerSide<TeamCommands>& commands);
  bool hears(Robot& robot, RandomStream& radio) const;
  void obey(const std::optional<Placement>& placement);
  int block_from(int substep) const;
  void advance(int substep, int substeps);
  void step_once(int substep, int substeps);
  BodySet everything() const;
  void drive(bool gathered, double duration_s);
  void hold_ball();
  void move_ball(int substep);
  std::optional<Vec2> kicked(int substep);
  Pulls pulls();
  double rest_speed_mps(const Pulls& pulls) const;
  Vec2 dribbled(Vec2 ball_mps, const Pulls& pulls);
  Vec2 held_by_net(Vec2 ball_mps) const;
  void follow_ball(const BodyState& former);
  void bounce_off_bar_and_tops(const BodyState& former, double former_height_m);
  BallState ball_state() const;
  void let_ball_meet_what_is_as_high();
  void note_contacts(int substep);
  void note(const Touch& touch);
  int index_of(RobotId id) const;  // the robot's index in the bridge
  void note_collisions(int substep);
  RobotId id_of(int index) const;
  void publish();

  template <typename Act>  // act(id, robot, index in the bridge)
  void for_each_robot(Act act) {
    for (const Side side : kSides) {
      Team& its_team = team(side);
      int number = 0;
      for (Robot& robot : its_team.robots) {
        act(RobotId{side, number}, robot, its_team.first + number);
        ++number;
      }
    }
  }

  template <typename Act>
  void for_each_on_field(Act act) {
    for_each_robot([&](RobotId id, Robot& robot, int index) {
      if (bodies_.is_on(index)) act(id, robot, index);
    });
  }

  // Considers only gathered bodies, since no others can be close to each other.
  template <typename Act>
  void for_each_near_ball(Act act) {
    if (!bodies_.gathered().ball) return;
    for_each_robot([&](RobotId id, Robot& robot, int index) {
      if (bodies_.gathered().has_robot(index)) act(id, robot, index);
    });
  }

  Field field_;
  Configuration configuration_;
  double substep_s_;
  int block_;          // sub-steps per block, which a free body covers in a single step
  double step_s_ = 0;  // duration of the current physics step
  int command_delay_substeps_;
  int hold_frames_;  // frames without a command after which a robot stops
  int robots_;
  std::array<Team, 2> teams_;
  Box2dBridge bodies_;
  Ball ball_;
  Carrier carrier_;
  ContactPrediction contact_prediction_;
  Hold hold_ = Hold::kFree;
  Placement placement_;                 // the current placement
  std::int64_t substeps_ = 0;           // number of sub-steps since the start
  std::uint32_t touching_ = 0;          // one bit per robot: touched the ball in the last sub-step
  std::uint32_t touched_in_frame_ = 0;  // robots that have touched the ball in this frame so far
  boost::container::static_vector<Touch, 256> touches_;
  boost::container::static_vector<RobotCollision, 64> collisions_;
  WorldState state_;
};

}  // namespace autoref::sim
