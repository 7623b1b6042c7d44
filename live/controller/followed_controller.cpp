#include "live/controller/followed_controller.hpp"

#include <fmt/format.h>

#include <utility>

#include "game/loop/game_event_fields.hpp"
#include "league/game_event_message.hpp"
#include "live/controller/stopped_ball.hpp"
#include "live/published_tracks.hpp"

namespace autoref::live {
namespace {

// Packets taken at a time, so that a flood does not stop the game. The controller sends 40 a second
// and one for each change.
constexpr int kMostPackets = 256;
constexpr std::chrono::seconds kLongestSilence{2};
constexpr std::chrono::seconds kCheckEvery{1};

std::string source_text(const LiveOptions& options) {
  return fmt::format("{}:{} on {} (--interface, --referee-port)", kRefereeGroup,
                     options.ports.referee, options.interface);
}

}  // namespace

FollowedController::FollowedController(const game::GameConfiguration& game,
                                       const LiveOptions& options)
    : game_(game),
      source_text_(source_text(options)),
      source_(options.interface, {{league::MessageKind::kReferee2013, kRefereeGroup,
                                   options.ports.referee, "--referee-port"}}),
      reader_(*this, false),
      reporter_(options.controller, random_uuid()),
      followed_(game) {}

void FollowedController::take_packets() {
  for (int i = 0; i < kMostPackets; ++i) {
    const std::optional<ReceivedRecord> record = source_.next(RecordSource::Clock::now());
    if (!record) return;
    if (!first_ns_) first_ns_ = record->arrived_ns;
    const league::ReadResult result = reader_.read(
        record->kind, record->bytes, record->arrived_after_s(*first_ns_), record->host);
    if (result == league::ReadResult::kUsed) reporter_.note_referee(record->host);
  }
}

void FollowedController::on_referee(double /*time_s*/, const league::RefereePacket& packet) {
  if (!followed_.take(packet, now_s_)) return;
  is_heard_ = true;
  heard_ = Clock::now();
  signals_.push_back(followed_.signal());
}

bool FollowedController::has_match() {
  take_packets();
  if (signals_.empty()) return false;
  signals_.erase(signals_.begin(), signals_.end() - 1);
  const RefereeSignal& signal = signals_.back();
  const bool is_before_first =
      signal.stage == Stage::kFirstHalfPre && signal.command.kind == CommandKind::kHalt;
  return signal.stage != Stage::kPostGame && !is_before_first;
}

void FollowedController::follow(game::Game& game) {
  has_begun_ = true;
  now_s_ = game.frame().time_s;
  take_packets();
  if (!signals_.empty()) differences_.add(followed_.packet(), followed_.signal(), now_s_);
  for (const RefereeSignal& signal : signals_) game.follow(signal);
  signals_.clear();
  update_placement(game.tracks());
  if (is_placed_by_hand_) game.follow(with_ball_placed_by_hand(followed_.signal()));
}

// A person who has begun to place the ball goes on until the command, the restart or the position
// changes.
void FollowedController::update_placement(const Tracks& tracks) {
  const RefereeSignal& signal = followed_.signal();
  const auto target_m = [](const RefereeSignal& one) {
    return one.placement ? std::optional(one.placement->target_m) : std::nullopt;
  };
  const bool is_same = stopped_ && stopped_->command_counter == signal.command_counter &&
                       stopped_->command == signal.command &&
                       stopped_->next_command == signal.next_command &&
                       target_m(*stopped_) == target_m(signal);
  is_placed_by_hand_ = (is_same && is_placed_by_hand_) || needs_placement_by_hand(tracks);
  if (!is_same) stopped_ = signal;
}

bool FollowedController::needs_placement_by_hand(const Tracks& tracks) const {
  const RefereeSignal& signal = followed_.signal();
  const CommandKind kind = signal.command.kind;
  if (kind != CommandKind::kStop && kind != CommandKind::kBallPlacement) return false;
  const StoppedBall ball(game_, league::game_events_of(followed_.packet()), signal, tracks);
  if (kind == CommandKind::kBallPlacement) return ball.is_out_of_reach();
  return !ball.is_ready() && ball.needs_placement_by_hand(now_s_ - signal.command_time_s);
}

void FollowedController::on_decision(const referee::Decision& decision) {
  decisions_.push_back(decision);
  differences_.on_decision(decision);
}

void FollowedController::report(const game::Game& game, double start_unix_s) {
  for (const referee::Decision& decision : decisions_) {
    if (std::optional<GameEvent> event = game::game_event_of(decision, start_unix_s))
      reporter_.report(*std::move(event));
  }
  decisions_.clear();
  if (std::optional<GameEvent> placed = placement_.update(game.signal(), game.tracks()))
    reporter_.report(*std::move(placed));
}

std::optional<std::string> FollowedController::take_notice() {
  const Clock::time_point now = Clock::now();
  if (now - checked_ < kCheckEvery) return std::nullopt;
  checked_ = now;
  std::string before = std::exchange(problem_, problem());
  return problem_.empty() || problem_ == before ? std::nullopt : std::optional(problem_);
}

std::string FollowedController::problem() const {
  if (!is_heard_) return "waiting for the game controller's packets at " + source_text_;
  if (Clock::now() - heard_ > kLongestSilence) {
    return fmt::format("no packets from the game controller at {}; its last command stays in force",
                       source_text_);
  }
  if (!has_begun_) {
    return followed_.signal().stage == Stage::kPostGame
               ? "the game controller's match is over; waiting for a new one"
               : "waiting for the game controller's first command after HALT";
  }
  const ControllerStatus status = reporter_.status();
  if (status.is_registered || status.problem.empty()) return {};
  return fmt::format("the game controller takes no events: {}", status.problem);
}

FollowedControllerReport FollowedController::summary() const {
  return {reporter_.status(), reader_.faults(), differences_.text()};
}

}  // namespace autoref::live
