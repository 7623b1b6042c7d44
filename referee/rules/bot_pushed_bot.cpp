// A robot drives an opponent back: holding (Laws 12), pushing (2026).
//
// Both must travel in the pushed robot's direction for more than 200 mm while in contact with each
// other or, in 2026, while both are in contact with the ball. A robot that was already driving in
// that direction by itself was not pushed. This is decided once per contact, when both have
// travelled 200 mm, because the line between robots that slide along each other turns. The free
// kick is taken from where the offence occurred (Laws), or from where the ball was when the push
// began (2026).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "referee/geometry/restarts.hpp"
#include "referee/rules/rule.hpp"
#include "referee/touch/touch_candidates.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

// Distances between the centres of robots that are in contact, and of robots that may soon be in
// contact. Real robots do not overlap, but noisy detections may.
constexpr double kInContact_m = 2 * kRobotRadius_m + 5_mm;
constexpr double kNear_m = 2 * kRobotRadius_m + 60_mm;
// Largest gap between the ball's surface and each hull when the ball comes between the robots. The
// ball counts as between them until it is visibly apart from one of them (touch_candidates.hpp).
constexpr double kAtBall_m = 5_mm;
// Pushes that differ by less than this count as equally long, since they may differ by rounding
// only.
constexpr double kPushSame_m = 1e-9;

struct Push {
  RobotId pusher;
  RobotId pushed;
  double path_m = 0;
  Vec2 position_m{0, 0};
  Vec2 ball_from_m{0, 0};  // where the ball was when the push began
};

// Returns null if the list of contacts is full. This cannot happen with real robots, since that
// many pairs cannot be close together.
PushContact* contact_of(PushingWatch& watch, int west, int east) {
  const auto known = std::find_if(
      watch.contacts.begin(), watch.contacts.end(),
      [&](const PushContact& contact) { return contact.west == west && contact.east == east; });
  if (known != watch.contacts.end()) return &*known;
  if (watch.contacts.size() == watch.contacts.capacity()) return nullptr;
  PushContact contact;
  contact.west = west;
  contact.east = east;
  watch.contacts.push_back(contact);
  return &watch.contacts.back();
}

// Starts the contact at the current positions of robots and ball, with the robots' velocities in
// the previous frame.
void follow(PushContact& contact, const TrackedRobot& west, const TrackedRobot& east,
            const std::optional<BallSight>& ball, bool are_in_contact) {
  const bool lasts = are_in_contact && contact.are_in_contact;
  const bool was_seen_to_begin = are_in_contact && contact.is_followed;
  contact.is_near = contact.is_followed = true;
  contact.are_in_contact = are_in_contact;
  if (lasts) return;
  contact.drove_itself = {{false, false}};
  contact.from_m = {{west.position_m, east.position_m}};
  contact.ball_from_m = ball ? ball->position_m : (west.position_m + east.position_m) / 2;
  if (!was_seen_to_begin) contact.before_mps = {{west.velocity_mps, east.velocity_mps}};
}

// How far `side`'s robot has pushed the other one back, if that is farther than allowed.
std::optional<Push> push_by(Side side, PushContact& contact, const TrackedRobot& pusher,
                            const TrackedRobot& pushed, const RuleBook& rules) {
  const Side other = opponent_of(side);
  const Vec2 line = direction_of(pushed.position_m - pusher.position_m, Vec2(1, 0));
  // Uses the shorter of the two paths, because a push moves both robots along the line of their
  // centres.
  const double path_m = std::min((pusher.position_m - contact.from_m[side]).dot(line),
                                 (pushed.position_m - contact.from_m[other]).dot(line));
  if (!(path_m > rules.pushing_m)) return std::nullopt;
  if (contact.before_mps[other].dot(line) > rules.pushing_own_mps)
    contact.drove_itself[other] = true;
  if (contact.drove_itself[other]) return std::nullopt;
  return Push{{side, pusher.number},
              {other, pushed.number},
              path_m,
              (pusher.position_m + pushed.position_m) / 2,
              contact.ball_from_m};
}

// Finds the longest push. The result is nullopt if both sides' longest pushes are equal.
class LongestPush {
 public:
  void take_in(const std::optional<Push>& push) {
    if (!push || (found_ && push->path_m < found_->path_m - kPushSame_m)) return;
    const bool is_longer = !found_ || push->path_m > found_->path_m + kPushSame_m;
    is_tied_ = !is_longer && (is_tied_ || push->pusher.side != found_->pusher.side);
    found_ = push;
  }
  std::optional<Push> found() const { return is_tied_ ? std::nullopt : found_; }

 private:
  std::optional<Push> found_;
  bool is_tied_ = false;
};

// Robots push each other with their hulls or, in 2026, through the ball between them ("if both
// robots keep contact to the ball").
bool are_in_contact(const TrackedRobot& west, const TrackedRobot& east, const RobotSet& with_ball,
                    Edition edition) {
  if ((east.position_m - west.position_m).norm() < kInContact_m) return true;
  if (edition != Edition::kRules2026) return false;
  return with_ball.has({Side::kWest, west.number}) && with_ball.has({Side::kEast, east.number});
}

// The robots in contact with the ball; `had_ball` contains those in the previous frame.
RobotSet robots_with_ball(const RobotSet& had_ball, const RefereeInput& input) {
  RobotSet with_ball;
  if (!input.tracks.ball) return with_ball;
  const TrackedBall& ball = *input.tracks.ball;
  for (const Side side : kSides) {
    for (const TrackedRobot& robot : input.tracks.robots[side]) {
      if ((robot.position_m - ball.position_m).squaredNorm() > square(kNear_m)) continue;
      const RobotId id{side, robot.number};
      const double gap_m =
          distance_to_hull(ball.position_m, robot.position_m, robot.heading) - kBallRadius_m;
      const bool had = had_ball.has(id) || gap_m < kAtBall_m;
      if (has_ball(robot, ball, had, input.configuration.noise)) with_ball.add(id);
    }
  }
  return with_ball;
}

std::optional<Push> watch_robots(PushingWatch& watch, const RefereeInput& input) {
  const RuleBook& rules = input.configuration.rules;
  LongestPush longest;
  watch.with_ball = robots_with_ball(watch.with_ball, input);
  for (PushContact& contact : watch.contacts) contact.is_near = false;
  for (const TrackedRobot& west : input.tracks.robots[Side::kWest]) {
    for (const TrackedRobot& east : input.tracks.robots[Side::kEast]) {
      const double distance_m = (east.position_m - west.position_m).norm();
      if (distance_m > kNear_m) continue;
      PushContact* contact = contact_of(watch, west.number, east.number);
      if (contact == nullptr) continue;
      follow(*contact, west, east, input.ball,
             distance_m > kRobotRadius_m &&
                 are_in_contact(west, east, watch.with_ball, rules.edition));
      if (!contact->are_in_contact) continue;
      longest.take_in(push_by(Side::kWest, *contact, west, east, rules));
      longest.take_in(push_by(Side::kEast, *contact, east, west, rules));
    }
  }
  const auto is_over = [](const PushContact& contact) { return !contact.is_near; };
  watch.contacts.erase(std::remove_if(watch.contacts.begin(), watch.contacts.end(), is_over),
                       watch.contacts.end());
  return longest.found();
}

std::optional<Finding> find_bot_pushed_bot(RefereeState& state, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  const std::optional<Push> push = watch_robots(state.watch.bot_pushed_bot, input);
  if (!push) return std::nullopt;
  Finding finding = contact_foul_of(Event::kBotPushedBot, RuleId::kBotPushedBot, c, push->pusher,
                                    push->position_m, push->position_m);
  finding.robots.push_back(push->pushed);
  if (c.rules.edition == Edition::kRules2026) {
    finding.ball_to_m =
        free_kick_position(c.field, c.rules, opponent_of(push->pusher.side), push->ball_from_m);
  }
  finding.value = push->path_m;
  finding.evidence = fmt::format("{} pushed {} back by {:.0f} mm while they were in contact.",
                                 text_of(push->pusher), text_of(push->pushed), 1e3 * push->path_m);
  return finding;
}

}  // namespace

constinit const Rule kBotPushedBotRule{{State::kRun}, find_bot_pushed_bot};

}  // namespace autoref::referee
