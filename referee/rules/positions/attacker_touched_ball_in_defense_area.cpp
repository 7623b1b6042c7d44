// A robot must not touch the ball in play while it is partly or entirely inside the opponents'
// defence area (2026, Attacker In Defense Area). Play continues. If the touch continues, it counts
// as another foul every 2 s.
#include <fmt/format.h>

#include "referee/geometry/area.hpp"
#include "referee/rules/called_touch.hpp"
#include "referee/rules/rule.hpp"
#include "referee/touch/touch_candidates.hpp"

namespace autoref::referee {
namespace {

Finding touched_inside(const BallTouch& touch, const RobotObservation& toucher, double distance_m,
                       const RefereeInput& input) {
  Finding finding = offence_of(Event::kAttackerTouchedBallInDefenseArea,
                               RuleId::kAttackerTouchedBallInDefenseArea, input.configuration,
                               *touch.robot, touch.ended_m);
  finding.value = distance_m;
  finding.threshold = 0;
  finding.unit = "m";
  finding.details.robot_m = toucher.position_m;
  finding.evidence = fmt::format("{} touched the ball, {} the area of {}.",
                                 text_of({touch.robot->side, toucher.number}), gap_text(distance_m),
                                 colour_of(opponent_of(*touch.side)));
  return finding;
}

double distance_to_area_m(const BallTouch& touch, const RobotObservation& toucher,
                          const RefereeInput& input) {
  return hull_to_area_m(input.configuration.field, opponent_of(*touch.side), toucher);
}

std::optional<Finding> check(RefereeState& state, const BallTouch& touch,
                             const RefereeInput& input) {
  const double distance_m = distance_to_area_m(touch, *touch.toucher, input);
  CalledTouch& called = state.watch.touch_in_area;
  if (!(distance_m < 0) || is_called(called, touch)) return std::nullopt;
  called = called_at(touch, input.time_s());
  return touched_inside(touch, *touch.toucher, distance_m, input);
}

// Finds a touch that has been called and continues while the robot is still inside the area.
std::optional<Finding> find_again(RefereeState& state, const RefereeInput& input) {
  CalledTouch& called = state.watch.touch_in_area;
  const BallTouch* touch = state.play.touches.newest();
  if (touch == nullptr || !touch->robot || touch->apart_s || !is_called(called, *touch)) {
    return std::nullopt;
  }
  called.ended_s = input.time_s();
  if (!has_passed(called.called_s, input.configuration.rules.foul_repeat_s, input.time_s())) {
    return std::nullopt;
  }
  const RobotObservation* robot =
      find_robot(input.frame.robots[touch->robot->side], touch->robot->number);
  if (robot == nullptr) return std::nullopt;
  const double distance_m = distance_to_area_m(*touch, *robot, input);
  if (!(distance_m < 0)) return std::nullopt;
  called.called_s = input.time_s();
  return touched_inside(*touch, *robot, distance_m, input);
}

std::optional<Finding> find_attacker_touched_ball_in_defense_area(RefereeState& state,
                                                                  const RefereeInput& input) {
  if (std::optional<Finding> found = find_in_touches(state, input, check)) return found;
  return find_again(state, input);
}

}  // namespace

constinit const Rule kAttackerTouchedBallInDefenseAreaRule{
    {State::kRun}, find_attacker_touched_ball_in_defense_area};

}  // namespace autoref::referee
