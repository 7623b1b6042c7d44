// Tracks who has touched the ball since play began, for how long, and how high the ball has been.
//
// Touches of a ball that is wholly beyond the lines do not count: it is out of play (Laws 2014, law
// 9), and an exit belongs to the touch before it.
#pragma once

#include <boost/container/static_vector.hpp>
#include <optional>
#include <span>

#include "sim/world.hpp"
#include "soccer/field.hpp"
#include "soccer/rule_book.hpp"

namespace autoref::judge::ground_truth {

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

// Maximum height of the ball's top.
struct Heights {
  // Since the side's last touch; since play began if there was none.
  double since_touch_m = 0;
  // The same, but restarted when the ball rolls, when a robot of this side touches it low enough,
  // and when a chip hits an opponent (Laws 2014, law 12, decision 7). nullopt if no touch of this
  // side led to the ball's present flight.
  std::optional<double> of_shot_m;
};

class BallHistory {
 public:
  BallHistory(const Field& field, const RuleBook& rules)
      : field_(field), chip_height_m_(rules.chip_height_m) {}

  void begin();  // call when play starts
  void update(const sim::WorldState& now, std::span<const sim::Touch> touches, double time_s);

  const std::optional<BallTouch>& first() const { return first_; }
  const std::optional<BallTouch>& last() const { return last_; }
  // Whether robots of both sides touched the ball last, at the same time as far as the simulation
  // knows: contacts of one sub-step have no order.
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

}  // namespace autoref::judge::ground_truth
