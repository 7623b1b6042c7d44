#include "live/controller/controller_operator.hpp"

#include <algorithm>

#include "game/loop/game_event_fields.hpp"
#include "soccer/units.hpp"

namespace autoref::live {
namespace {

using league::ContinueAction;
using league::ControllerInput;
using referee::Event;

constexpr double kBetweenActions_s = 1_s;
constexpr double kReady_s = 3_s;          // time for robots to go to their positions for a kick-off
constexpr double kLongestReady_s = 10_s;  // after that, play starts even if the ball is elsewhere
constexpr double kLongestStop_s = 40_s;   // longer than the controller waits for a ball placement
constexpr double kBallInPosition_m = 0.1_m;
constexpr int kMostHalts = 3;
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
  input.mutable_change()->set_origin("AutoRef");
  return input;
}

// The serialized event of the goal for which the controller halted; empty if there is none.
std::string possible_goal_in(const league::RefereePacket& packet) {
  if (packet.game_events().empty()) return "";
  const std::string& newest = *packet.game_events().rbegin();
  league::GameEventMessage event;
  const bool is_goal = event.ParseFromString(newest) && event.has_possible_goal();
  return is_goal ? newest : "";
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
  inputs.Add()->mutable_config_delta()->set_auto_continue(true);
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
  Inputs inputs;
  league::ContinueAction& action = *inputs.Add()->mutable_continue_action();
  action.set_type(*type);
  action.set_for_team(for_team_);
  return inputs;
}

void ControllerOperator::take_time(const RefereeSignal& signal, double now_s) {
  now_s_ = now_s;
  const bool counts = !is_half(signal.stage) || signal.command.kind != CommandKind::kHalt;
  if (stage_ == signal.stage && before_s_ && counts) stage_s_ += now_s - *before_s_;
  if (stage_ != signal.stage) stage_s_ = 0;
  stage_ = signal.stage;
  before_s_ = now_s;
  if (command_counter_ == signal.command_counter) return;
  command_counter_ = signal.command_counter;
  command_s_ = now_s;
  halted_ = 0;
}

bool ControllerOperator::is_half_over(Stage stage) const {
  return is_half(stage) && stage_s_ >= game_.match.half_s;
}

std::optional<ContinueAction::Type> ControllerOperator::next_action(
    const league::RefereePacket& packet, const RefereeSignal& signal, const Tracks& tracks) {
  const std::string goal = possible_goal_in(packet);
  const bool is_goal_open =
      signal.command.kind == CommandKind::kHalt && !goal.empty() && goal != decided_goal_;
  if (is_half_over(signal.stage) && !is_goal_open) {
    const bool is_last = signal.stage == Stage::kSecondHalf || game_.match.halves == 1;
    return is_last ? Action::END_GAME : Action::NEXT_STAGE;
  }
  if (signal.stage == Stage::kHalfTime) {
    return stage_s_ < game_.match.break_s ? std::nullopt : std::optional(Action::NEXT_STAGE);
  }
  if (!is_half(signal.stage) && !is_about_to_begin(signal.stage)) return std::nullopt;
  if (now_s_ - command_s_ < kBetweenActions_s) return std::nullopt;
  return signal.command.kind == CommandKind::kHalt ? in_halt(packet) : at_restart(signal, tracks);
}

// Decides a goal for which the controller is still waiting; otherwise resumes the game. If that has
// no effect, decides the goal once more, since it may look like the previous one.
std::optional<ContinueAction::Type> ControllerOperator::in_halt(
    const league::RefereePacket& packet) {
  const std::string goal = possible_goal_in(packet);
  const bool is_open = goal != decided_goal_ || halted_ >= kMostHalts;
  if (goal.empty() || !is_open) {
    ++halted_;
    return Action::RESUME_FROM_HALT;
  }
  halted_ = 0;
  decided_goal_ = goal;
  for_team_ = scorer_in(goal);
  return is_goal_valid_ ? Action::ACCEPT_GOAL : Action::REJECT_GOAL;
}

// Starts kick-offs and penalty kicks, and continues play after a stop that lasts too long.
std::optional<ContinueAction::Type> ControllerOperator::at_restart(const RefereeSignal& signal,
                                                                   const Tracks& tracks) const {
  const double waited_s = now_s_ - command_s_;
  const CommandKind kind = signal.command.kind;
  if (kind == CommandKind::kPrepareKickoff || kind == CommandKind::kPreparePenalty) {
    const bool is_in_position =
        tracks.ball && signal.placement &&
        (tracks.ball->position_m - signal.placement->target_m).norm() < kBallInPosition_m;
    const bool is_ready = waited_s >= kReady_s && is_in_position;
    return is_ready || waited_s >= kLongestReady_s ? std::optional(Action::NORMAL_START)
                                                   : std::nullopt;
  }
  if (kind != CommandKind::kStop || waited_s < kLongestStop_s) return std::nullopt;
  return signal.next_command ? Action::NEXT_COMMAND : Action::FORCE_START;
}

}  // namespace autoref::live
