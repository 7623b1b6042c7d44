#include "runner/logs/log_referee.hpp"

#include <utility>

#include "league/referee_message.hpp"
#include "runner/game/event_log.hpp"

namespace autoref::runner {
namespace {

// The frame rotated by half a turn: same robots and colours, other end of the field.
Frame turned(const Frame& frame) {
  Frame other = mirrored(frame);
  std::swap(other.robots[Side::kWest], other.robots[Side::kEast]);
  return other;
}

class LogReferee final : public league::LogVisitor {
 public:
  LogReferee(const std::vector<referee::Configuration>& configurations,
             const PerSide<std::string>& names)
      : configurations_(configurations),
        referee_(configurations.front()),
        log_(PerSide<EventTeam>{
            {EventTeam{"", names[Side::kWest]}, EventTeam{"", names[Side::kEast]}}}) {}

  void on_frame(const Frame& frame) override {
    if (!referee_.is_over()) take(frame);
    // The log holds a referee packet before the frame it belongs to, so this frame was still part
    // of the previous game.
    if (is_next_game_) referee_ = referee::Referee(configurations_[++game_]);
    is_next_game_ = false;
  }

  void on_referee(double /*time_s*/, const league::RefereePacket& packet) override {
    const std::optional<RefereeSignal> signal = league::signal_of(packet);
    if (signal && next_game_.begins_with(signal->stage))
      is_next_game_ = game_ + 1 < configurations_.size();
    if (packet.has_blue_team_on_positive_half()) is_turned_ = !packet.blue_team_on_positive_half();
  }

  LogRefereeResult evaluation(const Agreement& agreement) const {
    LogRefereeResult evaluation{agreement, {}, log_.text(), decisions_};
    for (const PerSide<int>& half : referee_.goals_by_half()) {
      for (const Side side : kSides) evaluation.goals[side] += half[side];
    }
    return evaluation;
  }

  const std::vector<Call>& calls() const { return calls_.calls(); }

 private:
  void take(const Frame& frame) {
    referee_.update(is_turned_ ? turned(frame) : frame, {});
    for (const referee::Decision& decision : referee_.decisions()) {
      ++decisions_;
      log_.on_decision(decision);
      if (decision.command) calls_.take(decision.time_s, *decision.command);
    }
  }

  const std::vector<referee::Configuration>& configurations_;
  std::size_t game_ = 0;
  NextGame next_game_;
  bool is_next_game_ = false;
  referee::Referee referee_;
  EventLog log_;
  CallMaker calls_;
  bool is_turned_ = false;
  int decisions_ = 0;
};

}  // namespace

LogRefereeResult referee_log(const std::filesystem::path& log, const RecordedFacts& facts,
                             const std::vector<referee::Configuration>& configurations) {
  LogReferee judge(configurations, facts.names);
  league::read_log(log, judge);
  CallMaker recorded;
  for (const RecordedCommand& command : facts.commands)
    recorded.take(command.time_s, command.command);
  return judge.evaluation(agreement_of(recorded.calls(), judge.calls()));
}

}  // namespace autoref::runner
