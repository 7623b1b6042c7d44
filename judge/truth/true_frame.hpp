// The input of the ground-truth rules in one frame: the world, the state of play, and the ball's
// touches since play began.
#pragma once

#include <boost/container/static_vector.hpp>
#include <optional>
#include <span>

#include "judge/truth/true_event.hpp"
#include "sim/world.hpp"
#include "soccer/field.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/rules/rule_book.hpp"

namespace autoref::judge::ground_truth {

// The state of play according to the referee's commands, and how the true ball enters play.
// `restart` is the command that started play; for a kick-off or penalty, it is the preparation
// command.
struct TruePlay {
  // Whether play is on: from the restart's signal until play is stopped.
  bool is_on = false;
  bool is_stop = false;        // whether STOP is in force
  std::optional<Side> placer;  // the side that BALL_PLACEMENT requests to place the ball
  Command restart;
  std::optional<Side> taker;  // side that takes the restart; nullopt after a force start
  double began_s = 0;         // time of the restart's signal
  Vec2 ball_from_m{0, 0};     // position of the ball at that time
  bool in_play = false;       // the ball has moved far enough (RuleBook::in_play_m)
  bool entered_now = false;   // the ball entered play in this frame
  double entered_s = 0;
  double stopped_s = 0;   // when STOP was sent
  bool ends_now = false;  // the referee has just stopped play
  int count = 0;          // number of commands obeyed; identifies a restart or stop
  // Number of STOPs among these commands; the same in a stop and in the restart that ends it.
  int stops = 0;
  // A repeated STOP continues the same stop; a free kick continues the stop that precedes it.
  int stop_count = 0;
  double stop_began_s = 0;

  bool is_kickoff() const { return restart.kind == CommandKind::kPrepareKickoff; }
  bool is_penalty() const { return restart.kind == CommandKind::kPreparePenalty; }
};

// Follows a game. A command that is sent before a frame is in force in that frame; a command that
// is sent in a frame is obeyed after it.
class PlayFollower {
 public:
  explicit PlayFollower(const RuleBook& rules) : in_play_m_(rules.in_play_m) {}

  // Call `update` before a frame's rules are evaluated, and `obey` afterwards.
  const TruePlay& update(const sim::WorldState& now, double time_s, const RefereeSignal& signal);
  void obey(const sim::WorldState& now, double time_s, const RefereeSignal& signal);
  const TruePlay& play() const { return play_; }

 private:
  double in_play_m_;
  TruePlay play_;
  Command prepared_;
  std::uint32_t counter_ = 0;
};

struct BallTouch {
  RobotId robot;
  double time_s = 0;
  Vec2 ball_m{0, 0};
};

// A robot is in contact with the ball from a touch until the gap between them exceeds 20 mm.
struct Contact {
  RobotId robot;
  double since_s = 0;
  Vec2 ball_from_m{0, 0};
  bool is_new = false;       // the contact started in this frame
  bool is_touching = false;  // the robot actually touched the ball in this frame
  int count = 0;             // identifies the contact
};

using Contacts = boost::container::static_vector<Contact, 2 * kMaxRobots>;

// Maximum height of the ball's top.
struct Heights {
  // Maximum since the side's last touch, or since play began if there was none.
  double since_touch_m = 0;
  // Maximum for judging a shot of the side. Compared with since_touch_m, it also restarts when the
  // ball rolls, when a robot of this side touches the ball low enough, and when a chip hits an
  // opponent (Laws 2014, law 12, decision 7). nullopt if no touch by this side led to the ball's
  // current flight.
  std::optional<double> of_shot_m;
};

// Tracks who has touched the ball since play began, for how long, and how high the ball has been.
//
// Touches of a ball completely outside the lines do not count: it is out of play (Laws 2014, law
// 9), and an exit belongs to the touch before it.
class BallHistory {
 public:
  BallHistory(const Field& field, const RuleBook& rules)
      : field_(field), chip_height_m_(rules.chip_height_m) {}

  void begin();  // call when play starts
  void update(const sim::WorldState& now, std::span<const sim::Touch> touches, double time_s);

  const std::optional<BallTouch>& first() const { return first_; }
  const std::optional<BallTouch>& last() const { return last_; }
  // Whether robots of both sides touched the ball last at the same time, as far as the simulation
  // knows: contacts within one sub-step have no order.
  bool is_last_shared() const { return is_last_shared_; }
  bool has_second_robot_touched() const { return has_second_; }
  const Contacts& contacts() const { return contacts_; }
  bool has_contact(RobotId robot) const;
  const Heights& heights(Side side) const { return heights_[side]; }

 private:
  void note(const sim::Touch& touch, double time_s, double top_m);
  void note_heights(Side toucher, double top_m);
  void settle_last(const sim::WorldState& now, std::span<const sim::Touch> counted);
  void end_contacts(const sim::WorldState& now);

  Field field_;
  double chip_height_m_;
  std::optional<BallTouch> first_;
  std::optional<BallTouch> last_;
  bool is_last_shared_ = false;
  bool has_second_ = false;
  Contacts contacts_;
  PerSide<Heights> heights_;
  int count_ = 0;
};

// Returns the robot with this id, or null.
const sim::RobotState* find_robot(const sim::WorldState& world, RobotId id);

struct TrueFrame {
  const Field& field;
  const RuleBook& rules;
  double time_s = 0;
  double frame_s = 0;             // time from `before` to `now`
  const sim::WorldState& before;  // the previous frame
  const sim::WorldState& now;
  std::span<const sim::Touch> touches;
  std::span<const sim::RobotCollision> collisions;
  const TruePlay& play;
  const BallHistory& ball;
  const RefereeSignal& signal;      // signal in force since the previous frame
  PerSide<int> keepers;             // numbers of the keepers
  const PerSide<double>& fouled_s;  // time of each side's latest non-stopping foul (2026)

  bool is_keeper(RobotId robot) const { return keepers[robot.side] == robot.number; }
  bool is_shootout() const { return signal.stage == Stage::kShootout; }
  // Whether a penalty kick that does not score has failed. In shoot-outs, this applies under all
  // rule books.
  bool may_penalty_fail() const { return is_shootout() || rules.has(RuleId::kPenaltyKickFailed); }
  // Whether a team or, on its behalf, the simulator is bringing the ball to the referee's target.
  bool is_ball_being_placed() const {
    if (!signal.placement || !(play.placer || (play.is_stop && signal.placement->by_hand)))
      return false;
    return (signal.placement->target_m - now.ball.position_m).norm() > rules.ball_in_position_m;
  }
};

// Detects one kind of event, or several mutually exclusive ones. Called once per frame.
class GroundTruthRule {
 public:
  virtual ~GroundTruthRule() = default;
  virtual void watch(const TrueFrame& frame, TrueEvents& all) = 0;
};

// Calls act(id, robot) for every robot of one or both sides.
template <typename Act>
void for_each_robot(const sim::WorldState& world, Side side, const Act& act) {
  for (const sim::RobotState& robot : world.robots[side]) act(RobotId{side, robot.number}, robot);
}
template <typename Act>
void for_each_robot(const sim::WorldState& world, const Act& act) {
  for (const Side side : kSides) for_each_robot(world, side, act);
}

}  // namespace autoref::judge::ground_truth
