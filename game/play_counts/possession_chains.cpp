#include "game/play_counts/possession_chains.hpp"

namespace autoref::game {
namespace {

// How the chain begins if the restart after this call is a free kick.
ChainStart free_kick_after(referee::Event call) {
  switch (call) {
    case referee::Event::kThrowIn:
      return ChainStart::kThrowIn;
    case referee::Event::kCornerKick:
      return ChainStart::kCornerKick;
    case referee::Event::kGoalKick:
      return ChainStart::kGoalKick;
    default:
      return ChainStart::kFreeKick;
  }
}

NextRestart restart_after(const referee::Finding& call) {
  const Side side = call.restart.side;
  switch (call.restart.kind) {
    case CommandKind::kPrepareKickoff:
      return {ChainStart::kKickOff, side};
    case CommandKind::kPreparePenalty:
      return {ChainStart::kPenalty, side};
    case CommandKind::kForceStart:
      return {};
    default:
      return {free_kick_after(call.event), side};
  }
}

// Whether the ball left the field, also into a goal that does not count.
bool is_out(referee::Event event) {
  switch (event) {
    case referee::Event::kChippedGoal:
    case referee::Event::kInvalidGoal:
    case referee::Event::kIndirectGoal:
    case referee::Event::kFreeKickOwnGoal:
    case referee::Event::kAimlessKick:
      return true;
    default:
      return referee::entry_of(event).is_exit;
  }
}

}  // namespace

std::optional<Side> scorer_in(const referee::Decision& decision) {
  if (decision.finding.event != referee::Event::kGoal || !decision.command) return std::nullopt;
  return opponent_of(decision.finding.restart.side);
}

void PossessionChains::touch(const sim::Touch& touch, bool is_kick_away, ChainStart gained) {
  const Side side = touch.robot.side;
  if (chain_ && side == chain_->team) {
    next_.reset();
    is_shot_last_ = false;
    return;
  }
  if (!next_) {
    next_.emplace();
    next_->team = side;
    next_->start = chain_ ? gained : first_start(side, gained);
    next_->first_frame = touch.frame;
    next_->first_m = touch.ball_m;
  }
  const bool is_second = touch.frame - next_->first_frame >= same_kick_frames_;
  if (!chain_ || is_kick_away || is_second) gain_ball();
}

void PossessionChains::complete_pass(Side team) {
  if (chain_ && chain_->team == team) ++chain_->passes;
}

void PossessionChains::end_shot(const Shot& shot) {
  if (next_ && next_->team == shot.team) gain_ball();
  if (!chain_ || chain_->team != shot.team) return;
  ++chain_->shots;
  chain_->xg += shot.chance;
  shots_.push_back(shot);
  is_shot_last_ = true;
}

void PossessionChains::decide(const referee::Decision& decision, const Vec2& ball_m) {
  const referee::Finding& finding = decision.finding;
  if (const std::optional<Side> scorer = scorer_in(decision)) {
    const bool has_scored = chain_ && chain_->team == *scorer;
    end(has_scored ? ChainEnd::kGoal : ChainEnd::kOwnGoal, decision.frame, ball_m);
  } else if (decision.from == referee::State::kRun && decision.to != referee::State::kRun) {
    stopped_by_ = end_by(finding);
  }
  if (decision.restart()) {
    awarded_ = {free_kick_after(finding.event), finding.restart.side};
    next_restart_ = restart_after(finding);
  }
  if (decision.command) prepare_restart(*decision.command);
}

void PossessionChains::stop(std::int64_t frame, const Vec2& ball_m) {
  end(is_shot_last_ ? ChainEnd::kShot : stopped_by_, frame, ball_m);
  stopped_by_ = ChainEnd::kWhistle;
}

// How the chain of the first touch after a restart begins.
ChainStart PossessionChains::first_start(Side side, ChainStart gained) {
  const std::optional<NextRestart> restart = restart_;
  restart_.reset();
  awarded_ = {};
  next_restart_ = {};
  if (!restart || !restart->side) return ChainStart::kLooseBall;
  return restart->side == side ? restart->start : gained;
}

void PossessionChains::gain_ball() {
  const PossessionChain next = *next_;
  end(is_shot_last_ ? ChainEnd::kShot : ChainEnd::kLost, next.first_frame, next.first_m);
  chain_ = next;
}

void PossessionChains::end(ChainEnd how, std::int64_t frame, const Vec2& ball_m) {
  if (chain_) {
    chain_->end = how;
    chain_->last_frame = frame;
    chain_->last_m = ball_m;
    ended_.push_back(*chain_);
    if (!shots_.empty()) shots_.back().has_scored = how == ChainEnd::kGoal && is_shot_last_;
    ended_shots_.insert(ended_shots_.end(), shots_.begin(), shots_.end());
    shots_.clear();
  }
  chain_.reset();
  next_.reset();
  is_shot_last_ = false;
}

void PossessionChains::prepare_restart(const Command& command) {
  switch (command.kind) {
    case CommandKind::kPrepareKickoff:
      restart_ = {ChainStart::kKickOff, command.side};
      break;
    case CommandKind::kPreparePenalty:
      restart_ = {ChainStart::kPenalty, command.side};
      break;
    case CommandKind::kDirectFree:
    case CommandKind::kIndirectFree:
      restart_ = {command.side == awarded_.side ? awarded_.start : ChainStart::kFreeKick,
                  command.side};
      break;
    case CommandKind::kForceStart:
      restart_ = NextRestart{};
      break;
    default:
      return;
  }
  next_restart_ = *restart_;
}

ChainEnd PossessionChains::end_by(const referee::Finding& finding) const {
  if (is_out(finding.event)) return ChainEnd::kOut;
  if (!referee::entry_of(finding.event).is_foul) return ChainEnd::kWhistle;
  const bool is_own = chain_ && finding.offender == chain_->team;
  return is_own ? ChainEnd::kFoul : ChainEnd::kFouled;
}

}  // namespace autoref::game
