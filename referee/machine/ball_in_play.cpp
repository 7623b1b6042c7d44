#include "referee/machine/ball_in_play.hpp"

namespace autoref::referee {
namespace {

void mark_place(PlayMemory& play, const Moment& moment) {
  play.stuck_at_m = moment.ball->position_m;
  play.stuck_since_s = moment.time_s();
}

}  // namespace

PlayMemory play_begun(Command command, std::optional<Side> kicker, const Moment& moment) {
  PlayMemory play;
  play.began_with = play.restart = command;
  play.kicker = kicker;
  play.began_s = moment.time_s();
  play.in_play = command.kind == CommandKind::kForceStart;
  play.in_play_since_s = moment.time_s();
  play.stuck_since_s = moment.time_s();
  if (moment.ball) {
    play.ball_from_m = play.place_m = moment.ball->position_m;
    play.stuck_at_m = moment.ball->position_m;
  }
  return play;
}

void watch_play(PlayMemory& play, const Moment& moment) {
  play.entered_now = false;
  if (!moment.ball) return;
  play.touches.update(moment, play.began_s);
  const RuleBook& rules = moment.configuration.rules;
  if (!play.ball_from_m) {
    play.ball_from_m = moment.ball->position_m;
    mark_place(play, moment);
  }
  if (!play.in_play && (moment.ball->position_m - *play.ball_from_m).norm() > rules.in_play_m) {
    play.in_play = true;
    play.entered_now = true;
    play.in_play_since_s = moment.time_s();
    mark_place(play, moment);
  }
  if ((moment.ball->position_m - play.stuck_at_m).norm() >= rules.stuck_distance_m) {
    mark_place(play, moment);
  }
}

bool began_with_kickoff(const PlayMemory& play, const Field& field) {
  return play.began_with.kind == CommandKind::kNormalStart && play.ball_from_m &&
         play.ball_from_m->norm() < field.centre_circle_radius_m;
}

bool began_with_penalty(const PlayMemory& play, const Field& field) {
  return play.began_with.kind == CommandKind::kNormalStart && play.ball_from_m &&
         play.ball_from_m->norm() >= field.centre_circle_radius_m;
}

bool is_straight_from_restart(const PlayMemory& play) {
  if (!play.kicker || !play.touches.is_one_robots()) return false;
  const BallTouch* touch = play.touches.newest();
  return touch == nullptr || !touch->side || touch->side == play.kicker;
}

}  // namespace autoref::referee
