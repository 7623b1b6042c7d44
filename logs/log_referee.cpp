#include "logs/log_referee.hpp"

#include <optional>
#include <utility>

#include "game/loop/event_log.hpp"
#include "game/loop/game_event_fields.hpp"
#include "league/referee_message.hpp"
#include "logs/log_game.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::logs {
namespace {

constexpr std::size_t kMostWaitingSignals = 4096;  // more than a minute without a frame
constexpr double kSameTime_s = 1e-6;               // times in logs are rounded

Call call_of(const referee::Decision& decision) {
  const std::optional<GameEvent> event = game::game_event_of(decision);
  return {decision.time_s, decision.time_s, decision.finding.restart,
          name_of(decision.finding.event), event ? event->by_team : decision.finding.offender};
}

// AutoRef's own calls when a human referee is in command: each lasts from its STOP until play
// continues.
class OwnCalls {
 public:
  void add(const referee::Decision& decision) {
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

// Collects AutoRef's decisions in a log.
class DecisionCollector {
 public:
  DecisionCollector(const RecordedFacts& facts, const RuleBook& rules, const DecisionWatch& watch)
      : watch_(watch),
        log_(event_game_of(facts.names, rules)),
        game_events_(1e-9 * static_cast<double>(facts.log.first_ns)) {}

  void add(const referee::Decision& decision) {
    ++decisions_;
    if (watch_) watch_(decision);
    log_.on_decision(decision);
    game_events_.on_decision(decision);
    own_calls_.add(decision);
    if (is_call(decision.finding.event)) all_calls_.push_back(call_of(decision));
    if (decision.command) calls_.add(decision.time_s, *decision.command);
  }

  std::vector<Call> calls(bool is_beside_person) const {
    return is_beside_person ? own_calls_.calls() : calls_.calls();
  }

  LogRefereeResult result() const {
    LogRefereeResult result;
    result.calls = all_calls_;
    result.game_events = game_events_.events();
    result.events = log_.text();
    result.decisions = decisions_;
    return result;
  }

 private:
  const DecisionWatch& watch_;
  game::EventLog log_;
  game::GameEventLog game_events_;
  CallMaker calls_;
  OwnCalls own_calls_;
  std::vector<Call> all_calls_;
  int decisions_ = 0;
};

// A STOP before a half, such as before the first kick-off, is not a call that another referee could
// make.
bool may_be_call(const RecordedCommand& recorded) {
  const bool is_between_halves =
      recorded.stage == Stage::kFirstHalfPre || recorded.stage == Stage::kHalfTime ||
      recorded.stage == Stage::kSecondHalfPre || recorded.stage == Stage::kExtraTimeBreak ||
      recorded.stage == Stage::kExtraFirstHalfPre || recorded.stage == Stage::kExtraHalfTime ||
      recorded.stage == Stage::kExtraSecondHalfPre || recorded.stage == Stage::kShootoutBreak;
  return recorded.command.kind != CommandKind::kStop || !is_between_halves;
}

}  // namespace

LogReferee::LogReferee(std::vector<referee::Configuration> configurations,
                       const RecordedTeams& teams, SignalOrder order, DecisionWatch watch)
    : configurations_(std::move(configurations)),
      actual_keepers_(teams.actual_keepers),
      order_(order),
      watch_(std::move(watch)),
      ends_(teams.yellow_end.value_or(Side::kWest), configurations_.front().rules.change_ends,
            teams.turned),
      referee_(configurations_.front()) {
  for (const Side side : kSides) requests_[side].keeper = actual_keepers_[side].value_or(0);
  set_ends();
}

void LogReferee::on_frame(const Frame& frame) {
  if (!referee_.is_over()) judge(frame);
  // A referee packet precedes the frame it belongs to, so this frame was still part of the previous
  // game.
  if (is_next_game_) {
    referee_ = referee::AutoRef(configurations_[++game_]);
    set_ends();
  }
  is_next_game_ = false;
}

void LogReferee::on_referee(double time_s, const league::RefereePacket& packet) {
  std::optional<RefereeSignal> signal = league::signal_of(packet);
  if (!signal) return;
  ends_.add(packet, signal->stage);
  signal->blue_on_positive_half = !is_turned();
  if (next_game_.begins_with(signal->stage)) is_next_game_ = game_ + 1 < configurations_.size();
  if (signals_.size() == kMostWaitingSignals) signals_.pop_front();
  const double given_s = order_ == SignalOrder::kByTime ? time_s : judged_s_;
  signal->command_time_s = given_s - league::command_age_s(packet).value_or(0);
  note_keepers(*signal);
  signals_.push_back({given_s, published(*signal)});
}

void LogReferee::note_keepers(const RefereeSignal& signal) {
  for (const Side side : kSides) {
    const std::optional<int> keeper =
        actual_keepers_[side] ? actual_keepers_[side] : signal.keepers[side];
    requests_[side].keeper = keeper.value_or(requests_[side].keeper);
  }
}

// Decisions use the field's coordinates, even if nobody is in command.
void LogReferee::set_ends() {
  if (configuration().control == referee::Control::kHuman) return;
  RefereeSignal ends;
  ends.blue_on_positive_half = !is_turned();
  referee_.follow(ends);
}

void LogReferee::judge(const Frame& frame) {
  judged_s_ = frame.time_s;
  const RefereeSignal own = referee_.update(published(frame, !is_turned()), requests_);
  if (configuration().control == referee::Control::kAutoref) signal_ = own;
  while (!signals_.empty() && signals_.front().time_s <= frame.time_s + kSameTime_s) {
    if (configuration().control != referee::Control::kAutoref) signal_ = signals_.front().signal;
    referee_.follow(signals_.front().signal);
    signals_.pop_front();
  }
  for (const referee::Decision& decision : referee_.decisions()) watch_(decision);
  if (watch_frame_) watch_frame_(*this);
}

LogRefereeResult referee_log(const std::filesystem::path& log, const RecordedFacts& facts,
                             const std::vector<referee::Configuration>& configurations,
                             const DecisionWatch& watch, const FrameWatch& frame_watch) {
  DecisionCollector collector(facts, configurations.front().rules, watch);
  LogReferee log_referee(configurations, facts.teams, SignalOrder::kByTime,
                         [&](const referee::Decision& decision) { collector.add(decision); });
  RecordedPlay play(configurations.front());
  log_referee.watch_frames([&](const LogReferee& judged) {
    play.add(judged);
    if (frame_watch) frame_watch(judged);
  });
  league::read_log(log, log_referee, facts.log.source);
  const bool is_alone = configurations.front().control == referee::Control::kAutoref;
  CallMaker recorded;
  for (const RecordedCommand& command : facts.commands) {
    if (is_alone || may_be_call(command)) recorded.add(command.time_s, command.command);
  }
  LogRefereeResult result = collector.result();
  result.play = play.finish();
  const bool is_beside_person = log_referee.configuration().control != referee::Control::kAutoref;
  result.agreement = agreement_of(recorded.calls(), collector.calls(is_beside_person));
  result.control = configurations.front().control;
  for (const PerSide<int>& half : log_referee.referee().goals_by_half()) {
    for (const Side side : kSides) result.goals[side] += half[side];
  }
  return result;
}

}  // namespace autoref::logs
