#include "strategies/plays/squad.hpp"

#include <algorithm>

#include "soccer/robot_shape.hpp"
#include "strategies/tactics/keeper.hpp"

namespace autoref::strategies {
namespace {

bool is_at_ball(const TrackedRobot& robot, const Vec2& ball_m) {
  constexpr double kAtBall_m = kRobotRadius_m + kBallRadius_m + 5_mm;
  return (robot.position_m - ball_m).squaredNorm() < kAtBall_m * kAtBall_m;
}

}  // namespace

Squad::Squad(const Briefing& briefing, const Plan& plan)
    : plan_(plan),
      outlook_(briefing, tuned(plan.style, briefing.params)),
      field_(outlook_),
      handler_(outlook_),
      book_{outlook_, handler_, field_},
      kept_(outlook_) {}

void Squad::decide(const TeamView& view, TeamOrders& orders) {
  outlook_.update(view);
  if (!view.own.empty()) requests_.keeper = view.own.front().number;
  if (view.play == Play::kHalt) return;
  field_.update();
  handler_.update();
  note_stop();
  note_restarter();
  Cast cast(outlook_);
  if (book_.is_settled) {
    cast = kept_;
  } else {
    choose_play(cast);
    line_up_taker(book_, cast);
    if (outlook_.is_waiting()) cast.spread();
    if (!may_take()) keep(cast);
  }
  book_.former = -1;
  for (int i = 0; i < outlook_.robots(); ++i) {
    const int number = outlook_.robot(i).number;
    if (cast.task(i).part == Part::kBall) book_.former = number;
    RobotCommand& order = orders[static_cast<std::size_t>(number)];
    order = order_for(i, cast.task(i));
    if (outlook_.rules().has(RuleId::kCrash)) ease_off(outlook_, i, order);
  }
}

// Who has taken a restart must not touch the ball again before another robot has.
void Squad::note_restarter() {
  const TeamView& now = outlook_.now();
  if (is_restart(now.play)) {
    book_.restarter = now.ours ? book_.former : -1;
    return;
  }
  if (book_.restarter < 0) return;
  if (now.play != Play::kRunning || !outlook_.rules().has(RuleId::kDoubleTouch))
    book_.restarter = -1;
  const auto has_touched = [&](const TrackedRobot& robot) {
    return robot.number != book_.restarter && is_at_ball(robot, outlook_.path().now_m());
  };
  const bool mate = std::any_of(now.own.begin(), now.own.end(), has_touched);
  const bool other =
      std::any_of(now.opponents.begin(), now.opponents.end(),
                  [&](const auto& robot) { return is_at_ball(robot, outlook_.path().now_m()); });
  if (mate || other) book_.restarter = -1;
}

void Squad::note_stop() {
  const TeamView& now = outlook_.now();
  const bool is_other = now.play != former_play_ || outlook_.robots() != former_robots_;
  if (is_other) {
    since_s_ = now.time_s;
    book_.stuck = -1;
    book_.taker_from_s = 0;
  }
  former_play_ = now.play;
  former_robots_ = outlook_.robots();
  const double waited_s = now.time_s - since_s_;
  // Later the places are kept, so that the robots come to rest.
  const bool chooses = waited_s < outlook_.style().choosing_s;
  book_.waited_s = waited_s;
  book_.is_settled = outlook_.is_waiting() && !chooses;
}

void Squad::keep(const Cast& cast) {
  kept_ = cast;
  kept_robots_ = outlook_.robots();
}

// Whether the ball waits for this team to take its restart.
bool Squad::may_take() const { return is_restart(outlook_.now().play) && outlook_.now().ours; }

void Squad::choose_play(Cast& cast) {
  const TeamView& now = outlook_.now();
  const bool is_kickoff = now.play == Play::kPrepareKickoff || now.play == Play::kKickoff ||
                          now.next == CommandKind::kPrepareKickoff;
  if (now.play == Play::kPreparePenalty || now.play == Play::kPenalty) {
    penalty(book_, cast);
  } else if (is_kickoff && !may_take()) {
    await_kickoff(book_, cast);
  } else if (may_take()) {
    if (kept_robots_ == outlook_.robots()) cast = kept_;
    take_restart(book_, cast);
  } else if (now.play == Play::kRunning) {
    plan_.open_play(book_, cast);
  } else {
    plan_.await_restart(book_, cast);
  }
}

RobotCommand Squad::order_for(int index, const Task& task) {
  switch (task.part) {
    case Part::kKeeper:
      return keep_goal(outlook_, index);
    case Part::kBall:
      return handler_.play(index);
    case Part::kReceiver:
    case Part::kStands:
    case Part::kTaker:
      return go_to(outlook_, index, task.place);
    case Part::kNone:
      break;
  }
  return {};
}

}  // namespace autoref::strategies
