#include "live/controller/controller_differences.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "league/game_event_message.hpp"
#include "live/controller/followed_signal.hpp"
#include "logs/game_event_comparison.hpp"

namespace autoref::live {
namespace {

constexpr double kSamePosition_m = 0.1;  // tolerance: the referees round positions differently
constexpr double kSlowest_s = 3;         // longest time from AutoRef's event to the controller's

bool is_restart_command(CommandKind kind) {
  return kind == CommandKind::kForceStart || kind == CommandKind::kDirectFree ||
         kind == CommandKind::kIndirectFree || kind == CommandKind::kPrepareKickoff ||
         kind == CommandKind::kPreparePenalty;
}

bool is_play_stopped(CommandKind kind) {
  return kind == CommandKind::kStop || kind == CommandKind::kHalt;
}

bool is_regular_half(Stage stage) {
  return stage == Stage::kFirstHalf || stage == Stage::kSecondHalf;
}

}  // namespace

void ControllerDifferences::on_decision(const referee::Decision& decision) {
  own_.on_decision(decision);
  const std::optional<Command> restart = decision.restart();
  if (!restart) return;
  call_ = OwnCall{decision.time_s, std::string(name_of(decision.finding.event)), *restart,
                  decision.finding.ball_to_m};
}

void ControllerDifferences::add(const league::RefereePacket& packet, const RefereeSignal& signal,
                                double time_s) {
  std::vector<std::string> events(packet.game_events().begin(), packet.game_events().end());
  for (const std::string& bytes : events) {
    if (std::find(listed_.begin(), listed_.end(), bytes) != listed_.end()) continue;
    league::GameEventMessage message;
    if (!message.ParseFromString(bytes)) continue;
    counted_.push_back({time_s, league::game_event_of(message)});
    reason_ = name_of(counted_.back().event.type);
  }
  listed_ = std::move(events);
  if (command_counter_ != signal.command_counter) compare(signal, time_s);
  command_counter_ = signal.command_counter;
  if (signal.placement) position_m_ = signal.placement->target_m;
}

void ControllerDifferences::compare(const RefereeSignal& signal, double time_s) {
  const CommandKind kind = signal.command.kind;
  if (!is_regular_half(signal.stage)) {
    stopped_s_.reset();
    call_.reset();
  } else if (is_play_stopped(kind)) {
    if (has_played_ && !stopped_s_) stopped_s_ = time_s;
  } else if (stopped_s_ && is_restart_command(kind)) {
    compare_restart(signal.command, *stopped_s_);
    stopped_s_.reset();
    call_.reset();
  }
  has_played_ = has_played_ || !is_before_restart(kind);
}

void ControllerDifferences::compare_restart(Command restart, double stopped_s) {
  ++restarts_;
  if (!call_) {
    note(stopped_s, fmt::format("{} after {}, which AutoRef did not call", name_of(restart),
                                reason_.empty() ? "no event" : reason_));
  } else if (call_->restart != restart) {
    note(call_->time_s, fmt::format("{} after {}; AutoRef: {}", name_of(restart), call_->event,
                                    name_of(call_->restart)));
  } else if (position_m_ && (*position_m_ - call_->ball_to_m).norm() > kSamePosition_m) {
    note(call_->time_s,
         fmt::format("{} after {} at ({:.2f}, {:.2f}) m; AutoRef: at ({:.2f}, {:.2f}) m",
                     name_of(restart), call_->event, position_m_->x(), position_m_->y(),
                     call_->ball_to_m.x(), call_->ball_to_m.y()));
  }
}

void ControllerDifferences::note(double time_s, std::string text) {
  differences_.push_back({time_s, std::move(text)});
}

std::string ControllerDifferences::text() const {
  std::string text =
      fmt::format("{} restarts by the game controller, {} of them differ from AutoRef's\n",
                  restarts_, differences_.size());
  for (const ControllerDifference& difference : differences_)
    text += fmt::format("  {:8.2f} s  {}\n", difference.time_s, difference.text);
  return text + logs::game_events_text(
                    logs::compared(counted_, own_.events(), referee::Control::kHuman, kSlowest_s),
                    "controller");
}

}  // namespace autoref::live
