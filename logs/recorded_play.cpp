#include "logs/recorded_play.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "game/play_counts/chance.hpp"
#include "logs/log_referee.hpp"
#include "referee/geometry/ball_out.hpp"
#include "referee/person/transitions_beside_person.hpp"
#include "sim/sim_configuration.hpp"

namespace autoref::logs {
namespace {

constexpr std::size_t kMostWaitingFrames = 256;
constexpr std::size_t kMostCallsInStop = 100;
// A longer gap between two frames ends the play, since nobody knows what happened in it.
constexpr auto kLongestGap_frames = static_cast<std::int64_t>(RecordedPlay::kRate_hz);

std::int64_t frame_at(double time_s) { return std::llround(time_s * RecordedPlay::kRate_hz); }

std::optional<Side> scorer(const PerSide<int>& before, const PerSide<int>& after) {
  for (const Side side : kSides)
    if (after[side] > before[side]) return side;
  return std::nullopt;
}

referee::Decision decision_in(std::int64_t frame, referee::State from, referee::State to) {
  referee::Decision decision;
  decision.frame = frame;
  decision.time_s = static_cast<double>(frame) / RecordedPlay::kRate_hz;
  decision.from = from;
  decision.to = to;
  return decision;
}

referee::Finding unknown_reason() {
  referee::Finding finding;
  finding.event = referee::Event::kCommandGiven;
  return finding;
}

bool is_preparation(CommandKind kind) {
  return kind == CommandKind::kPrepareKickoff || kind == CommandKind::kPreparePenalty;
}

}  // namespace

RecordedPlay::RecordedPlay(const referee::Configuration& configuration)
    : control_(configuration.control),
      field_(configuration.field),
      statistics_(configuration.field, sim::BallParameters{}, kRate_hz,
                  game::chance_model(configuration.rules.name),
                  game::value_model(configuration.rules.name)),
      touches_(configuration.noise) {}

void RecordedPlay::add(const LogReferee& referee) {
  std::optional<TrackedFrame> tracked = tracked_frame(referee.referee());
  if (!tracked) return;
  touches_.update(referee.referee(), *tracked);
  const auto decisions = referee.referee().decisions();
  waiting_.push_back({*std::move(tracked),
                      {decisions.begin(), decisions.end()},
                      referee.signal(),
                      referee.referee().state() == referee::State::kRun,
                      referee.referee().is_ball_in_play(),
                      referee.is_turned()});
  const double newest_s = waiting_.back().tracked.time_s;
  while (newest_s - waiting_.front().tracked.time_s > kLookAhead_s ||
         waiting_.size() > kMostWaitingFrames)
    process_oldest();
}

PlayOfLog RecordedPlay::finish() {
  PerSide<int> goals = goals_;
  if (!waiting_.empty()) goals = waiting_.back().signal.goals;
  while (!waiting_.empty()) process_oldest();
  if (is_on_) stop(unknown_reason());
  settle_stop(goals);
  play_.counts = statistics_.counts();
  play_.ball_in_play_s = static_cast<double>(frames_in_play_) / kRate_hz;
  return play_;
}

void RecordedPlay::process_oldest() {
  std::deque<TrackedFrame> frames;
  for (const JudgedFrame& frame : waiting_) frames.push_back(frame.tracked);
  const std::vector<sim::Touch> touches = touches_.take(before_, frames);
  const JudgedFrame oldest = std::move(waiting_.front());
  waiting_.pop_front();
  process(oldest, touches);
  before_ = oldest.tracked;
}

void RecordedPlay::process(const JudgedFrame& frame, const std::vector<sim::Touch>& touches) {
  if (frame.signal.stage == Stage::kShootout) return;
  const int substeps = held_over_.empty() ? 0 : held_over_.back().substep + 1;
  for (sim::Touch touch : touches) {
    touch.substep += substeps;
    held_over_.push_back(touch);
  }
  const std::int64_t number = frame_at(frame.tracked.time_s);
  if (before_ && number <= world_.frame && frame.decisions.empty()) return;
  const std::int64_t latest = std::max(number, before_ ? world_.frame : number);
  if (before_) bridge_gap(latest, frame.signal.goals);
  world_ = frame.tracked.world;
  world_.frame = latest;
  is_turned_ = frame.is_turned;
  is_in_play_ = frame.is_ball_in_play;
  std::vector<sim::Touch> numbered = std::exchange(held_over_, {});
  for (sim::Touch& touch : numbered) touch.frame = latest;
  if (is_dead_) numbered.clear();
  switch (control_) {
    case referee::Control::kAutoref:
      return process_official(frame, numbered);
    case referee::Control::kNone:
      return process_alone(frame, numbered);
    case referee::Control::kHuman:
    case referee::Control::kGameController:
      return process_followed(frame, numbered);
  }
}

// Between two samples, the world counts as unchanged.
void RecordedPlay::bridge_gap(std::int64_t frame, const PerSide<int>& goals) {
  if (!is_on_) return;
  if (frame - world_.frame > kLongestGap_frames) {
    stop(unknown_reason());
    settle_stop(goals);
    start(goals);
    return;
  }
  while (world_.frame + 1 < frame) {
    ++world_.frame;
    update({}, {}, true);
  }
}

void RecordedPlay::process_official(const JudgedFrame& frame,
                                    const std::vector<sim::Touch>& touches) {
  std::vector<referee::Decision> decisions = frame.decisions;
  for (referee::Decision& decision : decisions) decision.frame = world_.frame;
  is_on_ = frame.is_play_on;
  update(touches, decisions, is_on_);
}

void RecordedPlay::process_followed(const JudgedFrame& frame,
                                    const std::vector<sim::Touch>& touches) {
  if (is_on_) update(touches, {}, true);
  for (const referee::Decision& decision : frame.decisions) {
    if (decision.finding.event == referee::Event::kCommandGiven) {
      note_command(decision, frame);
    } else {
      note_own_decision(decision, world_);
    }
  }
}

void RecordedPlay::note_own_decision(const referee::Decision& decision,
                                     const sim::WorldState& world) {
  if (decision.to == referee::State::kCalled && decision.from != referee::State::kCalled) {
    call_ = decision.finding;
    is_dead_ = referee::is_out_of_field(field_, world.ball.position_m);
  } else if (decision.finding.event == referee::Event::kOverruled) {
    call_.reset();
    is_dead_ = false;
  } else if (is_on_ && decision.from == decision.to) {
    update({}, {decision}, true);
  } else if (!is_on_ && calls_in_stop_.size() < kMostCallsInStop) {
    calls_in_stop_.push_back(decision);
  }
}

void RecordedPlay::note_command(const referee::Decision& decision, const JudgedFrame& frame) {
  if (!decision.command) return;
  const Command command = *decision.command;
  if (is_on_) stop(call_.value_or(unknown_reason()));
  const bool starts = referee::starts_play(command.kind);
  // How the play began that the log begins with is unknown.
  const bool is_restart = starts && command.kind != CommandKind::kNormalStart;
  if (is_preparation(command.kind) || is_restart) restart_ = command;
  if (decision.from == referee::State::kInit) restart_.reset();
  if (!starts) return;
  settle_stop(frame.signal.goals);
  start(frame.signal.goals);
}

void RecordedPlay::process_alone(const JudgedFrame& frame, const std::vector<sim::Touch>& touches) {
  const bool is_out = referee::is_out_of_field(field_, world_.ball.position_m);
  if (!is_on_ && !is_out && frame.is_play_on) start({});
  if (is_on_) update(touches, {}, true);
  for (const referee::Decision& decision : frame.decisions) {
    const std::optional<Command> restart = decision.restart();
    if (is_on_ && !restart) update({}, {decision}, true);
    if (!is_on_ || !restart) continue;
    PerSide<int> goals = goals_;
    if (decision.finding.event == referee::Event::kGoal) ++goals[opponent_of(restart->side)];
    stop(decision.finding);
    settle_stop(goals);
    restart_ = restart;
  }
}

void RecordedPlay::start(const PerSide<int>& goals) {
  goals_ = goals;
  is_on_ = true;
  call_.reset();
  is_dead_ = false;
  referee::Decision decision =
      decision_in(world_.frame, referee::State::kWaitStop, referee::State::kRun);
  decision.finding = unknown_reason();
  decision.command = restart_;
  restart_.reset();
  std::vector<referee::Decision> decisions = std::exchange(calls_in_stop_, {});
  decisions.push_back(decision);
  update({}, decisions, true);
}

void RecordedPlay::stop(const referee::Finding& reason) {
  is_on_ = false;
  stop_ = Stop{world_, is_turned_, reason};
}

void RecordedPlay::settle_stop(const PerSide<int>& goals) {
  if (!stop_) return;
  referee::Decision decision =
      decision_in(stop_->world.frame, referee::State::kRun, referee::State::kWaitStop);
  decision.finding = stop_->reason;
  decision.command = Command{CommandKind::kStop, Side::kWest};
  if (const std::optional<Side> side = scorer(goals_, goals)) {
    decision.finding.event = referee::Event::kGoal;
    decision.finding.restart = {CommandKind::kPrepareKickoff, opponent_of(*side)};
    decision.command = Command{CommandKind::kGoal, *side};
  } else if (decision.finding.event == referee::Event::kGoal) {
    decision.finding = unknown_reason();
  }
  std::swap(world_, stop_->world);
  std::swap(is_turned_, stop_->is_turned);
  update({}, {decision}, false);
  std::swap(world_, stop_->world);
  std::swap(is_turned_, stop_->is_turned);
  stop_.reset();
}

void RecordedPlay::update(const std::vector<sim::Touch>& touches,
                          const std::vector<referee::Decision>& decisions, bool is_play_on) {
  const bool counts_time = is_play_on && is_in_play_ && decisions.empty();
  frames_in_play_ += counts_time ? 1 : 0;
  statistics_.update({world_, touches, decisions, is_play_on, counts_time});
  for (const game::PossessionChain& chain : statistics_.ended_chains())
    if (play_.chains.size() < kMostKept) play_.chains.push_back(chain);
  for (const game::Shot& shot : statistics_.ended_shots())
    if (play_.shots.size() < kMostKept) play_.shots.push_back({shot, !is_turned_});
  for (const game::BallAction& action : statistics_.ended_actions())
    if (play_.actions.size() < kMostKept) play_.actions.push_back({action, !is_turned_});
}

}  // namespace autoref::logs
