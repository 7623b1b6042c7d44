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
  const Side side = touches[0].robot.side;
  const bool has_ball = owners.after && owners.after->team == side;
  if (!has_ball) {
    if (!next_) next_ = action_from(touches, is_kick_away, owners.before, now);
    return;
  }
  if (next_ && next_->robot.side == side) begin(*next_);
  next_.reset();
  if (!is_kick_away && goes_on_with(touches)) return;
  begin(action_from(touches, is_kick_away, owners.before, now));
}

void BallActions::note_shot(Side team) {
  if (next_ && next_->robot.side == team) begin(*next_);
  if (action_ && action_->robot.side == team) action_->is_shot = true;
}

void BallActions::end_kick() {
  if (action_) action_->is_kick_over = action_->is_kick;
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
  next_.reset();
}

double BallActions::value_to_west(const std::optional<BallOwner>& owner,
                                  const sim::WorldState& now) const {
  if (!owner) return 0;
  const SituationValue value =
      model_->value(value_features(*owner, now, field_), owner->shot_chance);
  return seen_by(owner->team, value.scores - value.concedes);
}

// The action that begins with these touches. Its value is that of the situation in which the robot
// acts: before a kick, but after any other touch.
BallActions::Action BallActions::action_from(std::span<const sim::Touch> touches, bool is_kick_away,
                                             const std::optional<BallOwner>& before,
                                             const sim::WorldState& now) const {
  // Touches in the same sub-step are in no particular order.
  const sim::Touch& touch = *std::min_element(touches.begin(), touches.end(),
                                              [](const sim::Touch& one, const sim::Touch& other) {
                                                return one.robot.number < other.robot.number;
                                              });
  const BallOwner owner{touch.robot.side};
  const bool takes_restart = before && before->is_restart && before->team == owner.team;
  const double value = takes_restart  ? value_to_west(before, now)
                       : is_kick_away ? value_to_west(owner, before_kick(touch, now))
                                      : value_to_west(owner, now);
  return {touch.robot, is_kick_away, false, false, touch.frame, touch.ball_m, value};
}

// Whether these touches belong to the action in progress, which is a dribble or a kick whose hull
// still touches the departing ball.
bool BallActions::goes_on_with(std::span<const sim::Touch> touches) const {
  return action_ && !action_->is_kick_over &&
         std::any_of(touches.begin(), touches.end(),
                     [this](const sim::Touch& one) { return one.robot == action_->robot; });
}

// Ends the action in progress and begins the next one.
void BallActions::begin(const Action& action) {
  end(action.frame, action.ball_m, action.value, action.robot.side);
  action_ = action;
}

// `value`: to west. `next`: the team that has the ball or gets the restart.
void BallActions::end(std::int64_t frame, const Vec2& ball_m, double value, Side next) {
  if (!action_) return;
  const Side team = action_->robot.side;
  const ActionKind kind_if_kept = action_->is_kick ? ActionKind::kPass : ActionKind::kDribble;
  const ActionKind kind = action_->is_shot ? ActionKind::kShot
                          : next == team   ? kind_if_kept
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
