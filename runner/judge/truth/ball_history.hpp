// Tracks who has touched the ball since play began, for how long, and how high the ball has been.
#pragma once

#include <boost/container/static_vector.hpp>
#include <optional>
#include <span>

#include "sim/world.hpp"
#include "soccer/rule_book.hpp"

namespace autoref::runner::ground_truth {

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
  bool is_new = false;       // started in this frame
  bool is_touching = false;  // actually touched the ball in this frame
  int count = 0;             // identifies the contact
};

using Contacts = boost::container::static_vector<Contact, 2 * kMaxRobots>;

// Maximum height of the ball's top since a side's last touch; nullopt before the first.
struct Heights {
  std::optional<double> since_touch_m;
  // The same, but restarted when the ball rolls or a robot of this side touches it low enough.
  std::optional<double> of_shot_m;
};

class BallHistory {
 public:
  explicit BallHistory(const RuleBook& rules) : chip_height_m_(rules.chip_height_m) {}

  void begin();  // call when play starts
  void update(const sim::WorldState& now, std::span<const sim::Touch> touches, double time_s);

  const std::optional<BallTouch>& first() const { return first_; }
  const std::optional<BallTouch>& last() const { return last_; }
  bool has_second_robot_touched() const { return has_second_; }
  const Contacts& contacts() const { return contacts_; }
  bool has_contact(RobotId robot) const;
  const Heights& heights(Side side) const { return heights_[side]; }

 private:
  void note(const sim::Touch& touch, double time_s, double top_m);
  void end_contacts(const sim::WorldState& now);

  double chip_height_m_;
  std::optional<BallTouch> first_;
  std::optional<BallTouch> last_;
  bool has_second_ = false;
  Contacts contacts_;
  PerSide<Heights> heights_;
  int count_ = 0;
};

// Returns the robot with this id, or null.
const sim::RobotState* find_robot(const sim::WorldState& world, RobotId id);

}  // namespace autoref::runner::ground_truth
