#include "live/controller/controller_operator.hpp"

#include <algorithm>

#include "game/loop/game_event_fields.hpp"
#include "league/game_event_message.hpp"
#include "live/controller/stopped_ball.hpp"
#include "live/live_options.hpp"
#include "referee/machine/guards.hpp"
#include "soccer/units.hpp"

namespace autoref::live {
namespace {

using league::ContinueAction;
using league::ControllerInput;
using referee::Event;

constexpr double kBetweenActions_s = 1_s;
constexpr double kReady_s = 3_s;          // time for robots to go to their positions for a kick-off
constexpr double kLongestReady_s = 10_s;  // after that, play starts whatever is not ready
// Time that the controller's automatic continue gives the teams after a stop and after a halt.
constexpr double kPreparation_s = 2_s;
constexpr double kPreparationAfterHalt_s = 10_s;
constexpr int kMostResumptions = 3;
constexpr int kFriendly = 3;  // the league's number for this type of match
constexpr int kDivisionA = 1;
constexpr int kDivisionB = 2;
constexpr double kLongestFieldOfB_m = 10_m;

int league_team(Side side) { return side == Side::kWest ? 1 : 2; }

bool is_half(Stage stage) { return stage == Stage::kFirstHalf || stage == Stage::kSecondHalf; }

bool is_about_to_begin(Stage stage) {
  return stage == Stage::kFirstHalfPre || stage == Stage::kSecondHalfPre;
}

ControllerInput input_of(const league::ControllerChange& change) {
  ControllerInput input;
  *input.mutable_change() = change;
  input.mutable_change()->set_origin(kIdentifier);
  return input;
}

// The serialized event of the goal for which the controller halted and which has not been decided;
// empty without one.
std::string possible_goal_in(const league::RefereePacket& packet) {
  for (auto bytes = packet.game_events().rbegin(); bytes != packet.game_events().rend(); ++bytes) {
    league::GameEventMessage event;
    if (!event.ParseFromString(*bytes)) continue;
    if (event.has_possible_goal()) return *bytes;
    if (event.has_goal() || event.has_invalid_goal()) return "";
  }
  return "";
}

std::optional<ContinueAction::Type> action_if(bool condition, ContinueAction::Type action) {
  return condition ? std::optional(action) : std::nullopt;
}

int scorer_in(const std::string& goal) {
  league::GameEventMessage event;
  event.ParseFromString(goal);
  return event.possible_goal().by_team();
}

}  // namespace

ControllerOperator::ControllerOperator(const game::GameConfiguration& game) : game_(game) {}

ControllerOperator::Inputs ControllerOperator::set_up(const PerSide<TeamRequests>& requests) const {
  Inputs inputs;
  inputs.Add()->set_reset_match(true);
  inputs.Add()->mutable_config_delta()->set_auto_continue(false);
  league::ControllerChange change;
  auto& config = *change.mutable_update_config_change();
  config.set_division(game_.field.length_m > kLongestFieldOfB_m ? kDivisionA : kDivisionB);
  config.set_first_kickoff_team(league_team(game_.match.first_kickoff));
  config.set_match_type(kFriendly);
  config.mutable_max_robots_per_team()->set_value(
      static_cast<int>(std::max(game_.a.robots.size(), game_.b.robots.size())));
  *inputs.Add() = input_of(change);
  for (const Side side : kSides) {
    auto& team = *change.mutable_update_team_state_change();
    team.set_for_team(league_team(side));
    team.mutable_team_name()->set_value(game::shown_names(game_)[side]);
    team.mutable_goalkeeper()->set_value(requests[side].keeper);
    team.mutable_on_positive_half()->set_value(side == Side::kEast);
    *inputs.Add() = input_of(change);
  }
  return inputs;
}

ControllerOperator::Inputs ControllerOperator::leave() {
  Inputs inputs;
  inputs.Add()->mutable_config_delta()->set_auto_continue(true);
  return inputs;
}

void ControllerOperator::on_decision(const referee::Decision& decision) {
  const std::optional<GameEvent> event = game::game_event_of(decision);
  if (event && event->type == GameEventType::kPossibleGoal)
    is_goal_valid_ = decision.finding.event == Event::kGoal;
}

ControllerOperator::Inputs ControllerOperator::act(const league::RefereePacket& packet,
                                                   const RefereeSignal& signal,
                                                   const Tracks& tracks) {
  take_time(signal, tracks.time_s);
  if (now_s_ - acted_s_ < kBetweenActions_s) return {};
  for_team_ = is_for_one_side(signal.command.kind) ? league_team(signal.command.side) : 0;
  const std::optional<Action::Type> type = next_action(packet, signal, tracks);
  if (!type) return {};
  acted_s_ = now_s_;
  before_action_ = visible_in(packet);
  Inputs inputs;
  league::ContinueAction& action = *inputs.Add()->mutable_continue_action();
  action.set_type(*type);
  action.set_for_team(for_team_);
  return inputs;
}

void ControllerOperator::take_time(const RefereeSignal& signal, double now_s) {
  now_s_ = now_s;
  if (stage_ != signal.stage) {
    stage_ = signal.stage;
    stage_since_s_ = now_s;
    stage_length_s_ = signal.stage_time_left_s;
  }
  if (command_counter_ == signal.command_counter) return;
  command_counter_ = signal.command_counter;
  was_halted_ = command_ == CommandKind::kHalt;
  command_ = signal.command.kind;
  command_s_ = now_s;
  resumptions_ = 0;
  places_ball_ = false;
  if (command_ != CommandKind::kNormalStart) is_penalty_ = command_ == CommandKind::kPreparePenalty;
}

ControllerOperator::VisibleState ControllerOperator::visible_in(
    const league::RefereePacket& packet) {
  return {packet.stage(), packet.command_counter(), packet.game_events_size()};
}

bool ControllerOperator::is_done(const league::RefereePacket& packet) const {
  return visible_in(packet) != before_action_;
}

// The controller's clock says how long the half has been played: under the rules of 2026, it stands
// while play is stopped.
bool ControllerOperator::is_half_over(const RefereeSignal& signal) const {
  return is_half(signal.stage) && stage_length_s_ - signal.stage_time_left_s >= game_.match.half_s;
}

bool ControllerOperator::is_penalty_pending(const RefereeSignal& signal) const {
  return is_penalty_ ||
         (signal.next_command && signal.next_command->kind == CommandKind::kPreparePenalty);
}

// The end of a half or of the game, once it is due.
std::optional<ContinueAction::Type> ControllerOperator::at_end(const RefereeSignal& signal) const {
  const RuleBook& rules = game_.match.rules;
  if (referee::wins_at_once(rules, signal.goals)) return Action::END_GAME;
  if (!is_half_over(signal) || (rules.penalty_prolongs_half && is_penalty_pending(signal)))
    return std::nullopt;
  const bool is_last = signal.stage == Stage::kSecondHalf || game_.match.halves == 1;
  return is_last ? Action::END_GAME : Action::NEXT_STAGE;
}

std::optional<ContinueAction::Type> ControllerOperator::next_action(
    const league::RefereePacket& packet, const RefereeSignal& signal, const Tracks& tracks) {
  const std::string goal = possible_goal_in(packet);
  const bool is_halted = signal.command.kind == CommandKind::kHalt;
  const bool is_goal_open = is_halted && !goal.empty() && goal != decided_goal_;
  if (!is_halted && now_s_ < events_counted_s_) return std::nullopt;
  if (!is_goal_open && is_half(signal.stage)) {
    if (const std::optional<Action::Type> end = at_end(signal)) return end;
  }
  if (signal.stage == Stage::kHalfTime) {
    return action_if(now_s_ - stage_since_s_ >= game_.match.break_s, Action::NEXT_STAGE);
  }
  if (!is_half(signal.stage) && !is_about_to_begin(signal.stage)) return std::nullopt;
  if (now_s_ - command_s_ < kBetweenActions_s) return std::nullopt;
  switch (signal.command.kind) {
    case CommandKind::kHalt:
      return in_halt(packet);
    case CommandKind::kStop:
      return in_stop(packet, signal, tracks);
    case CommandKind::kPrepareKickoff:
    case CommandKind::kPreparePenalty:
      return before_start(signal, tracks);
    case CommandKind::kTimeout:
      return action_if(signal.timeout_left_s[signal.command.side] <= 0, Action::TIMEOUT_STOP);
    default:
      return std::nullopt;
  }
}

// Decides a goal for which the controller is still waiting; otherwise resumes the game. If that has
// no effect, decides the goal once more, since it may look like the previous one.
std::optional<ContinueAction::Type> ControllerOperator::in_halt(
    const league::RefereePacket& packet) {
  const std::string goal = possible_goal_in(packet);
  const bool is_open = goal != decided_goal_ || resumptions_ >= kMostResumptions;
  if (goal.empty() || !is_open) {
    ++resumptions_;
    return Action::RESUME_FROM_HALT;
  }
  resumptions_ = 0;
  decided_goal_ = goal;
  for_team_ = scorer_in(goal);
  return is_goal_valid_ ? Action::ACCEPT_GOAL : Action::REJECT_GOAL;
}

// Continues as the controller would by itself: a team places the ball if it lies in the wrong
// position; if none can, the operator does. Play goes on once the ball and the robots are ready.
std::optional<ContinueAction::Type> ControllerOperator::in_stop(const league::RefereePacket& packet,
                                                                const RefereeSignal& signal,
                                                                const Tracks& tracks) {
  const double waited_s = now_s_ - command_s_;
  if (!signal.next_command) return action_if(waited_s >= kLongestStop_s, Action::FORCE_START);
  const StoppedBall ball(game_, league::game_events_of(packet), signal, tracks);
  if (!ball.is_ready()) {
    places_ball_ = places_ball_ || ball.needs_placement_by_hand(waited_s);
    if (places_ball_ || !ball.is_at_rest()) return std::nullopt;
    for_team_ = league_team(*ball.placer());
    return Action::BALL_PLACEMENT_START;
  }
  const double preparation_s = was_halted_ ? kPreparationAfterHalt_s : kPreparation_s;
  if (!ball.was_placed_by(signal.next_command->side) && waited_s < preparation_s)
    return std::nullopt;
  return action_if(ball.are_robots_away() || waited_s >= preparation_s + kLongestReady_s,
                   Action::NEXT_COMMAND);
}

std::optional<ContinueAction::Type> ControllerOperator::before_start(const RefereeSignal& signal,
                                                                     const Tracks& tracks) const {
  const double waited_s = now_s_ - command_s_;
  const bool is_ready = waited_s >= kReady_s && is_in_position(signal, tracks);
  return action_if(is_ready || waited_s >= kLongestReady_s, Action::NORMAL_START);
}

}  // namespace autoref::live
