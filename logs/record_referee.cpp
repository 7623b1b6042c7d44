#include "logs/record_referee.hpp"

#include <utility>

#include "league/referee_message.hpp"
#include "soccer/published.hpp"

namespace autoref::logs {
namespace {

constexpr std::size_t kMostWaitingSignals = 4096;  // more than a minute without a frame
constexpr double kSameTime_s = 1e-6;               // times in logs are rounded

}  // namespace

RecordReferee::RecordReferee(std::vector<referee::Configuration> configurations,
                             const RecordedTeams& teams, SignalOrder order, DecisionWatch watch)
    : configurations_(std::move(configurations)),
      actual_keepers_(teams.actual_keepers),
      order_(order),
      watch_(std::move(watch)),
      ends_(teams.yellow_end.value_or(Side::kWest), configurations_.front().rules.change_ends,
            teams.turned),
      referee_(configurations_.front()) {
  for (const Side side : kSides) requests_[side].keeper = actual_keepers_[side].value_or(0);
  say_ends();
}

void RecordReferee::on_frame(const Frame& frame) {
  if (!referee_.is_over()) judge(frame);
  // A referee packet comes before the frame it belongs to, so this frame was still part of the
  // previous game.
  if (is_next_game_) {
    referee_ = referee::AutoRef(configurations_[++game_]);
    say_ends();
  }
  is_next_game_ = false;
}

void RecordReferee::on_referee(double time_s, const league::RefereePacket& packet) {
  std::optional<RefereeSignal> signal = league::signal_of(packet);
  if (!signal) return;
  ends_.take(packet, signal->stage);
  signal->blue_on_positive_half = !is_turned();
  if (next_game_.begins_with(signal->stage)) is_next_game_ = game_ + 1 < configurations_.size();
  if (signals_.size() == kMostWaitingSignals) signals_.pop_front();
  const double given_s = order_ == SignalOrder::kByTime ? time_s : judged_s_;
  signal->command_time_s = given_s - league::command_age_s(packet).value_or(0);
  note_keepers(*signal);
  signals_.push_back({given_s, published(*signal)});
}

void RecordReferee::note_keepers(const RefereeSignal& signal) {
  for (const Side side : kSides) {
    const std::optional<int> keeper =
        actual_keepers_[side] ? actual_keepers_[side] : signal.keepers[side];
    requests_[side].keeper = keeper.value_or(requests_[side].keeper);
  }
}

// Decisions have the coordinates of the field, even if nobody commands.
void RecordReferee::say_ends() {
  if (configuration().control == referee::Control::kHuman) return;
  RefereeSignal ends;
  ends.blue_on_positive_half = !is_turned();
  referee_.follow(ends);
}

void RecordReferee::judge(const Frame& frame) {
  judged_s_ = frame.time_s;
  const RefereeSignal own = referee_.update(published(frame, !is_turned()), requests_);
  if (configuration().control == referee::Control::kAutoref) signal_ = own;
  while (!signals_.empty() && signals_.front().time_s <= frame.time_s + kSameTime_s) {
    if (configuration().control != referee::Control::kAutoref) signal_ = signals_.front().signal;
    referee_.follow(signals_.front().signal);
    signals_.pop_front();
  }
  for (const referee::Decision& decision : referee_.decisions()) watch_(decision);
}

}  // namespace autoref::logs
