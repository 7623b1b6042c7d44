#include "referee/machine/ball_in_play.hpp"

#include <algorithm>

#include "referee/geometry/ball_out.hpp"
#include "referee/machine/guards.hpp"

namespace autoref::referee {
namespace {

void mark_position(PlayState& play, const RefereeInput& input) {
  play.stuck_at_m = input.ball->position_m;
  play.stuck_since_s = input.time_s();
}

bool is_taken_again(Event event) {
  return event == Event::kDefenderTooCloseToKickPoint || event == Event::kKickoffPositions ||
         event == Event::kPenaltyPositions;
}

}  // namespace

double goalwards_m(const PlayState& play, const RefereeInput& input) {
  return play.kicker ? goal_sign(opponent_of(*play.kicker)) * input.ball->position_m.x() : 0;
}

PlayState play_begun(Command command, std::optional<Side> kicker, const RefereeInput& input) {
  PlayState play;
  play.began_with = play.restart = command;
  play.kicker = kicker;
  play.began_s = input.time_s();
  play.in_play = command.kind == CommandKind::kForceStart;
  play.in_play_since_s = input.time_s();
  play.stuck_since_s = input.time_s();
  if (input.ball) {
    play.ball_from_m = play.position_m = input.ball->position_m;
    play.stuck_at_m = input.ball->position_m;
    play.lies_outside = is_out_of_field(input.configuration.field, input.ball->position_m);
  }
  return play;
}

PlayState play_joined(const RefereeInput& input) {
  PlayState play = play_begun({CommandKind::kForceStart, Side::kWest}, std::nullopt, input);
  play.lies_outside = false;
  return play;
}

void watch_play(PlayState& play, const RefereeInput& input) {
  play.entered_now = false;
  if (!input.ball) return;
  play.touches.update(input, play.began_s);
  if (play.is_penalty()) play.farthest_m = std::max(play.farthest_m, goalwards_m(play, input));
  const RuleBook& rules = input.configuration.rules;
  if (!play.ball_from_m) {
    play.ball_from_m = input.ball->position_m;
    mark_position(play, input);
  }
  if (!is_out_of_field(input.configuration.field, input.ball->position_m))
    play.lies_outside = false;
  play.moved_m = std::max(play.moved_m, (input.ball->position_m - *play.ball_from_m).norm());
  if (!play.in_play && play.moved_m > rules.in_play_m) {
    play.in_play = true;
    play.entered_now = true;
    play.in_play_since_s = input.time_s();
    mark_position(play, input);
  }
  if (play.in_play && !play.kick_ended_s && play.moved_m > rules.double_touch_m &&
      has_passed(play.in_play_since_s, rules.double_touch_s, input.time_s())) {
    play.kick_ended_s = input.time_s();
  }
  // The reference position moves only when the ball is `stuck_distance_m` away from this position,
  // so neither noise nor rolling to and fro restarts the timer.
  if ((input.ball->position_m - play.stuck_at_m).norm() >= rules.stuck_distance_m) {
    mark_position(play, input);
  }
}

bool began_with_kickoff(const PlayState& play, const Field& field) {
  return play.began_with.kind == CommandKind::kNormalStart && play.ball_from_m &&
         play.ball_from_m->norm() < field.centre_circle_radius_m;
}

bool began_with_penalty(const PlayState& play, const Field& field) {
  return play.began_with.kind == CommandKind::kNormalStart && play.ball_from_m &&
         play.ball_from_m->norm() >= field.centre_circle_radius_m;
}

bool is_straight_from_restart(const PlayState& play) {
  if (!play.kicker || !play.touches.is_one_robots()) return false;
  const BallTouch* touch = play.touches.newest();
  return touch == nullptr || !touch->side || touch->side == play.kicker;
}

bool may_be_taken_again(const RefereeState& state, const RuleBook& rules) {
  return state.retakes.count < rules.retakes;
}

void take_again(Finding& finding, const PlayState& play) {
  finding.restart = play.restart;
  finding.ball_to_m = play.position_m;
}

bool keep_restart(Finding& finding, const RefereeState& state) {
  const std::optional<Command> pending = pending_restart(state);
  if (!pending || !state.signal.placement) return false;
  finding.restart = *pending;
  finding.ball_to_m = state.signal.placement->target_m;
  return true;
}

Retakes retakes_after(const Retakes& before, const Finding& finding) {
  if (!is_taken_again(finding.event)) return {};
  Retakes after = before;
  ++after.count;
  if (finding.event == Event::kDefenderTooCloseToKickPoint) {
    for (const RobotId robot : finding.robots) after.too_near.add(robot);
  }
  return after;
}

}  // namespace autoref::referee
