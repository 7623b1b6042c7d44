#include "league/team/league_signal.hpp"

#include <algorithm>
#include <array>

namespace autoref::league {
namespace {

// Indexed by the number of halves that have begun.
constexpr std::array kHalves = {Stage::kFirstHalfPre, Stage::kFirstHalf, Stage::kSecondHalf,
                                Stage::kExtraFirstHalf, Stage::kExtraSecondHalf};
constexpr std::array kNextHalves = {Stage::kFirstHalfPre, Stage::kSecondHalfPre,
                                    Stage::kExtraFirstHalfPre, Stage::kExtraSecondHalfPre,
                                    Stage::kShootoutBreak};

Command made_command(CommandKind kind, Side side) {
  return {kind, is_for_one_side(kind) ? side : Side::kWest};
}

bool is_prepared(CommandKind kind) {
  return kind == CommandKind::kPrepareKickoff || kind == CommandKind::kPreparePenalty;
}

}  // namespace

LeagueSignal::LeagueSignal(Side side, int robots) : side_(side) {
  signal_.robots_allowed = {{robots, robots}};
}

// A command stays in force until the next one, even while the ball is in play.
CommandKind LeagueSignal::kind_in_running_play() const {
  const CommandKind kind = signal_.command.kind;
  if (is_prepared(kind)) return CommandKind::kNormalStart;
  const bool is_restart = kind == CommandKind::kNormalStart || kind == CommandKind::kDirectFree ||
                          kind == CommandKind::kIndirectFree;
  return is_restart ? kind : CommandKind::kForceStart;
}

Command LeagueSignal::command_of(const TeamView& view) const {
  const Side side = side_of(view.ours);
  switch (view.play) {
    case Play::kHalt:
      return {CommandKind::kHalt};
    case Play::kStop:
      if (!view.placing_is_ours) return {CommandKind::kStop};
      return {CommandKind::kBallPlacement, side_of(*view.placing_is_ours)};
    case Play::kPrepareKickoff:
      return {CommandKind::kPrepareKickoff, side};
    case Play::kPreparePenalty:
      return {CommandKind::kPreparePenalty, side};
    case Play::kKickoff:
    case Play::kPenalty:
      return {CommandKind::kNormalStart};
    case Play::kDirectFree:
      return {CommandKind::kDirectFree, side};
    case Play::kIndirectFree:
      return {CommandKind::kIndirectFree, side};
    case Play::kRunning:
      return made_command(kind_in_running_play(), signal_.command.side);
  }
  return {};
}

// The time left is 0 outside the halves; penalty kicks outside the halves are those of a shoot-out.
Stage LeagueSignal::stage_of(const TeamView& view) const {
  if (view.stage_time_left_s != 0) return kHalves.at(halves_);
  const bool is_penalty = view.play == Play::kPreparePenalty || view.play == Play::kPenalty;
  const bool was_shootout = signal_.stage == Stage::kShootout;
  return is_penalty || was_shootout ? Stage::kShootout : kNextHalves.at(halves_);
}

const RefereeSignal& LeagueSignal::update(const TeamView& view) {
  if (view.stage_time_left_s > 0 && signal_.stage_time_left_s <= 0)
    halves_ = std::min(halves_ + 1, kHalves.size() - 1);
  signal_.stage = stage_of(view);
  signal_.stage_time_left_s = view.stage_time_left_s;
  const Command command = command_of(view);
  const bool is_same_again = play_ == Play::kRunning && view.play != Play::kRunning;
  if (command != signal_.command || is_same_again) {
    signal_.command = command;
    signal_.command_time_s = view.time_s;
    ++signal_.command_counter;
  }
  play_ = view.play;
  signal_.goals[side_] = view.goals_own;
  signal_.goals[opponent_of(side_)] = view.goals_opponent;
  signal_.placement.reset();
  if (view.placement_m)
    signal_.placement = Placement{side_ == Side::kWest ? *view.placement_m : -*view.placement_m};
  signal_.next_command.reset();
  if (view.next) signal_.next_command = made_command(*view.next, side_of(view.next_is_ours));
  return signal_;
}

}  // namespace autoref::league
