// "Each robot must be at least 200 mm away from the opposing team's defense area, or an indirect
// free kick is awarded to the opposing team" (paper, section 4.2).
//
// Deviation D9: the rule is judged when the ball enters play from a restart, as in the Laws,
// because a rule in force at all times would forbid attacking. The kicking side is judged first, so
// that the order of the sides never decides between two offenders. Under the Laws, only the kicking
// side is judged (law 9, "a member of the kicker's team").
//
// 2026, Attacker Too Close To Defense Area: during stop and free kicks, robots keep 0.2 m away from
// the opponents' defence area. They have 2 s to leave after the start of the stop. After that, a
// violation gives the opponents a free kick, and the team has another 2 s to leave. The team's
// second foul in the same stop or free kick halts the game (attacker_grace_s and
// area_fouls_per_halt in the rule book). A free kick belongs to the stop before it until the ball
// is in play.
#include <fmt/format.h>
#include <algorithm>

#include "referee/geometry/area.hpp"
#include "referee/geometry/hull.hpp"
#include "referee/geometry/restarts.hpp"
#include "referee/machine/ball_in_play.hpp"
#include "referee/machine/guards.hpp"
#include "referee/rules/rule.hpp"
#include "referee/touch/touch_candidates.hpp"

namespace autoref::referee {
namespace {

struct Offence {
  RobotId robot;
  Vec2 position_m{0, 0};
  double distance_m = 0;
};

// The robot of `side` nearest to the opponents' area, if it is closer than `least_m`.
std::optional<Offence> nearest_of(Side side, double least_m, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  std::optional<Offence> worst;
  double nearest_m = least_m;
  for (const RobotObservation& robot : input.frame.robots[side]) {
    const double distance_m = hull_to_area_m(c.field, opponent_of(side), robot);
    if (!(distance_m < nearest_m)) continue;
    nearest_m = distance_m;
    worst = Offence{{side, robot.number}, robot.position_m, distance_m};
  }
  return worst;
}

std::optional<Finding> find_attacker_too_close_to_defense_area(RefereeState& state,
                                                               const RefereeInput& input) {
  const Configuration& c = input.configuration;
  // At a penalty kick, rule penalty_positions decides where robots may be.
  if (c.rules.edition == Edition::kRules2026 || state.play.is_penalty()) return std::nullopt;
  if (!state.play.entered_now || !state.play.kicker) return std::nullopt;
  const double least_m = c.rules.attacker_to_area_m;
  std::optional<Offence> offence = nearest_of(*state.play.kicker, least_m, input);
  if (!offence && c.rules.edition != Edition::kLaws2014) {
    offence = nearest_of(opponent_of(*state.play.kicker), least_m, input);
  }
  if (!offence) return std::nullopt;
  Finding finding =
      offence_of(Event::kAttackerTooCloseToDefenseArea, RuleId::kAttackerTooCloseToDefenseArea, c,
                 offence->robot, offence->position_m);
  finding.value = offence->distance_m;
  finding.evidence =
      fmt::format("When the ball entered play, the hull of {} was {} the opponents' area.",
                  text_of(offence->robot), gap_text(offence->distance_m));
  return finding;
}

// Kick-offs and penalty kicks have their own position rules. Before a kick-off, all robots return
// to their own half; after half-time, they come from the other end of the field.
bool is_in_force(const RefereeState& state) {
  if (state.machine_state == State::kWaitStop) {
    const std::optional<Command>& next = state.signal.next_command;
    return state.signal.command.kind == CommandKind::kStop &&
           !(next && next->kind == CommandKind::kPrepareKickoff);
  }
  const PlayState& play = state.play;
  return !play.in_play && play.kicker && !play.is_kickoff() && !play.is_penalty();
}

// Of the robots of `side` that are too close to the area, the nearest one, if the side's grace
// period is over.
std::optional<Offence> overdue(Side side, AttackerNearAreaWatch& watch, const RefereeInput& input) {
  const RuleBook& rules = input.configuration.rules;
  std::optional<double>& grace_from_s = watch.grace_from_s[side];
  if (!grace_from_s) grace_from_s = input.time_s();
  if (!has_passed(*grace_from_s, rules.attacker_grace_s, input.time_s())) return std::nullopt;
  const double least_m = rules.attacker_to_area_m - robot_uncertainty_m(input.configuration.noise);
  std::optional<Offence> found = nearest_of(side, least_m, input);
  if (!found) return std::nullopt;
  ++watch.fouls[side];
  grace_from_s = input.time_s();
  return found;
}

void add(Finding& finding, const Offence& offence, int fouls) {
  finding.robots.push_back(offence.robot);
  finding.evidence += fmt::format(
      "{}The hull of {} is {} the opponents' area{}.", finding.evidence.empty() ? "" : " ",
      text_of(offence.robot), gap_text(offence.distance_m),
      fouls > 1 ? fmt::format(", the team's {} such foul in this stop", ordinal(fouls)) : "");
}

// A free kick for the opponents from the ball's position. A restart that is about to be taken does
// not change if both sides foul or if it is a kick-off or a penalty kick.
void set_restart(Finding& finding, const RefereeState& state, const RefereeInput& input) {
  const Configuration& c = input.configuration;
  const bool is_stopped = state.machine_state == State::kWaitStop;
  const bool keeps = is_stopped && (!finding.offender || needs_preparation(pending_restart(state)));
  if (keeps && keep_restart(finding, state)) return;
  if (finding.offender) {
    const Side kicker = opponent_of(*finding.offender);
    const Vec2 ball_m = input.ball ? input.ball->position_m : Vec2(0, 0);
    finding.restart = {CommandKind::kDirectFree, kicker};
    finding.ball_to_m = free_kick_position(c.field, c.rules, kicker, ball_m);
  } else if (!is_stopped) {
    take_again(finding, state.play);
  }
}

std::optional<Finding> find_attacker_stays_near_area(RefereeState& state,
                                                     const RefereeInput& input) {
  const RuleBook& rules = input.configuration.rules;
  if (rules.edition != Edition::kRules2026) return std::nullopt;
  AttackerNearAreaWatch& watch = state.watch.attacker_too_close_to_defense_area;
  if (state.machine_state == State::kRun && state.play.in_play) watch = {};
  if (!is_in_force(state)) return std::nullopt;
  const std::optional<Offence> west = overdue(Side::kWest, watch, input);
  const std::optional<Offence> east = overdue(Side::kEast, watch, input);
  if (!west && !east) return std::nullopt;
  const Offence& worst = west && (!east || west->distance_m <= east->distance_m) ? *west : *east;
  Finding finding =
      finding_of(Event::kAttackerStaysNearArea, RuleId::kAttackerTooCloseToDefenseArea, rules);
  finding.value = worst.distance_m;
  finding.details.robot = worst.robot;
  if (!west || !east) {
    finding.offender = worst.robot.side;
    finding.position_m = worst.position_m;
  }
  if (west) add(finding, *west, watch.fouls[Side::kWest]);
  if (east) add(finding, *east, watch.fouls[Side::kEast]);
  set_restart(finding, state, input);
  return finding;
}

}  // namespace

constinit const Rule kAttackerTooCloseToDefenseAreaRule{
    {{State::kRun}, find_attacker_too_close_to_defense_area},
    {{State::kRun, State::kWaitStop}, find_attacker_stays_near_area}};

}  // namespace autoref::referee
