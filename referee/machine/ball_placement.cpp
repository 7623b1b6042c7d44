#include "referee/machine/ball_placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "referee/geometry/restarts.hpp"
#include "referee/machine/machine.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

// The referee draws no random numbers; the parity of the number of commands sent so far serves as
// the lot.
Side drawn_side(const RefereeState& state) {
  return state.signal.command_counter % 2 == 0 ? Side::kWest : Side::kEast;
}

bool may_place(const RefereeState& state, const RuleBook& rules, Side side) {
  return state.placement_failures[side] < rules.placement_failures &&
         !state.placing.has_failed[side];
}

double distance_to_target_m(const RefereeState& state, const RefereeInput& input) {
  return (input.ball->position_m - state.placing.target_m).norm();
}

// Records how long the ball has stayed within the resting tolerance.
void watch_rest(TeamPlacement& placing, const RefereeInput& input) {
  const bool stays = (input.ball->position_m - placing.mark_m).norm() <=
                     input.configuration.rules.ball_in_position_m;
  if (stays) return;
  placing.mark_m = input.ball->position_m;
  placing.still_since_s = input.time_s();
}

// Whether the ball has stayed within the tolerance for as long as a ball at the resting speed would
// need to cross it.
bool is_at_rest(const TeamPlacement& placing, const RefereeInput& input) {
  const RuleBook& rules = input.configuration.rules;
  return has_passed(placing.still_since_s, 2 * rules.ball_in_position_m / rules.ball_at_rest_mps,
                    input.time_s());
}

PlacementStep next_step(const RefereeState& state, const RefereeInput& input) {
  const TeamPlacement& placing = state.placing;
  const Field& field = input.configuration.field;
  const RuleBook& rules = input.configuration.rules;
  const Vec2& ball_m = input.ball->position_m;
  const bool rests = is_at_rest(placing, input);
  const double stopped_s = state.signal.command_time_s;
  if (ball_may_stay(field, rules, ball_m, placing.target_m)) {
    if (rests) return PlacementStep::kStays;
    if (!has_passed(stopped_s, rules.placement_rolling_s, input.time_s()))
      return PlacementStep::kUndecided;
  }
  if (!may_place(state, rules, placing.side)) return PlacementStep::kByHand;
  if (!is_out_of_reach(field, rules, ball_m)) return PlacementStep::kByTeam;
  return rests ? PlacementStep::kByHand : PlacementStep::kUndecided;
}

struct RobotGap {
  double any_m = std::numeric_limits<double>::infinity();
  // Smallest gap to a robot of the placing team.
  double own_m = std::numeric_limits<double>::infinity();
};

// The smallest gaps between the ball and the robots' hulls.
RobotGap robot_gap(const RefereeState& state, const RefereeInput& input) {
  RobotGap gap;
  for (const Side side : kSides) {
    for (const TrackedRobot& robot : input.tracks.robots[side]) {
      const double gap_m =
          distance_to_hull(input.ball->position_m, robot.position_m, robot.heading) - kBallRadius_m;
      gap.any_m = std::min(gap.any_m, gap_m);
      if (side == state.placing.side) gap.own_m = std::min(gap.own_m, gap_m);
    }
  }
  return gap;
}

bool is_placed(const RefereeState& state, const RefereeInput& input, double gap_m) {
  const RuleBook& rules = input.configuration.rules;
  const bool is_force_start = state.signal.next_command->kind == CommandKind::kForceStart;
  const double room_m = is_force_start ? rules.placement_robots_force_m : rules.placement_robots_m;
  return distance_to_target_m(state, input) <= rules.placement_tolerance_m && gap_m >= room_m &&
         is_at_rest(state.placing, input) &&
         has_passed(state.signal.command_time_s, rules.placement_least_s, input.time_s());
}

Finding outcome_of(Event event, const RefereeState& state, const RefereeInput& input) {
  Finding finding;
  finding.event = event;
  finding.rule = "2026, Ball Placement";
  finding.value = input.time_s() - state.signal.command_time_s;
  finding.threshold = input.configuration.rules.placement_time_s;
  finding.unit = "s";
  finding.offender = state.placing.side;
  finding.position_m = input.ball->position_m;
  finding.details.to_target_m = distance_to_target_m(state, input);
  finding.details.from_target_m = state.placing.distance_m;
  return finding;
}

// How far the ball is from its designated position, either before a placement or when a placement
// is given up because robots cannot reach the ball.
Finding step_of(const RefereeState& state, const RefereeInput& input) {
  Finding finding;
  finding.event = Event::kSignalled;
  finding.rule = "2026, Ball Placement";
  finding.position_m = input.ball->position_m;
  finding.value = distance_to_target_m(state, input);
  finding.unit = "m";
  finding.evidence = fmt::format("The ball is {:.2f} m from its position.", finding.value);
  return finding;
}

// Whether the ball has come to rest where robots cannot reach it.
bool is_lost(const RefereeState& state, const RefereeInput& input) {
  const double since_s = std::max(state.placing.still_since_s, state.signal.command_time_s);
  const RuleBook& rules = input.configuration.rules;
  return is_out_of_reach(input.configuration.field, rules, input.ball->position_m) &&
         has_passed(since_s, rules.placement_unreachable_s, input.time_s());
}

// Orders the team to place the ball.
void order_placement(RefereeState& state, const RefereeInput& input, const Finding& /*finding*/) {
  state.placing.step = PlacementStep::kNone;
  state.placing.distance_m = distance_to_target_m(state, input);
  state.watch.bot_interfered_placement = GraceTimer{};
  state.watch.interference_is_called = false;
  state.watch.attacker_too_close_to_defense_area.grace_from_s = {};
  send(state, input, {CommandKind::kBallPlacement, state.placing.side});
  wait_anew(state, input);
}

// The ball stays where it is, and play resumes from there.
void keep_ball(RefereeState& state, const RefereeInput& input, const Finding& /*finding*/) {
  state.placing.step = PlacementStep::kNone;
  state.signal.placement->target_m = input.ball->position_m;
  wait_anew(state, input);
}

void place_by_hand(RefereeState& state, const RefereeInput& input, const Finding& /*finding*/) {
  state.placing.step = PlacementStep::kNone;
  place_ball(state, state.placing.target_m);
  wait_anew(state, input);
}

void end_placement_by_hand(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  place_by_hand(state, input, finding);
  send(state, input, {CommandKind::kStop, Side::kWest});
}

void accept_placement(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  int& failures = state.placement_failures[state.placing.side];
  failures = std::max(0, failures - 1);
  keep_ball(state, input, finding);
  send(state, input, {CommandKind::kStop, Side::kWest});
}

void note_failure(RefereeState& state, const RefereeInput& input) {
  ++state.placement_failures[state.placing.side];
  state.placing.has_failed[state.placing.side] = true;
  send(state, input, {CommandKind::kStop, Side::kWest});
}

void hand_over_placement(RefereeState& state, const RefereeInput& input,
                         const Finding& /*finding*/) {
  note_failure(state, input);
  state.placing.side = opponent_of(state.placing.side);
  state.placing.step = PlacementStep::kUndecided;
  state.signal.next_command = {CommandKind::kDirectFree, state.placing.side};
  wait_anew(state, input);
}

void fail_placement(RefereeState& state, const RefereeInput& input, const Finding& finding) {
  note_failure(state, input);
  state.signal.next_command = state.placing.restart;
  place_by_hand(state, input, finding);
}

bool team_places(const RefereeState& state, const RefereeInput& /*input*/) {
  return state.placing.step == PlacementStep::kByTeam;
}

bool ball_stays(const RefereeState& state, const RefereeInput& /*input*/) {
  return state.placing.step == PlacementStep::kStays;
}

bool hand_places(const RefereeState& state, const RefereeInput& /*input*/) {
  return state.placing.step == PlacementStep::kByHand;
}

bool opponents_may_place(const RefereeState& state, const RefereeInput& input) {
  return may_place(state, input.configuration.rules, opponent_of(state.placing.side));
}

constexpr Guard kTeamPlaces{"a team may place the ball", team_places};
constexpr Guard kBallStays{"the ball rests near its position", ball_stays};
constexpr Guard kHandPlaces{"no robot can reach or may place the ball", hand_places};
constexpr Guard kOpponentsMayPlace{"the opponents may place the ball", opponents_may_place};

constexpr Action kOrderPlacement{"send BALL_PLACEMENT", order_placement};
constexpr Action kKeepBall{"leave the ball where it is; restart the wait", keep_ball};
constexpr Action kPlaceByHand{"place the ball; restart the wait", place_by_hand};
constexpr Action kEndPlacementByHand{"send STOP; place the ball; restart the wait",
                                     end_placement_by_hand};
constexpr Action kAcceptPlacement{"send STOP; restart the wait", accept_placement};
constexpr Action kHandOverPlacement{"send STOP; next = free kick for the opponents",
                                    hand_over_placement};
constexpr Action kFailPlacement{"send STOP; place the ball; next = the rule's restart",
                                fail_placement};

// clang-format off
constexpr std::array kPlacement = {
  Transition{"ball_placement", State::kWaitStop, Event::kSignalled, kTeamPlaces, kOrderPlacement,
        State::kPlacement, "2026", ""},
  Transition{"ball_stays", State::kWaitStop, Event::kSignalled, kBallStays, kKeepBall,
        State::kWaitStop, "2026", ""},
  Transition{"ball_by_hand", State::kWaitStop, Event::kSignalled, kHandPlaces, kPlaceByHand,
        State::kWaitStop, "2026", ""},
  Transition{"ball_lost", State::kPlacement, Event::kSignalled, kAlways, kEndPlacementByHand,
        State::kWaitStop, "2026", ""},
  Transition{"", State::kPlacement, Event::kPlacementSucceeded, kAlways, kAcceptPlacement,
        State::kWaitStop, "2026", ""},
  Transition{"opponents_place", State::kPlacement, Event::kPlacementFailed, kOpponentsMayPlace, kHandOverPlacement,
        State::kWaitStop, "2026", ""},
  Transition{"", State::kPlacement, Event::kPlacementFailed, kAlways, kFailPlacement,
        State::kWaitStop, "2026", ""},
  Transition{"", State::kPlacement, Event::kBotInterferedPlacement, kAlways, kAllowMoreTime,
        State::kPlacement, "2026", ""},
};
// clang-format on

}  // namespace

std::span<const Transition> transitions_of_placement() { return kPlacement; }

void leave_to_team(RefereeState& state, const RuleBook& rules, const Finding& finding) {
  state.placing = TeamPlacement{};
  if (!is_placed_by_team(finding.restart.kind)) return;
  const bool is_force_start = finding.restart.kind == CommandKind::kForceStart;
  state.placing.step = PlacementStep::kUndecided;
  state.placing.side = is_force_start ? drawn_side(state) : finding.restart.side;
  state.placing.restart = finding.restart;
  state.placing.target_m = finding.ball_to_m;
  state.signal.placement->by_hand = false;
  // "All free kicks that were a result of the ball leaving the field, are awarded to the opposing
  // team."
  const Side other = opponent_of(state.placing.side);
  if (is_force_start || !entry_of(finding.event).is_exit) return;
  if (may_place(state, rules, state.placing.side) || !may_place(state, rules, other)) return;
  state.placing.side = other;
  state.placing.restart.side = other;
  state.signal.next_command = state.placing.restart;
}

bool is_placed_by_team(CommandKind kind) {
  return kind == CommandKind::kDirectFree || kind == CommandKind::kIndirectFree ||
         kind == CommandKind::kForceStart;
}

bool is_placement_due(const RefereeState& state) {
  return state.placing.step != PlacementStep::kNone;
}

std::optional<Finding> find_placement_step(RefereeState& state, const RefereeInput& input) {
  if (!input.ball) return std::nullopt;
  watch_rest(state.placing, input);
  if (!has_passed(state.signal.command_time_s, input.configuration.rules.placement_command_s,
                  input.time_s()))
    return std::nullopt;
  state.placing.step = next_step(state, input);
  if (state.placing.step == PlacementStep::kUndecided) return std::nullopt;
  return step_of(state, input);
}

std::optional<Finding> find_placement_outcome(RefereeState& state, const RefereeInput& input) {
  watch_rest(state.placing, input);
  const RobotGap gap = robot_gap(state, input);
  if (is_placed(state, input, gap.any_m)) {
    Finding finding = outcome_of(Event::kPlacementSucceeded, state, input);
    finding.evidence =
        fmt::format("The ball rests {:.0f} mm from its position, after {:.2f} m.",
                    1e3 * distance_to_target_m(state, input), state.placing.distance_m);
    return finding;
  }
  if (is_lost(state, input)) return step_of(state, input);
  if (!has_passed(state.wait_began_s, input.configuration.rules.placement_time_s, input.time_s()))
    return std::nullopt;
  Finding finding = outcome_of(Event::kPlacementFailed, state, input);
  if (std::isfinite(gap.own_m)) finding.details.own_robot_to_ball_m = std::max(0.0, gap.own_m);
  finding.evidence = fmt::format(
      "The ball is {:.2f} m from its position, and the team's nearest robot {:.2f} m from the "
      "ball.",
      distance_to_target_m(state, input), gap.own_m);
  return finding;
}

}  // namespace autoref::referee
