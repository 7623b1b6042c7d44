#include "game/play_counts/play_statistics.hpp"

#include <algorithm>
#include <cmath>

#include "game/play_counts/play_counts.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::game {

Duels::Duels(double frame_rate_hz)
    : begin_frames_(static_cast<int>(std::lround(kDuelBegins_s * frame_rate_hz))),
      most_frames_(static_cast<int>(std::lround(kLongestDuel_s * frame_rate_hz))) {}

// Computes the distance to the hull only if the robot's disc is near: most robots are far away.
Duels::Nearness Duels::nearness(const sim::WorldState& now, Side side) {
  constexpr double kReach_m = kRobotRadius_m + kBallRadius_m + kDuelOver_m;
  Nearness nearness;
  for (const sim::RobotState& robot : now.robots[side]) {
    const Vec2 away_m = robot.position_m - now.ball.position_m;
    if (away_m.squaredNorm() > kReach_m * kReach_m) continue;
    nearness.is_in_it = true;
    const double gap_m =
        distance_to_hull(now.ball.position_m, robot.position_m, robot.heading) - kBallRadius_m;
    // Hysteresis: a robot joins a duel at a small gap and leaves it at a larger one.
    if (gap_m <= kDuel_m && now.ball.height_m < kRobotHeight_m) nearness.is_at_ball = true;
  }
  return nearness;
}

std::optional<Side> Duels::update(const sim::WorldState& now, const PerSide<bool>& touched,
                                  std::optional<Side> kicked) {
  const PerSide<Nearness> near{{nearness(now, Side::kWest), nearness(now, Side::kEast)}};
  if (stage_ != Stage::kOn) {
    await(near[Side::kWest].is_at_ball && near[Side::kEast].is_at_ball);
    return std::nullopt;
  }
  for (const Side side : kSides) {
    const Side other = opponent_of(side);
    const bool has_it = kicked == side || (touched[side] && !touched[other]);
    if (has_it && !near[other].is_in_it) {
      stop();
      return side;
    }
  }
  if (++frames_ >= most_frames_) stage_ = Stage::kDrawn;
  return std::nullopt;
}

void Duels::await(bool both_at_ball) {
  if (!both_at_ball) {
    stop();
  } else if (stage_ == Stage::kNone && ++frames_ >= begin_frames_) {
    stage_ = Stage::kOn;
    frames_ = 0;
  }
}

void Duels::stop() {
  stage_ = Stage::kNone;
  frames_ = 0;
}

struct PlayStatistics::TouchGroup {
  std::span<const sim::Touch> touches;

  // The earliest group of simultaneous touches.
  static TouchGroup first_of(std::span<const sim::Touch> touches) {
    const auto end = std::find_if(touches.begin(), touches.end(), [&](const sim::Touch& touch) {
      return touch.substep != touches[0].substep || touch.is_kick != touches[0].is_kick;
    });
    return {touches.first(static_cast<std::size_t>(end - touches.begin()))};
  }
  bool has(Side side) const {
    return std::any_of(touches.begin(), touches.end(),
                       [=](const sim::Touch& touch) { return touch.robot.side == side; });
  }
  bool has_only(RobotId robot) const {
    return std::all_of(touches.begin(), touches.end(),
                       [=](const sim::Touch& touch) { return touch.robot == robot; });
  }
  // Returns nullopt if both sides touch simultaneously.
  std::optional<Side> side() const {
    const Side side = touches[0].robot.side;
    return has(opponent_of(side)) ? std::nullopt : std::optional(side);
  }
};

PlayStatistics::PlayStatistics(const Field& field, const sim::BallParameters& ball,
                               double frame_rate_hz, const ChanceModel& chances,
                               const ValueModel& values)
    : field_(field),
      ball_(ball),
      chances_(&chances),
      frame_rate_hz_(frame_rate_hz),
      same_kick_frames_(std::lround(kSameKick_s * frame_rate_hz)),
      duels_(frame_rate_hz),
      chains_(same_kick_frames_),
      actions_(field, values) {}

// Handles touches first: they happened after the previous frame, with play still in its previous
// state.
void PlayStatistics::update(const FrameSummary& summary) {
  chains_.begin_frame();
  actions_.begin_frame();
  if (is_on_) touch(summary);
  for (const referee::Decision& decision : summary.decisions) note(decision, summary.now);
  if (is_on_ && !summary.is_play_on) end_play(summary.now);
  count_chains();
  count_actions();
  is_on_ = summary.is_play_on;
  if (summary.is_ball_in_play && last_touch_) ++possession_frames_[*last_touch_];
}

PerSide<PlayCounts> PlayStatistics::counts() const {
  PerSide<PlayCounts> counts = counts_;
  for (const Side side : kSides) {
    counts[side].possession_s = static_cast<double>(possession_frames_[side]) / frame_rate_hz_;
  }
  return counts;
}

std::optional<BallOwner> PlayStatistics::ball_owner() const {
  if (const std::optional<Side> team = chains_.team()) {
    BallOwner owner{*team};
    if (kick_ && kick_->robot.side == *team && kick_->shot)
      owner.shot_chance = chances_->chance_on_target(*kick_->shot);
    return owner;
  }
  return next_kicker();
}

// Who will take the next restart.
std::optional<BallOwner> PlayStatistics::next_kicker() const {
  const NextRestart& restart = chains_.next_restart();
  if (!restart.side) return std::nullopt;
  return BallOwner{*restart.side, true, restart.start == ChainStart::kPenalty};
}

void PlayStatistics::touch(const FrameSummary& summary) {
  PerSide<bool> touched;
  for (std::span<const sim::Touch> rest = summary.touches; !rest.empty();) {
    const TouchGroup group = TouchGroup::first_of(rest);
    touch(group, summary.now);
    for (const Side side : kSides) touched[side] = touched[side] || group.has(side);
    rest = rest.subspan(group.touches.size());
  }
  const std::optional<Side> kicked = kick_ ? std::optional(kick_->robot.side) : std::nullopt;
  if (const auto winner = duels_.update(summary.now, touched, kicked)) {
    ++counts_[*winner].duels_won;
  }
}

void PlayStatistics::touch(const TouchGroup& group, const sim::WorldState& now) {
  if (std::abs(group.touches[0].ball_m.x()) > field_.half_length_m() + kBallRadius_m) return;
  const ChainStart gained = gained_by(group, now);
  const std::optional<BallOwner> before = ball_owner();
  meet(group);
  const std::optional<Side> side = group.side();
  if (!side) return;
  last_touch_ = side;
  const sim::Touch& first = group.touches[0];
  if (first.is_kick) kick_ = kick_away(first, now, field_, ball_);
  const bool is_kick_away = first.is_kick && kick_;
  chains_.touch(first, is_kick_away, gained);
  actions_.touch(group.touches, is_kick_away, {before, ball_owner()}, now);
}

// Call it before meet(), which ends the kick in progress.
ChainStart PlayStatistics::gained_by(const TouchGroup& group, const sim::WorldState& now) const {
  const sim::Touch& first = group.touches[0];
  const Side side = first.robot.side;
  if (chains_.team() == side) return ChainStart::kLooseBall;  // has the ball already
  if (distance_to_defence_area(field_, side, first.ball_m) <= 0) return ChainStart::kKeeper;
  if (kick_ && kick_->robot.side != side && (first.ball_m - kick_->from_m).norm() >= kAway_m)
    return ChainStart::kInterception;
  return Duels::nearness(now, opponent_of(side)).is_in_it ? ChainStart::kDuel
                                                          : ChainStart::kLooseBall;
}

// Handles a touch while a kick is in progress, by the kicker or by other robots.
void PlayStatistics::meet(const TouchGroup& group) {
  if (!kick_) return;
  const sim::Touch& first = group.touches[0];
  const bool is_kickers_own = group.has_only(kick_->robot);
  if (is_kickers_own && !first.is_kick && first.frame - kick_->frame <= same_kick_frames_) return;
  const bool is_away = (first.ball_m - kick_->from_m).norm() >= kAway_m;
  if (is_kickers_own || !is_away) {
    discard_kick();
  } else {
    settle(group.has(opponent_of(kick_->robot.side)) ? Next::kOpponent : Next::kMate);
  }
}

void PlayStatistics::discard_kick() {
  kick_.reset();
  actions_.discard_kick();
}

void PlayStatistics::settle(Next next) {
  if (!kick_) return;
  const KickAway kick = *kick_;
  kick_.reset();
  actions_.end_kick();
  PlayCounts& team = counts_[kick.robot.side];
  if (next == Next::kMate && kick.is_for_mate) {
    ++team.passes_tried;
    ++team.passes_completed;
    chains_.complete_pass(kick.robot.side);
  } else if (kick.shot || next == Next::kGoal) {
    count_shot(shot_of(kick));
    const bool is_met = next == Next::kOpponent && kick.shot->path.is_on_target;
    if (is_met || next == Next::kGoal) ++team.shots_on_goal;
  } else if (kick.is_for_mate) {
    ++team.passes_tried;
  }
}

// The shot of a kick that ended as one.
Shot PlayStatistics::shot_of(const KickAway& kick) const {
  Shot shot{kick.robot.side, kick.frame, kick.from_m, kick.shot};
  if (!kick.shot) return shot;
  shot.chance = chances_->chance(*kick.shot);
  shot.chance_on_target = chances_->chance_on_target(*kick.shot);
  return shot;
}

void PlayStatistics::count_shot(const Shot& shot) {
  PlayCounts& team = counts_[shot.team];
  ++team.shots;
  team.xg += shot.chance;
  team.xgot += shot.chance_on_target;
  chains_.end_shot(shot);
  actions_.note_shot(shot.team);
}

void PlayStatistics::note(const referee::Decision& decision, const sim::WorldState& now) {
  const bool has_stopped = decision.from != referee::State::kRun;
  const std::optional<BallOwner> before = has_stopped ? next_kicker() : ball_owner();
  if (const std::optional<Side> scorer = scorer_in(decision)) give_goal(*scorer, now);
  chains_.decide(decision, now.ball.position_m);
  if (decision.restart()) note_call(decision, {before, next_kicker()}, now);
  if (!referee::entry_of(decision.finding.event).is_foul) return;
  for (const Side side : kSides) {
    if (!decision.finding.offender || *decision.finding.offender == side) ++counts_[side].fouls;
  }
}

void PlayStatistics::give_goal(Side scorer, const sim::WorldState& now) {
  if (kick_ && kick_->robot.side == scorer) {
    settle(Next::kGoal);
  } else if (last_touch_ == scorer) {
    ++counts_[scorer].shots_on_goal;
    count_shot({scorer, now.frame, now.ball.position_m});
  }
  actions_.give_goal(scorer, now);
}

void PlayStatistics::note_call(const referee::Decision& decision, const BallActions::Owners& owners,
                               const sim::WorldState& now) {
  if (decision.to == referee::State::kRun) return;  // play goes on
  if (kick_ && kick_->shot) actions_.note_shot(kick_->robot.side);
  actions_.call(decision, owners, now);
}

void PlayStatistics::end_play(const sim::WorldState& now) {
  const std::optional<BallOwner> owner = ball_owner();
  settle(Next::kStop);
  actions_.stop(owner, now);
  chains_.stop(now.frame, now.ball.position_m);
  last_touch_.reset();
  duels_.stop();
}

void PlayStatistics::count_chains() {
  for (const PossessionChain& chain : chains_.ended()) {
    PlayCounts& team = counts_[chain.team];
    const auto add = [&chain](ChainCounts& counts) {
      ++counts.chains;
      counts.shots += chain.shots;
      counts.goals += chain.end == ChainEnd::kGoal ? 1 : 0;
      counts.xg += chain.xg;
    };
    add(team.by_start[static_cast<std::size_t>(chain.start)]);
    if (chain.passes > 0) add(team.with_pass);
    team.own_goals += chain.end == ChainEnd::kOwnGoal ? 1 : 0;
  }
}

void PlayStatistics::count_actions() {
  for (const BallAction& action : actions_.ended()) {
    ActionCounts& counts = counts_of(counts_[action.team], action.kind);
    ++counts.actions;
    counts.worth += action.worth;
  }
}

}  // namespace autoref::game
