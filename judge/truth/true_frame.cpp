#include "judge/truth/true_frame.hpp"

#include <algorithm>

#include "judge/truth/outline.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::judge::ground_truth {
namespace {

bool starts_play(CommandKind kind) {
  return kind == CommandKind::kNormalStart || kind == CommandKind::kForceStart ||
         kind == CommandKind::kDirectFree || kind == CommandKind::kIndirectFree;
}

bool is_free_kick(CommandKind kind) {
  return kind == CommandKind::kDirectFree || kind == CommandKind::kIndirectFree;
}

bool prepares(CommandKind kind) {
  return kind == CommandKind::kPrepareKickoff || kind == CommandKind::kPreparePenalty;
}

constexpr double kSeparate_m = 20_mm;

constexpr double kAtBall_m = 1_mm;

bool is_within(double gap_m, const sim::RobotState& robot, const sim::BallState& ball) {
  const double to_ball_m = distance_to_hull(ball.position_m, robot.position_m, robot.heading);
  return to_ball_m - kBallRadius_m <= gap_m && ball.height_m <= kRobotHeight_m;
}

bool is_at_ball(const sim::WorldState& now, RobotId id) {
  const sim::RobotState* robot = find_robot(now, id);
  return robot != nullptr && is_within(kAtBall_m, *robot, now.ball);
}

}  // namespace

const TruePlay& PlayFollower::update(const sim::WorldState& now, double time_s,
                                     const RefereeSignal& signal) {
  play_.entered_now = false;
  if (play_.is_on && !play_.in_play &&
      (now.ball.position_m - play_.ball_from_m).norm() > in_play_m_) {
    play_.in_play = true;
    play_.entered_now = true;
    play_.entered_s = time_s;
  }
  play_.ends_now =
      play_.is_on && signal.command_counter != counter_ && !starts_play(signal.command.kind);
  return play_;
}

void PlayFollower::obey(const sim::WorldState& now, double time_s, const RefereeSignal& signal) {
  if (signal.command_counter == counter_) return;
  counter_ = signal.command_counter;
  const Command& command = signal.command;
  if (prepares(command.kind)) prepared_ = command;
  const TruePlay before = play_;
  play_ = TruePlay{};
  play_.is_on = starts_play(command.kind);
  play_.is_stop = command.kind == CommandKind::kStop;
  if (command.kind == CommandKind::kBallPlacement) play_.placer = command.side;
  play_.count = before.count + 1;
  play_.stops = before.stops + (play_.is_stop ? 1 : 0);
  play_.stopped_s = time_s;
  play_.stop_count = before.stop_count;
  play_.stop_began_s = before.stop_began_s;
  if (!before.is_stop && (play_.is_stop || is_free_kick(command.kind))) {
    ++play_.stop_count;
    play_.stop_began_s = time_s;
  }
  if (!play_.is_on) return;
  play_.restart = command.kind == CommandKind::kNormalStart ? prepared_ : command;
  if (is_for_one_side(play_.restart.kind)) play_.taker = play_.restart.side;
  play_.began_s = time_s;
  play_.ball_from_m = now.ball.position_m;
  play_.in_play = command.kind == CommandKind::kForceStart;
  play_.entered_s = time_s;
}

const sim::RobotState* find_robot(const sim::WorldState& world, RobotId id) {
  for (const sim::RobotState& robot : world.robots[id.side]) {
    if (robot.number == id.number) return &robot;
  }
  return nullptr;
}

void BallHistory::begin() {
  first_.reset();
  last_.reset();
  has_second_ = is_last_shared_ = false;
  contacts_.clear();
  heights_ = {};
}

void BallHistory::update(const sim::WorldState& now, std::span<const sim::Touch> touches,
                         double time_s) {
  for (Contact& contact : contacts_) contact.is_new = contact.is_touching = false;
  const double top_m = now.ball.height_m + 2 * kBallRadius_m;
  if (inside_m(field_, now.ball.position_m) < 0) {
    // The path leads out of the field, so the touches that count come first.
    const auto is_in = [this](const sim::Touch& touch) {
      return inside_m(field_, touch.ball_m) >= 0;
    };
    const auto end = std::find_if_not(touches.begin(), touches.end(), is_in);
    touches = touches.first(static_cast<std::size_t>(end - touches.begin()));
  }
  for (const sim::Touch& touch : touches) note(touch, time_s, top_m);
  settle_last(now, touches);
  for (Heights& heights : heights_.values) {
    heights.since_touch_m = std::max(heights.since_touch_m, top_m);
    if (!heights.of_shot_m) continue;
    heights.of_shot_m =
        now.ball.is_rolling ? 2 * kBallRadius_m : std::max(*heights.of_shot_m, top_m);
  }
  end_contacts(now);
}

void BallHistory::note(const sim::Touch& touch, double time_s, double top_m) {
  last_ = BallTouch{touch.robot, time_s, touch.ball_m};
  if (!first_) first_ = last_;
  has_second_ = has_second_ || first_->robot != touch.robot;
  note_heights(touch.robot.side, top_m);
  const auto known =
      std::find_if(contacts_.begin(), contacts_.end(),
                   [&touch](const Contact& contact) { return contact.robot == touch.robot; });
  if (known != contacts_.end()) {
    known->is_touching = true;
  } else {
    contacts_.push_back({touch.robot, time_s, touch.ball_m, true, true, ++count_});
  }
}

void BallHistory::note_heights(Side toucher, double top_m) {
  Heights& own = heights_[toucher];
  own.since_touch_m = top_m;
  if (!own.of_shot_m || top_m <= chip_height_m_) own.of_shot_m = top_m;
  // The opponents' chip counts from here on. If they did not chip, any later flight is the
  // toucher's doing: a chip into one's own goal counts.
  std::optional<double>& chip_m = heights_[opponent_of(toucher)].of_shot_m;
  if (!chip_m) return;
  chip_m = *chip_m > chip_height_m_ ? std::optional(top_m) : std::nullopt;
}

// The world records a new contact when it begins and a lasting one in the first sub-step of each
// frame, so the last touch recorded is not always the last one.
void BallHistory::settle_last(const sim::WorldState& now, std::span<const sim::Touch> counted) {
  if (counted.empty()) return;
  const sim::Touch& last = counted.back();
  is_last_shared_ = false;
  const auto other = std::find_if(
      counted.rbegin(), counted.rend(),
      [&last](const sim::Touch& touch) { return touch.robot.side != last.robot.side; });
  if (other == counted.rend()) return;
  const bool is_other_there = is_at_ball(now, other->robot);
  const bool is_last_there = is_at_ball(now, last.robot);
  if (is_other_there && !is_last_there) {
    last_ = BallTouch{other->robot, last_->time_s, other->ball_m};
  } else {
    const bool is_at_once = other->substep == last.substep && !other->is_kick && !last.is_kick;
    is_last_shared_ = is_other_there || is_at_once;
  }
}

bool BallHistory::has_contact(RobotId robot) const {
  return std::any_of(contacts_.begin(), contacts_.end(),
                     [robot](const Contact& contact) { return contact.robot == robot; });
}

void BallHistory::end_contacts(const sim::WorldState& now) {
  const auto over = [&now](const Contact& contact) {
    const sim::RobotState* robot = find_robot(now, contact.robot);
    return !contact.is_new && (robot == nullptr || !is_within(kSeparate_m, *robot, now.ball));
  };
  contacts_.erase(std::remove_if(contacts_.begin(), contacts_.end(), over), contacts_.end());
}

}  // namespace autoref::judge::ground_truth
