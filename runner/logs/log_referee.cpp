#include "runner/logs/log_referee.hpp"

#include <deque>
#include <optional>
#include <utility>

#include "league/referee_message.hpp"
#include "runner/game/event_log.hpp"
#include "runner/game/game_event.hpp"
#include "runner/logs/recorded_ends.hpp"
#include "soccer/published.hpp"

namespace autoref::runner {
namespace {

Call call_of(const referee::Decision& decision) {
  const std::optional<GameEvent> event = game_event_of(decision);
  return {decision.time_s, decision.time_s, decision.finding.restart,
          name_of(decision.finding.event), event ? event->by_team : decision.finding.offender};
}

// AutoRef's own calls beside a person: each lasts from its STOP until play goes on.
class OwnCalls {
 public:
  void take(const referee::Decision& decision) {
    const bool stops = decision.to == referee::State::kCalled;
    if (stops) open_ = call_of(decision);
    if (open_) open_->restart_s = decision.time_s;
    if (!open_ || stops || decision.to != referee::State::kRun) return;
    calls_.push_back(*open_);
    open_.reset();
  }

  std::vector<Call> calls() const {
    std::vector<Call> all = calls_;
    if (open_) all.push_back(*open_);
    return all;
  }

 private:
  std::optional<Call> open_;
  std::vector<Call> calls_;
};

class LogReferee final : public league::LogVisitor {
 public:
  LogReferee(const std::vector<referee::Configuration>& configurations, const RecordedFacts& facts,
             const DecisionWatch& watch)
      : configurations_(configurations),
        actual_keepers_(facts.teams.actual_keepers),
        watch_(watch),
        ends_(facts.teams.yellow_end.value_or(Side::kWest),
              configurations.front().rules.change_ends),
        referee_(configurations.front()),
        log_(PerSide<EventTeam>{
            {EventTeam{"", facts.names[Side::kWest]}, EventTeam{"", facts.names[Side::kEast]}}}),
        game_events_(1e-9 * static_cast<double>(facts.log.first_ns)) {
    for (const Side side : kSides) requests_[side].keeper = actual_keepers_[side].value_or(0);
    say_ends();
  }

  void on_frame(const Frame& frame) override {
    if (!referee_.is_over()) take(frame);
    // The log holds a referee packet before the frame it belongs to, so this frame was still part
    // of the previous game.
    if (is_next_game_) {
      referee_ = referee::Referee(configurations_[++game_]);
      say_ends();
    }
    is_next_game_ = false;
  }

  void on_referee(double time_s, const league::RefereePacket& packet) override {
    std::optional<RefereeSignal> signal = league::signal_of(packet);
    if (!signal) return;
    ends_.take(packet, signal->stage);
    signal->blue_on_positive_half = !is_turned();
    if (next_game_.begins_with(signal->stage)) is_next_game_ = game_ + 1 < configurations_.size();
    if (signals_.size() == kMostWaiting) signals_.pop_front();
    signal->command_time_s = time_s - league::command_age_s(packet).value_or(0);
    for (const Side side : kSides) {
      const std::optional<int> keeper =
          actual_keepers_[side] ? actual_keepers_[side] : signal->keepers[side];
      requests_[side].keeper = keeper.value_or(requests_[side].keeper);
    }
    signals_.push_back({time_s, published(*signal)});
  }

  LogRefereeResult evaluation(const Agreement& agreement) const {
    LogRefereeResult evaluation{agreement,
                                all_calls_,
                                {},
                                game_events_.events(),
                                log_.text(),
                                decisions_,
                                configurations_.front().control};
    for (const PerSide<int>& half : referee_.goals_by_half()) {
      for (const Side side : kSides) evaluation.goals[side] += half[side];
    }
    return evaluation;
  }

  std::vector<Call> calls() const {
    return is_beside_person() ? own_calls_.calls() : calls_.calls();
  }

 private:
  struct TimedSignal {
    double time_s = 0;
    RefereeSignal signal;
  };

  // More than a minute of signals without a frame.
  static constexpr std::size_t kMostWaiting = 4096;

  bool is_beside_person() const {
    return configurations_[game_].control != referee::Control::kAutoref;
  }

  // Whether frames must be rotated for AutoRef, to which yellow is west.
  bool is_turned() const { return ends_.yellow() == Side::kEast; }

  // Decisions have the log's coordinates, even if nobody commands.
  void say_ends() {
    if (configurations_[game_].control == referee::Control::kHuman) return;
    RefereeSignal ends;
    ends.blue_on_positive_half = !is_turned();
    referee_.follow(ends);
  }

  void take(const Frame& frame) {
    referee_.update(published(frame, !is_turned()), requests_);
    while (!signals_.empty() && signals_.front().time_s <= frame.time_s + kSameTime_s) {
      referee_.follow(signals_.front().signal);
      signals_.pop_front();
    }
    for (const referee::Decision& decision : referee_.decisions()) {
      ++decisions_;
      if (watch_) watch_(decision);
      log_.on_decision(decision);
      game_events_.on_decision(decision);
      own_calls_.take(decision);
      if (is_call(decision.finding.event)) all_calls_.push_back(call_of(decision));
      if (decision.command) calls_.take(decision.time_s, *decision.command);
    }
  }

  static constexpr double kSameTime_s = 1e-6;  // times in logs are rounded

  const std::vector<referee::Configuration>& configurations_;
  PerSide<std::optional<int>> actual_keepers_;
  PerSide<TeamRequests> requests_;
  const DecisionWatch& watch_;
  std::size_t game_ = 0;
  NextGame next_game_;
  bool is_next_game_ = false;
  RecordedEnds ends_;
  referee::Referee referee_;
  std::deque<TimedSignal> signals_;  // given after the last frame judged
  EventLog log_;
  GameEventLog game_events_;
  CallMaker calls_;
  OwnCalls own_calls_;
  std::vector<Call> all_calls_;
  int decisions_ = 0;
};

// A STOP before a half, such as before the first kick-off, is no call that a referee beside the
// recorded one could make.
bool may_be_call(const RecordedCommand& recorded) {
  const bool is_between_halves =
      recorded.stage == Stage::kFirstHalfPre || recorded.stage == Stage::kHalfTime ||
      recorded.stage == Stage::kSecondHalfPre || recorded.stage == Stage::kExtraTimeBreak ||
      recorded.stage == Stage::kExtraFirstHalfPre || recorded.stage == Stage::kExtraHalfTime ||
      recorded.stage == Stage::kExtraSecondHalfPre || recorded.stage == Stage::kShootoutBreak;
  return recorded.command.kind != CommandKind::kStop || !is_between_halves;
}

}  // namespace

LogRefereeResult referee_log(const std::filesystem::path& log, const RecordedFacts& facts,
                             const std::vector<referee::Configuration>& configurations,
                             const DecisionWatch& watch) {
  LogReferee judge(configurations, facts, watch);
  league::read_log(log, judge, facts.log.source);
  const bool is_alone = configurations.front().control == referee::Control::kAutoref;
  CallMaker recorded;
  for (const RecordedCommand& command : facts.commands) {
    if (is_alone || may_be_call(command)) recorded.take(command.time_s, command.command);
  }
  return judge.evaluation(agreement_of(recorded.calls(), judge.calls()));
}

}  // namespace autoref::runner
