#include "live/referee/live_judge.hpp"

#include <variant>

#include "game/loop/game_event.hpp"
#include "soccer/published.hpp"

namespace autoref::live {
namespace {

constexpr std::chrono::milliseconds kIdleEvery{50};

}  // namespace

LiveJudge::LiveJudge(const referee::Configuration& configuration, const logs::RecordedFacts& facts,
                     bool frames_are_tracked, const LiveRefereeWatch& watch,
                     RefereeOutputs& outputs)
    : watch_(watch),
      outputs_(outputs),
      referee_({configuration}, facts.teams, logs::SignalOrder::kByArrival,
               [this](const referee::Decision& decision) { report(decision); }),
      both_(referee_, *this),
      reader_(both_, frames_are_tracked) {
  status_.names = facts.names;
}

void LiveJudge::take(const LiveMessage& live) {
  const league::Taken taken = reader_.take(live.message, live.time_s, live.host);
  if (std::holds_alternative<league::RefereePacket>(live.message.packet) &&
      taken == league::Taken::kUsed)
    outputs_.note_referee(live.host);
}

void LiveJudge::idle() {
  const auto now = Clock::now();
  outputs_.send_signal(referee_.signal(), frame_time_s(now));
  if (now < idle_due_) return;
  idle_due_ = now + kIdleEvery;
  status_.signal = referee_.signal();
  status_.vision = quality_.report();
  status_.faults = reader_.faults();
  status_.controller = outputs_.controller_status();
  if (watch_.on_idle) watch_.on_idle(status_);
}

void LiveJudge::on_frame(const Frame& frame) {
  quality_.take(frame);
  status_.time_s = frame.time_s;
  ++status_.frames;
  judged_ = Clock::now();
  outputs_.set_start(reader_.merger().clocks().start_capture_s());
  const Tracks& tracks = referee_.referee().tracks();
  outputs_.send_tracks(tracks, referee_.is_turned());
  outputs_.send_signal(referee_.signal(), frame.time_s);
  if (referee_.configuration().control == referee::Control::kHuman) {
    if (const auto placed = placement_.update(referee_.signal(), tracks)) report(*placed);
  }
  if (watch_.on_frame) watch_.on_frame(frame, published(referee_.signal()));
}

void LiveJudge::on_vision(double time_s, const league::VisionPacket& packet) {
  quality_.take(time_s, packet);
}

void LiveJudge::on_referee(double /*time_s*/, const league::RefereePacket& packet) {
  status_.has_referee = true;
  status_.names = {{packet.yellow().name(), packet.blue().name()}};
}

void LiveJudge::report(const referee::Decision& decision) {
  const std::optional<GameEvent> event =
      game::game_event_of(decision, reader_.merger().clocks().start_capture_s().value_or(0));
  outputs_.note(decision);
  if (watch_.on_decision) watch_.on_decision(decision);
  if (event) report(*event);
}

void LiveJudge::report(const GameEvent& event) {
  outputs_.report(event);
  if (watch_.on_game_event) watch_.on_game_event(event);
}

// The time on the frames' clock, also while no frames arrive.
double LiveJudge::frame_time_s(Clock::time_point now) const {
  return status_.time_s + std::chrono::duration<double>(now - judged_).count();
}

}  // namespace autoref::live
