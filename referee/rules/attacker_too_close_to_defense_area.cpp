// "Each robot must be at least 200 mm away from the opposing team's defense area, or an indirect
// free kick is awarded to the opposing team" (paper, section 4.2).
//
// Deviation D9: judged when the ball enters play from a restart, as in the Laws; always in force it
// would forbid attacking. The kicking side is judged first, so that the order of the sides never
// decides between two offenders.
//
// During stop and free kicks robots keep 0.2 m away from the opponents' defence area, and have 2 s
// to get away from it (2026, Attacker Too Close To Defense Area): a foul that is noted, once per
// robot and stop. The free kick belongs to the stop before it.
#include <fmt/format.h>

#include <algorithm>

#include "referee/geometry/area.hpp"
#include "referee/geometry/hull.hpp"
#include "referee/geometry/restarts.hpp"
#include "referee/rules/rule.hpp"
#include "referee/touch/touch_candidates.hpp"

namespace autoref::referee {
namespace {

struct Offence {
  RobotId robot;
  Vec2 position_m{0, 0};
  double distance_m = 0;
  double lasted_s = 0;  // where that counts
};

// The robot of `side` nearest to the opponents' area, if it is too near.
std::optional<Offence> nearest_of(Side side, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  std::optional<Offence> worst;
  double nearest_m = c.rules.attacker_to_area_m;
  for (const RobotObservation& robot : input.frame.robots[side]) {
    const double distance_m = hull_to_area_m(c.field, opponent_of(side), robot);
    if (!(distance_m < nearest_m)) continue;
    nearest_m = distance_m;
    worst = Offence{{side, robot.number}, robot.position_m, distance_m, 0};
  }
  return worst;
}

std::optional<Finding> find_attacker_too_close_to_defense_area(RefereeState& state,
                                                               const RefereeInput& input) {
  const Configuration& c = input.configuration;
  // A penalty kick is taken from where nobody else may be.
  if (!c.rules.fouls_stop_play || state.play.is_penalty()) return std::nullopt;
  if (!state.play.entered_now || !state.play.kicker) return std::nullopt;
  std::optional<Offence> offence = nearest_of(*state.play.kicker, input);
  if (!offence) offence = nearest_of(opponent_of(*state.play.kicker), input);
  if (!offence) return std::nullopt;
  Finding finding =
      offence_of(Event::kAttackerTooCloseToDefenseArea, RuleId::kAttackerTooCloseToDefenseArea, c,
                 offence->robot, offence->position_m);
  finding.value = offence->distance_m;
  finding.evidence = fmt::format(
      "When the ball entered play, the hull of {} was {:.0f} mm from the opponents' area.",
      text_of(offence->robot), 1e3 * offence->distance_m);
  return finding;
}

// Kick-offs and penalty kicks have places of their own for everybody.
bool is_in_force(const RefereeState& state) {
  if (state.machine_state == State::kWaitStop)
    return state.signal.command.kind == CommandKind::kStop;
  const PlayState& play = state.play;
  return !play.in_play && play.kicker && !play.is_kickoff() && !play.is_penalty();
}

// The robot of `side` that has been near for longest, of those that have been for too long.
std::optional<Offence> longest_of(Side side, AttackerNearAreaWatch& watch,
                                  const RefereeInput& input) {
  const Configuration& c = input.configuration;
  std::optional<Offence> worst;
  for (int number = 0; number < kMaxRobots; ++number) {
    const RobotId id{side, number};
    const RobotObservation* robot = find_robot(input.frame.robots[side], number);
    const double distance_m =
        robot == nullptr ? 0 : hull_to_area_m(c.field, opponent_of(side), *robot);
    const bool is_near = robot != nullptr && distance_m < c.rules.attacker_to_area_m;
    const double lasted_s = watch.near.update(id, is_near, input.time_s());
    const bool is_too_long = has_passed(0, c.rules.attacker_grace_s, lasted_s);
    if (!is_near || watch.called.has(id) || !is_too_long) continue;
    if (!worst || lasted_s > worst->lasted_s) {
      worst = Offence{id, robot->position_m, distance_m, lasted_s};
    }
  }
  return worst;
}

void add(Finding& finding, const Offence& offence) {
  finding.robots.push_back(offence.robot);
  finding.evidence += fmt::format(
      "{}For {:.2f} s the hull of {} has been near the opponents' area, now {:.0f} mm from it.",
      finding.evidence.empty() ? "" : " ", offence.lasted_s, text_of(offence.robot),
      1e3 * offence.distance_m);
}

// Nobody is the offender where both sides are.
Finding found(const std::optional<Offence>& a, const std::optional<Offence>& b,
              const RuleBook& rules) {
  const Offence& worst = a && (!b || a->distance_m <= b->distance_m) ? *a : *b;
  const bool both = a && b;
  Finding finding =
      finding_of(Event::kAttackerStaysNearArea, RuleId::kAttackerTooCloseToDefenseArea, rules);
  finding.value = worst.distance_m;
  finding.is_foul = rules.fouls_per_card > 0;
  if (!both) finding.offender = worst.robot.side;
  if (!both) finding.position_m = worst.position_m;
  if (a) add(finding, *a);
  if (b) add(finding, *b);
  return finding;
}

std::optional<Finding> find_attacker_stays_near_area(RefereeState& state,
                                                     const RefereeInput& input) {
  const RuleBook& rules = input.configuration.rules;
  if (rules.fouls_stop_play || !is_in_force(state)) return std::nullopt;
  AttackerNearAreaWatch& watch = state.watch.attacker_too_close_to_defense_area;
  const std::optional<Offence> west = longest_of(Side::kWest, watch, input);
  const std::optional<Offence> east = longest_of(Side::kEast, watch, input);
  if (!west && !east) return std::nullopt;
  if (west) watch.called.add(west->robot);
  if (east) watch.called.add(east->robot);
  return found(west, east, rules);
}

}  // namespace

constinit const Rule kAttackerTooCloseToDefenseAreaRule{
    {{State::kRun}, find_attacker_too_close_to_defense_area},
    {{State::kRun, State::kWaitStop}, find_attacker_stays_near_area}};

}  // namespace autoref::referee
