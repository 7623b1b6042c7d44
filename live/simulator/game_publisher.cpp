#include "live/simulator/game_publisher.hpp"

#include "game/loop/game_configuration.hpp"
#include "game/loop/game_event_fields.hpp"
#include "live/published_tracks.hpp"
#include "soccer/random.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::live {
namespace {

constexpr double kRefereeEvery_s = 0.025;

Address destination(const LiveOptions& options, const char* group, int port) {
  return {options.unicast.empty() ? group : options.unicast, port};
}

PerSide<league::LoggedTeam> published_teams(const game::GameConfiguration& game) {
  const PerSide<std::string> names = game::shown_names(game);
  return {{league::LoggedTeam{names[Side::kWest]}, league::LoggedTeam{names[Side::kEast]}}};
}

// A random UUID, unless the game's packets must be the same each time.
std::string tracker_uuid(bool is_repeatable) {
  return is_repeatable ? "00000000-0000-4000-8000-000000000000" : random_uuid();
}

league::BallModel ball_model_of(const sim::BallParameters& ball) {
  return {ball.slide_mps2,   ball.roll_mps2,    ball.switch_ratio,
          ball.hop_first_xy, ball.hop_later_xy, ball.hop_first_z};
}

}  // namespace

GamePublisher::GamePublisher(const game::GameConfiguration& game, const LiveOptions& options,
                             double start_unix_s)
    : options_(options),
      sends_signal_(game.match.control == referee::Control::kAutoref),
      start_unix_s_(start_unix_s),
      rate_hz_(game.sim.frame_rate_hz),
      latency_frames_(sim::split_latency(game.sim).frames),
      packets_(game.field, game::logged_cameras(game), published_teams(game),
               {1.0, kRefereeEvery_s, start_unix_s}),
      source_{tracker_uuid(options.speed.pace == Pace::kLockStep), kIdentifier,
              game.sim.vision.reports_height},
      vision_(options.interface, destination(options, kVisionGroup, options.ports.vision)),
      referee_(options.interface, destination(options, kRefereeGroup, options.ports.referee)),
      tracker_(options.interface, destination(options, kVisionGroup, options.ports.tracker)),
      frames_(latency_frames_),
      waiting_camera_(game.sim.vision, game.field, rate_hz_, mix_bits(game.seed)) {
  packets_.describe(ball_model_of(game.sim.ball));
}

void GamePublisher::on_frame(const Frame& frame, const RefereeSignal& signal,
                             const sim::World& /*world*/) {
  has_newest_ = true;
  newest_.frame = frame;
  newest_.signal = signal;
}

void GamePublisher::on_decision(const referee::Decision& decision) {
  if (decision.command) newest_.commands.push_back(*decision.command);
  if (std::optional<GameEvent> event = game::game_event_of(decision, start_unix_s()))
    newest_.events.push_back(*std::move(event));
}

void GamePublisher::publish(const Tracks& tracks) {
  detections_.clear();
  if (!has_newest_) return;
  has_newest_ = false;
  newest_.tracks = tracks;
  frames_.push(newest_);
  const bool is_due = newest_.frame.number >= latency_frames_;
  newest_ = {};
  if (is_due) send(frames_.oldest());
}

void GamePublisher::send(const PublishedFrame& due) {
  standing_geometry_.clear();
  Frame frame = due.frame;
  frame.number += waited_frames_;
  frame.time_s += waited_s();
  next_number_ = frame.number + 1;
  const bool blue_on_positive_half = due.signal.blue_on_positive_half;
  packets_.add_vision(frame, due.others, blue_on_positive_half, *this);
  for (const Command command : due.commands) packets_.note(command);
  for (const GameEvent& event : due.events) packets_.note(event);
  send_referee(due.signal, frame.time_s);
  league::fill_tracker(blue_on_positive_half ? due.tracks : turned(due.tracks), source_,
                       start_unix_s_ + frame.time_s, tracker_packet_);
  send(tracker_packet_, tracker_);
}

void GamePublisher::send_referee(RefereeSignal signal, double time_s) {
  if (signal.command_counter != command_counter_) command_waited_s_ = waited_s();
  command_counter_ = signal.command_counter;
  signal.command_time_s += command_waited_s_;
  packets_.add_referee(signal, time_s, *this);
}

void GamePublisher::add_waiting_frame(const sim::WorldState& world, const RefereeSignal& signal) {
  Frame frame;
  waiting_camera_.look(world, frame);
  frame.number = next_number_++;
  frame.time_s = static_cast<double>(frame.number) / rate_hz_;
  detections_.clear();
  packets_.add_vision(frame, {}, signal.blue_on_positive_half, *this);
  send_referee(signal, frame.time_s);
  ++waited_frames_;
}

void GamePublisher::send_standing_field(const RefereeSignal& signal) {
  packets_.geometry().SerializeToString(&standing_geometry_);
  send_referee(signal, 0);
  standing_signal_ = bytes_;
  vision_.send(standing_geometry_);
}

void GamePublisher::repeat_standing_field() {
  if (standing_geometry_.empty()) return;
  vision_.send(standing_geometry_);
  referee_.send(standing_signal_);
}

double GamePublisher::waited_s() const { return static_cast<double>(waited_frames_) / rate_hz_; }

void GamePublisher::set_vision_port(int port) {
  options_.ports.vision = port;
  vision_ = DatagramSender(options_.interface, destination(options_, kVisionGroup, port));
}

std::int64_t GamePublisher::dropped() const {
  return vision_.dropped() + referee_.dropped() + tracker_.dropped();
}

void GamePublisher::on_vision(double time_s, const league::VisionPacket& packet) {
  sent_ = packet;
  if (sent_.has_detection()) {
    sent_.mutable_detection()->set_t_sent(start_unix_s_ + time_s + latency_frames_ / rate_hz_);
    detections_.push_back(sent_.detection().SerializeAsString());
  }
  send(sent_, vision_);
}

void GamePublisher::on_referee(double /*time_s*/, const league::RefereePacket& packet) {
  if (sends_signal_) send(packet, referee_);
}

template <typename Message>
void GamePublisher::send(const Message& message, DatagramSender& sender) {
  message.SerializeToString(&bytes_);
  sender.send(bytes_);
}

}  // namespace autoref::live
