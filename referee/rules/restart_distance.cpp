#include "referee/rules/restart_distance.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "referee/geometry/hull.hpp"
#include "referee/machine/retakes.hpp"
#include "referee/touch/touch_candidates.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

// From where the ball lay: a kick towards an opponent does not bring it nearer.
double distance_to_ball_m(const RobotObservation& robot, const PlayMemory& play) {
  return distance_to_hull(*play.ball_from_m, robot.position_m, robot.heading);
}

Misplaced too_near(Side side, const PlayMemory& play, const Moment& moment) {
  const Configuration& c = moment.configuration;
  const double least_m = c.rules.opponents_to_ball_m - robot_to_ball_doubt_m(c.noise);
  Misplaced found;
  for (const RobotObservation& robot : moment.frame.robots[side]) {
    const double distance_m = distance_to_ball_m(robot, play);
    if (distance_m < least_m) {
      found.add({side, robot.number}, distance_m, distance_m < found.worst_m);
    }
  }
  return found;
}

Finding taken_again(const Misplaced& before, const Memory& memory, const Moment& moment) {
  const PlayMemory& play = memory.play;
  Finding finding =
      finding_of(Event::kRestartDistance, RuleId::kRestartDistance, moment.configuration.rules);
  finding.value = before.worst_m;
  finding.robots = before.robots;
  finding.offender = opponent_of(*play.kicker);
  finding.position_m = play.ball_from_m;
  const bool is_repeated =
      std::any_of(before.robots.begin(), before.robots.end(),
                  [&memory](RobotId robot) { return memory.retakes.too_near.has(robot); });
  if (is_repeated) finding.card = Card::kYellow;
  take_again(finding, play);
  finding.evidence = fmt::format(
      "Just before the ball entered play, the hull of {} was {:.0f} mm from it{}: {} again.",
      before.robots.size() == 1 ? text_of(before.robots.front()) : "the nearest opponent",
      1e3 * before.worst_m, is_repeated ? ", as at the restart before" : "", name_of(play.restart));
  return finding;
}

// Laws: judged when the ball enters play.
std::optional<Finding> find_when_taken(Memory& memory, const Moment& moment) {
  Misplaced& before = memory.watch.restart_distance.before;
  if (!memory.play.in_play) {
    before = too_near(opponent_of(*memory.play.kicker), memory.play, moment);
    return std::nullopt;
  }
  if (!memory.play.entered_now || !before.any() || !may_be_taken_again(memory)) return std::nullopt;
  return taken_again(before, memory, moment);
}

Finding noted(const RobotObservation& robot, RobotId id, double lasted_s, const PlayMemory& play,
              const RuleBook& rules) {
  Finding finding = finding_of(Event::kRestartDistance, RuleId::kRestartDistance, rules);
  finding.value = distance_to_ball_m(robot, play);
  finding.robots.push_back(id);
  finding.offender = id.side;
  finding.position_m = robot.position_m;
  finding.is_foul = rules.fouls_per_card > 0;
  finding.evidence = fmt::format(
      "For {:.2f} s the hull of {} has been too near to a ball that is not in play, now {:.0f} mm.",
      lasted_s, text_of(id), 1e3 * finding.value);
  return finding;
}

// 2026: judged while the kick is waited for. Of several robots each is called in a frame of its
// own.
std::optional<Finding> find_while_waiting(Memory& memory, const Moment& moment) {
  if (memory.play.in_play) return std::nullopt;
  const RuleBook& rules = moment.configuration.rules;
  const Side side = opponent_of(*memory.play.kicker);
  RestartDistanceWatch& watch = memory.watch.restart_distance;
  std::optional<Finding> found;
  for (int number = 0; number < kMaxRobots; ++number) {
    const RobotId id{side, number};
    const RobotObservation* robot = find_robot(moment.frame.robots[side], number);
    const bool is_near =
        robot != nullptr && distance_to_ball_m(*robot, memory.play) < rules.opponents_to_ball_m;
    const double lasted_s = watch.near.update(id, is_near, moment.time_s());
    const bool is_too_long = is_near && has_passed(0, rules.restart_distance_grace_s, lasted_s);
    if (found || !is_too_long || watch.called.has(id)) continue;
    watch.called.add(id);
    watch.anew_s = moment.time_s();
    found = noted(*robot, id, lasted_s, memory.play, rules);
  }
  return found;
}

}  // namespace

std::optional<Finding> find_restart_distance(Memory& memory, const Moment& moment) {
  const PlayMemory& play = memory.play;
  if (!play.kicker || play.is_penalty() || !play.ball_from_m) return std::nullopt;
  if (moment.configuration.rules.fouls_stop_play) return find_when_taken(memory, moment);
  return find_while_waiting(memory, moment);
}

}  // namespace autoref::referee
