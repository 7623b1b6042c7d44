#include "strategies/plays/squad.hpp"

#include <algorithm>

#include "soccer/robot_shape.hpp"
#include "strategies/strategy.hpp"
#include "strategies/tactics/areas.hpp"
#include "strategies/tactics/keeper.hpp"

namespace autoref::strategies {
namespace {

bool is_at_ball(const TrackedRobot& robot, const Vec2& ball_m) {
  constexpr double kAtBall_m = kRobotRadius_m + kBallRadius_m + 5_mm;
  return (robot.position_m - ball_m).squaredNorm() < kAtBall_m * kAtBall_m;
}

}  // namespace

Squad::Squad(const TeamContext& context, const TeamPlaybook& playbook)
    : playbook_(playbook),
      predicted_(context, tuned(playbook.style, context.params)),
      field_(predicted_),
      handler_(predicted_),
      placer_(predicted_),
      book_{predicted_, handler_, field_},
      kept_(predicted_) {}

void Squad::decide(const TeamView& view, TeamCommands& commands) {
  predicted_.update(view);
  if (!view.own.empty()) requests_.keeper = view.own.front().number;
  if (view.play != Play::kHalt) command_robots(view, commands);
  predicted_.note(commands);
}

void Squad::command_robots(const TeamView& view, TeamCommands& commands) {
  field_.update();
  handler_.update();
  placer_.update(view.ball);
  note_stop();
  note_restarter();
  RoleAssignment assignment(predicted_);
  if (book_.is_settled) {
    assignment = kept_;
  } else {
    choose_play(assignment);
    line_up_taker(book_, assignment);
    if (predicted_.is_waiting()) assignment.spread();
    if (!may_take()) keep(assignment);
  }
  book_.former = -1;
  for (int i = 0; i < predicted_.robots(); ++i) {
    const int number = predicted_.robot(i).number;
    if (assignment.task(i).role == Role::kBall) book_.former = number;
    RobotCommand& command = commands[static_cast<std::size_t>(number)];
    const bool is_placed = predicted_.now().placing_is_ours || must_clear_placement(predicted_);
    command = is_placed ? command_in_placement(i, assignment.task(i))
                        : command_for(i, assignment.task(i));
    if (handler_.must_let_go(i)) command = handler_.let_go(i);
    if (i > 0) stay_out_of_areas(predicted_, i, command);
    if (predicted_.rules().has(RuleId::kBotCrashUnique)) ease_off(predicted_, i, command);
  }
}

// Keeps track of the taker of a restart, which must not touch the ball again before another robot
// has touched it.
void Squad::note_restarter() {
  const TeamView& now = predicted_.now();
  if (is_restart(now.play)) {
    book_.restarter = now.ours ? book_.former : -1;
    return;
  }
  if (book_.restarter < 0) return;
  if (now.play != Play::kRunning || !predicted_.rules().has(RuleId::kAttackerDoubleTouchedBall))
    book_.restarter = -1;
  const auto has_touched = [&](const TrackedRobot& robot) {
    return robot.number != book_.restarter && is_at_ball(robot, predicted_.path().now_m());
  };
  const bool mate = std::any_of(now.own.begin(), now.own.end(), has_touched);
  const bool other =
      std::any_of(now.opponents.begin(), now.opponents.end(),
                  [&](const auto& robot) { return is_at_ball(robot, predicted_.path().now_m()); });
  if (mate || other) book_.restarter = -1;
}

void Squad::note_stop() {
  const TeamView& now = predicted_.now();
  const bool is_other = now.play != former_play_ || now.placing_is_ours != former_placing_ ||
                        predicted_.robots() != former_robots_;
  if (is_other) {
    since_s_ = now.time_s;
    book_.stuck = -1;
    book_.taker_from_s = 0;
  }
  former_play_ = now.play;
  former_placing_ = now.placing_is_ours;
  former_robots_ = predicted_.robots();
  const double waited_s = now.time_s - since_s_;
  // Once this time is over, robots keep their positions so that they come to rest.
  const bool chooses = waited_s < predicted_.style().choosing_s;
  book_.waited_s = waited_s;
  book_.is_settled = predicted_.is_waiting() && !chooses;
}

void Squad::keep(const RoleAssignment& assignment) {
  kept_ = assignment;
  kept_robots_ = predicted_.robots();
}

// Whether this team can take its restart now.
bool Squad::may_take() const { return is_restart(predicted_.now().play) && predicted_.now().ours; }

void Squad::choose_play(RoleAssignment& assignment) {
  const TeamView& now = predicted_.now();
  const bool is_kickoff = now.play == Play::kPrepareKickoff || now.play == Play::kKickoff ||
                          now.next == CommandKind::kPrepareKickoff;
  if (now.play == Play::kPreparePenalty || now.play == Play::kPenalty) {
    penalty(book_, assignment);
  } else if (is_kickoff && !may_take()) {
    await_kickoff(book_, assignment);
  } else if (may_take()) {
    if (kept_robots_ == predicted_.robots()) assignment = kept_;
    take_restart(book_, assignment);
  } else if (now.play == Play::kRunning) {
    playbook_.open_play(book_, assignment);
  } else {
    playbook_.await_restart(book_, assignment);
  }
}

// One robot places the ball if it is this team's turn; the other robots keep clear of the ball.
RobotCommand Squad::command_in_placement(int index, const Task& task) {
  if (index == placer_.index()) return placer_.play();
  const TrackedRobot& robot = predicted_.robot(index);
  const bool moves_to_waypoint = task.role != Role::kKeeper && task.role != Role::kNone;
  const Vec2 wanted_m = moves_to_waypoint ? task.waypoint.position_m : robot.position_m;
  const std::optional<Waypoint> clear = clear_of_placement(predicted_, robot, wanted_m);
  return clear ? step_aside(predicted_, index, *clear) : command_for(index, task);
}

RobotCommand Squad::command_for(int index, const Task& task) {
  switch (task.role) {
    case Role::kKeeper:
      return keep_goal(predicted_, index);
    case Role::kGoalLine:
      return drive_via(predicted_.robot(index), task.waypoint.position_m, task.waypoint,
                       predicted_.driving(index));
    case Role::kBall:
      return handler_.play(index);
    case Role::kReceiver:
    case Role::kStands:
    case Role::kTaker:
      return go_to(predicted_, index, task.waypoint);
    case Role::kNone:
      break;
  }
  return {};
}

}  // namespace autoref::strategies
