// Who touched the ball since play began, for how long, and how high it has been.
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

// A robot has the ball at its hull: from a touch until the gap between them is 20 mm.
struct Contact {
  RobotId robot;
  double since_s = 0;
  Vec2 ball_from_m{0, 0};
  bool is_new = false;       // began in this frame
  bool is_touching = false;  // really met the ball in this frame
  int count = 0;             // tells one contact from the next
};

using Contacts = boost::container::static_vector<Contact, 2 * kMaxRobots>;

// How high the ball's top has been since a side's last touch; none before its first.
struct Heights {
  std::optional<double> since_touch_m;
  // The same, but a ball that rolls, or that a robot of that side met low enough, begins anew.
  std::optional<double> of_shot_m;
};

class BallHistory {
 public:
  explicit BallHistory(const RuleBook& rules) : chip_height_m_(rules.chip_height_m) {}

  void begin();  // play has just been started
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

// The robot of that name; none where there is none.
const sim::RobotState* find_robot(const sim::WorldState& world, RobotId id);

}  // namespace autoref::runner::ground_truth
