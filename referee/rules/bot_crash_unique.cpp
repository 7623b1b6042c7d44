// Two opponents collide: substantial contact (Laws 12), crashing (2026).
//
// The measured value is their relative velocity just before the collision, along the line of their
// centres. The faster robot is at fault. If the speeds differ by less than 0.3 m/s, both are at
// fault under the rules of 2026. Under the Laws of 2014, neither is, and play continues without a
// call.
//
// Robots count as colliding when their 180 mm cylinders touch. If two flat fronts face each other,
// the hulls are still up to 30 mm apart at that time, but robots that approach at 1.5 m/s need four
// times that distance to brake. The collision is measured a few frames later, from the frames
// around it (robot_collision.hpp). It is called if its speed exceeds the limit by one standard
// deviation, because slower collisions are far more frequent than faster ones.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "referee/rules/robot_collision.hpp"
#include "referee/rules/rule.hpp"
#include "referee/touch/frame_history.hpp"
#include "referee/touch/touch_candidates.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"

namespace autoref::referee {
namespace {

// Distance between the centres of touching robots.
constexpr double kTouching_m = 2 * kRobotRadius_m;
// Robots count as separated after being farther apart than this for kApart_s: colliding robots
// bounce off each other a few times.
constexpr double kApart_m = kTouching_m + 20_mm;
constexpr double kApart_s = 200_ms;
// Robots that came this close in a frame may have collided. They may bounce off each other between
// two frames.
constexpr double kMayTouch_m = kTouching_m + 12_mm;
// The search for the collision starts kBefore_s before that frame; the collision is measured
// kMeasured_s after it.
constexpr double kBefore_s = 40_ms;
constexpr double kMeasured_s = 60_ms;
// Speeds that differ by less than this count as equal, since they may differ by rounding only.
constexpr double kSame_mps = 1e-6;
constexpr double kBeyondDeviations = 1;

// Time until two robots with constant relative velocity touch; nullopt if they do not touch within
// `duration_s`. `path_m` leads from one centre to the other.
std::optional<double> time_to_touch_s(const Vec2& path_m, const Vec2& velocity_mps,
                                      double duration_s) {
  // Smaller root of |path + velocity t| = kTouching_m. This form of the solution avoids subtracting
  // nearly equal numbers and dividing by a relative speed of zero.
  const double closing = -path_m.dot(velocity_mps);
  const double left_m2 = path_m.squaredNorm() - kTouching_m * kTouching_m;
  if (left_m2 <= 0) return 0.0;
  const double speed2 = velocity_mps.squaredNorm();
  const double root2 = closing * closing - speed2 * left_m2;
  if (closing <= 0 || root2 < 0) return std::nullopt;
  const double time_s = left_m2 / (closing + std::sqrt(root2));
  return time_s <= duration_s ? std::optional(time_s) : std::nullopt;
}

// The angle between two velocities, from 0 to pi; 0 if one velocity is zero.
double angle_between_rad(const Vec2& a_mps, const Vec2& b_mps) {
  const double across = a_mps.x() * b_mps.y() - a_mps.y() * b_mps.x();
  return atan2_exact(std::abs(across), a_mps.dot(b_mps));
}

// Whether vision saw a robot in that frame of play.
bool was_seen(const CrashWatch& watch, std::int64_t frame, Side side, int number) {
  const auto& seen = watch.seen[static_cast<std::size_t>(frame) % watch.seen.size()];
  return (seen[side] >> static_cast<unsigned>(number) & 1U) != 0;
}

void note_seen(CrashWatch& watch, const RefereeInput& input) {
  const auto frame = static_cast<std::size_t>(input.frames.newest());
  auto& seen = watch.seen[frame % watch.seen.size()];
  for (const Side side : kSides) {
    seen[side] = 0;
    for (const TrackedRobot& robot : input.tracks.robots[side]) {
      if (robot.is_seen) seen[side] |= 1U << static_cast<unsigned>(robot.number);
    }
  }
}

// The robots in the most recent frames. If vision missed a robot, the frame has an extrapolated
// position, which is not a detection.
PairPath path_of(const CrashWatch& watch, const FrameHistory& frames, const PairMeeting& pair) {
  PairPath path;
  const PerSide<int> numbers{{pair.west, pair.east}};
  const auto kept = static_cast<std::int64_t>(std::min(path.capacity(), watch.seen.size()));
  for (std::int64_t n = std::max<std::int64_t>(1, frames.newest() - kept + 1); n <= frames.newest();
       ++n) {
    PairSample sample{frames[n].time_s, {}};
    for (const Side side : kSides) {
      const RobotObservation* robot = find_robot(frames[n].robots[side], numbers[side]);
      if (robot == nullptr || !was_seen(watch, n, side, numbers[side])) continue;
      sample.position_m[side] = robot->position_m;
    }
    path.push_back(sample);
  }
  return path;
}

Collision collision_of(const MeasuredCollision& measured, const PairMeeting& pair) {
  const Vec2& west_mps = measured.velocity_mps[Side::kWest];
  const Vec2& east_mps = measured.velocity_mps[Side::kEast];
  const double lead_mps = west_mps.norm() - east_mps.norm();
  Collision collision;
  collision.faster = {Side::kWest, pair.west};
  collision.slower = {Side::kEast, pair.east};
  if (lead_mps < 0) std::swap(collision.faster, collision.slower);
  collision.faster_m = measured.position_m[collision.faster.side];
  collision.closing_mps = measured.closing_mps;
  collision.closing_deviation_mps = measured.closing_deviation_mps;
  collision.lead_mps = std::abs(lead_mps);
  collision.angle_rad = angle_between_rad(west_mps, east_mps);
  collision.position_m = (measured.position_m[Side::kWest] + measured.position_m[Side::kEast]) / 2;
  return collision;
}

// Whether these robots may just have collided for the first time since they were apart.
bool have_met(CrashWatch& watch, const RefereeInput& input, const TrackedRobot& west,
              const TrackedRobot& east) {
  double& met_s =
      watch.met_s[static_cast<std::size_t>(west.number)][static_cast<std::size_t>(east.number)];
  const Vec2 path_m = east.position_m - west.position_m;
  const double distance_m = path_m.norm();
  if (!has_passed(met_s, kApart_s, input.time_s())) {
    if (distance_m <= kApart_m) met_s = input.time_s();
    return false;
  }
  const double frame_s = input.time_s() - watch.before_s;
  const bool may_touch =
      distance_m <= kMayTouch_m ||
      time_to_touch_s(path_m, east.velocity_mps - west.velocity_mps, frame_s).has_value();
  if (may_touch) met_s = input.time_s();
  return may_touch;
}

bool is_drawn(const Collision& collision, const RuleBook& rules) {
  return collision.lead_mps < rules.crash_drawn_mps;
}

bool is_foul(const Collision& collision, const RuleBook& rules) {
  const bool is_called = rules.edition == Edition::kRules2026 || !is_drawn(collision, rules);
  const double surely_mps =
      collision.closing_mps - kBeyondDeviations * collision.closing_deviation_mps;
  return is_called && surely_mps > rules.crash_mps;
}

// Measures the collisions after which enough frames have been seen.
void measure(CrashWatch& watch, const RefereeInput& input) {
  const auto is_due = [&input](const PairMeeting& pair) {
    return has_passed(pair.met_s, kMeasured_s, input.time_s());
  };
  for (const PairMeeting& pair : watch.meetings) {
    if (!is_due(pair)) continue;
    const PairPath path = path_of(watch, input.frames, pair);
    const std::optional<MeasuredCollision> measured = measure_collision(
        {path.data(), path.size()}, pair.met_s - kBefore_s, input.configuration.noise);
    if (!measured) continue;
    const Collision collision = collision_of(*measured, pair);
    if (!is_foul(collision, input.configuration.rules)) continue;
    if (watch.unreported.size() < watch.unreported.capacity()) {
      watch.unreported.push_back(collision);
    }
  }
  const auto due = std::remove_if(watch.meetings.begin(), watch.meetings.end(), is_due);
  watch.meetings.erase(due, watch.meetings.end());
}

void watch_robots(CrashWatch& watch, const RefereeInput& input) {
  constexpr double kNear_m = 2 * kTouching_m;
  note_seen(watch, input);
  for (const TrackedRobot& west : input.tracks.robots[Side::kWest]) {
    for (const TrackedRobot& east : input.tracks.robots[Side::kEast]) {
      // The extrapolated position of an unseen robot is no evidence of a collision.
      if (!west.is_seen || !east.is_seen) continue;
      if ((east.position_m - west.position_m).squaredNorm() > kNear_m * kNear_m) continue;
      if (!have_met(watch, input, west, east)) continue;
      if (watch.meetings.size() == watch.meetings.capacity()) continue;
      watch.meetings.push_back({west.number, east.number, input.time_s()});
    }
  }
  watch.before_s = input.time_s();
  measure(watch, input);
}

Finding drawn_finding(const Collision& crash, const RuleBook& rules) {
  Finding finding = finding_of(Event::kBotCrashDrawn, RuleId::kBotCrashUnique, rules);
  finding.robots.push_back(crash.faster);
  finding.robots.push_back(crash.slower);
  finding.position_m = crash.position_m;
  return finding;
}

Finding crash_finding(const Collision& crash, const Configuration& configuration) {
  Finding finding = contact_foul_of(Event::kBotCrashUnique, RuleId::kBotCrashUnique, configuration,
                                    crash.faster, crash.faster_m, crash.position_m);
  finding.robots.push_back(crash.slower);
  return finding;
}

// Of two equally fast collisions, the one nearer to the field's centre comes first, so that neither
// side is favoured.
bool comes_after(const Collision& a, const Collision& b) {
  const double by_mps = b.closing_mps - a.closing_mps;
  if (std::abs(by_mps) > kSame_mps) return by_mps > 0;
  return a.position_m.squaredNorm() > b.position_m.squaredNorm();
}

// Takes the fastest unreported collision. If each side caused a collision at the same speed, and
// only one of them can stop play, neither is reported.
std::optional<Collision> take_worst(CrashWatch& watch, const RuleBook& rules) {
  auto& unreported = watch.unreported;
  const auto worst = std::max_element(unreported.begin(), unreported.end(), comes_after);
  if (worst == unreported.end()) return std::nullopt;
  const Collision crash = *worst;
  const bool is_tied =
      std::any_of(unreported.begin(), unreported.end(), [&crash](const Collision& other) {
        return other.faster.side != crash.faster.side &&
               crash.closing_mps - other.closing_mps <= kSame_mps;
      });
  unreported.erase(worst);
  if (!is_tied || !rules.fouls_stop_play) return crash;
  unreported.clear();
  return std::nullopt;
}

std::optional<Finding> find_bot_crash_unique(RefereeState& state, const RefereeInput& input) {
  const RuleBook& rules = input.configuration.rules;
  watch_robots(state.watch.bot_crash_unique, input);
  const std::optional<Collision> worst = take_worst(state.watch.bot_crash_unique, rules);
  if (!worst) return std::nullopt;
  const Collision& crash = *worst;
  Finding finding = is_drawn(crash, rules) ? drawn_finding(crash, rules)
                                           : crash_finding(crash, input.configuration);
  finding.value = crash.closing_mps;
  finding.details.speed_difference_mps = crash.lead_mps;
  finding.details.crash_angle_rad = crash.angle_rad;
  finding.evidence = fmt::format(
      "{} and {} collided at {:.2f} m/s along the line of their centres; {} was faster by {:.2f} "
      "m/s.",
      text_of(crash.faster), text_of(crash.slower), crash.closing_mps, text_of(crash.faster),
      crash.lead_mps);
  return finding;
}

}  // namespace

constinit const Rule kBotCrashUniqueRule{{State::kRun}, find_bot_crash_unique};

}  // namespace autoref::referee
