#include "game/play_counts/ball_actions.hpp"

#include <algorithm>

namespace autoref::game {
namespace {

// West's gain as the team's.
double seen_by(Side team, double of_west) { return team == Side::kWest ? of_west : -of_west; }

// The world before the kick: the ball is still at the robot and moves with it.
sim::WorldState before_kick(const sim::Touch& kick, sim::WorldState now) {
  now.ball = {kick.ball_m};
  for (const sim::RobotState& robot : now.robots[kick.robot.side]) {
    if (robot.number == kick.robot.number) now.ball.velocity_mps = robot.velocity_mps;
  }
  return now;
}

// The robot at fault; -1 if it is unknown.
int robot_at_fault(const referee::Finding& foul, Side offender) {
  if (foul.details.robot) return foul.details.robot->number;
  const bool is_first = !foul.robots.empty() && foul.robots.front().side == offender;
  return is_first ? foul.robots.front().number : -1;
}

}  // namespace

void BallActions::touch(std::span<const sim::Touch> touches, bool is_kick_away,
                        const Owners& owners, const sim::WorldState& now) {
  const sim::Touch& touch = *std::min_element(touches.begin(), touches.end(),
                                              [](const sim::Touch& one, const sim::Touch& other) {
                                                return one.robot.number < other.robot.number;
                                              });
  const bool is_owners = owners.after && owners.after->team == touch.robot.side;
  if (!is_owners) return;  // has not gained the ball
  const bool goes_on =
      action_ && std::any_of(touches.begin(), touches.end(),
                             [this](const auto& one) { return one.robot == action_->robot; });
  if (goes_on && !is_kick_away) return;
  const double value = value_at_touch(touch, is_kick_away, owners, now);
  end(touch.frame, touch.ball_m, value, touch.robot.side);
  action_ = Action{touch.robot, is_kick_away, false, touch.frame, touch.ball_m, value};
}

void BallActions::note_shot(Side team) {
  if (action_ && action_->robot.side == team) action_->is_shot = true;
}

void BallActions::discard_kick() {
  if (action_) action_->is_kick = false;
}

void BallActions::give_goal(Side scorer, const sim::WorldState& now) {
  end(now.frame, now.ball.position_m, seen_by(scorer, 1), scorer);
}

void BallActions::call(const referee::Decision& decision, const Owners& owners,
                       const sim::WorldState& now) {
  const Vec2& ball_m = now.ball.position_m;
  const double after = value_to_west(owners.after, now);
  if (referee::entry_of(decision.finding.event).is_foul) {
    const double before = value_to_west(owners.before, now);
    if (owners.before) end(decision.frame, ball_m, before, owners.before->team);
    add_foul(decision, before, after, ball_m);
  } else if (owners.after) {
    end(decision.frame, ball_m, after, owners.after->team);
  }
}

void BallActions::stop(const std::optional<BallOwner>& owner, const sim::WorldState& now) {
  if (owner) end(now.frame, now.ball.position_m, value_to_west(owner, now), owner->team);
  action_.reset();
}

double BallActions::value_to_west(const std::optional<BallOwner>& owner,
                                  const sim::WorldState& now) const {
  if (!owner) return 0;
  const SituationValue value =
      model_->value(value_features(*owner, now, field_), owner->shot_chance);
  return seen_by(owner->team, value.scores - value.concedes);
}

// What the situation is worth to west in which the robot acts: before a kick, but after any other
// touch.
double BallActions::value_at_touch(const sim::Touch& touch, bool is_kick_away, const Owners& owners,
                                   const sim::WorldState& now) const {
  const std::optional<BallOwner>& before = owners.before;
  const bool takes_restart = before && before->is_restart && before->team == touch.robot.side;
  if (takes_restart) return value_to_west(before, now);
  if (is_kick_away) return value_to_west(BallOwner{touch.robot.side}, before_kick(touch, now));
  return value_to_west(owners.after, now);
}

// `value`: to west. `next`: the team that has the ball or gets the restart.
void BallActions::end(std::int64_t frame, const Vec2& ball_m, double value, Side next) {
  if (!action_) return;
  const Side team = action_->robot.side;
  const ActionKind kept = action_->is_kick ? ActionKind::kPass : ActionKind::kDribble;
  const ActionKind kind = action_->is_shot ? ActionKind::kShot
                          : next == team   ? kept
                                           : ActionKind::kLoss;
  ended_.push_back({team, action_->robot.number, kind, action_->frame, frame, action_->ball_m,
                    ball_m, seen_by(team, value - action_->value)});
  action_.reset();
}

void BallActions::add_foul(const referee::Decision& decision, double before, double after,
                           const Vec2& ball_m) {
  const std::optional<Side> offender = decision.finding.offender;
  if (!offender) return;  // both teams, or nobody
  ended_.push_back({*offender, robot_at_fault(decision.finding, *offender), ActionKind::kFoul,
                    decision.frame, decision.frame, ball_m, ball_m,
                    seen_by(*offender, after - before)});
}

}  // namespace autoref::game
