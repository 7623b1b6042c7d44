#include "runner/judge/truth/ball_history.hpp"

#include <algorithm>

#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::runner::ground_truth {
namespace {

constexpr double kSeparate_m = 20_mm;

void raise(std::optional<double>& highest_m, double top_m) {
  if (highest_m) highest_m = std::max(*highest_m, top_m);
}

bool is_separate(const sim::RobotState& robot, const sim::BallState& ball) {
  const double gap_m =
      distance_to_hull(ball.position_m, robot.position_m, robot.heading) - kBallRadius_m;
  return gap_m > kSeparate_m || ball.height_m > kRobotHeight_m;
}

}  // namespace

const sim::RobotState* find_robot(const sim::WorldState& world, RobotId id) {
  for (const sim::RobotState& robot : world.robots[id.side]) {
    if (robot.number == id.number) return &robot;
  }
  return nullptr;
}

void BallHistory::begin() {
  first_.reset();
  last_.reset();
  has_second_ = false;
  contacts_.clear();
  heights_ = {};
}

void BallHistory::update(const sim::WorldState& now, std::span<const sim::Touch> touches,
                         double time_s) {
  for (Contact& contact : contacts_) contact.is_new = contact.is_touching = false;
  const double top_m = now.ball.height_m + 2 * kBallRadius_m;
  for (const sim::Touch& touch : touches) note(touch, time_s, top_m);
  for (Heights& heights : heights_.values) {
    raise(heights.since_touch_m, top_m);
    raise(heights.of_shot_m, top_m);
    if (now.ball.is_rolling && heights.of_shot_m) heights.of_shot_m = 2 * kBallRadius_m;
  }
  end_contacts(now);
}

void BallHistory::note(const sim::Touch& touch, double time_s, double top_m) {
  last_ = BallTouch{touch.robot, time_s, touch.ball_m};
  if (!first_) first_ = last_;
  has_second_ = has_second_ || first_->robot != touch.robot;
  Heights& heights = heights_[touch.robot.side];
  heights.since_touch_m = top_m;
  if (!heights.of_shot_m || top_m <= chip_height_m_) heights.of_shot_m = top_m;
  const auto known =
      std::find_if(contacts_.begin(), contacts_.end(),
                   [&touch](const Contact& contact) { return contact.robot == touch.robot; });
  if (known != contacts_.end()) {
    known->is_touching = true;
  } else {
    contacts_.push_back({touch.robot, time_s, touch.ball_m, true, true, ++count_});
  }
}

bool BallHistory::has_contact(RobotId robot) const {
  return std::any_of(contacts_.begin(), contacts_.end(),
                     [robot](const Contact& contact) { return contact.robot == robot; });
}

void BallHistory::end_contacts(const sim::WorldState& now) {
  const auto over = [&now](const Contact& contact) {
    const sim::RobotState* robot = find_robot(now, contact.robot);
    return !contact.is_new && (robot == nullptr || is_separate(*robot, now.ball));
  };
  contacts_.erase(std::remove_if(contacts_.begin(), contacts_.end(), over), contacts_.end());
}

}  // namespace autoref::runner::ground_truth
