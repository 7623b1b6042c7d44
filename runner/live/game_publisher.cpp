#include "runner/live/game_publisher.hpp"

#include <fmt/format.h>

#include <random>

#include "runner/game/game_event.hpp"
#include "runner/logs/logged_cameras.hpp"
#include "soccer/published.hpp"

namespace autoref::runner {
namespace {

constexpr double kRefereeEvery_s = 0.025;

Address destination(const LiveOptions& options, const char* group, int port) {
  return {options.unicast.empty() ? group : options.unicast, port};
}

PerSide<league::LoggedTeam> published_teams(const GameConfiguration& game) {
  const PerSide<std::string> names = shown_names(game);
  return {{league::LoggedTeam{names[Side::kWest]}, league::LoggedTeam{names[Side::kEast]}}};
}

// Random, unless the game's packets are to be the same each time.
std::string tracker_uuid(bool is_repeatable) {
  if (is_repeatable) return "00000000-0000-4000-8000-000000000000";
  std::random_device random;
  return fmt::format("{:08x}-{:04x}-4{:03x}-8{:03x}-{:08x}{:04x}", random(), random() & 0xffffU,
                     random() & 0xfffU, random() & 0xfffU, random(), random() & 0xffffU);
}

Frame true_frame(const sim::WorldState& world) {
  Frame frame;
  for (const Side side : kSides) {
    for (const sim::RobotState& robot : world.robots[side])
      frame.robots[side].push_back({robot.number, robot.position_m, robot.heading});
  }
  frame.ball = BallObservation{world.ball.position_m, world.ball.height_m};
  return frame;
}

Tracks turned(Tracks tracks) {
  for (const Side side : kSides) {
    for (TrackedRobot& robot : tracks.robots[side]) robot = mirrored(robot);
  }
  if (tracks.ball) *tracks.ball = mirrored(*tracks.ball);
  return tracks;
}

}  // namespace

GamePublisher::GamePublisher(const GameConfiguration& game, const LiveOptions& options,
                             double start_unix_s)
    : options_(options),
      start_unix_s_(start_unix_s),
      rate_hz_(game.sim.frame_rate_hz),
      latency_frames_(sim::split_latency(game.sim).frames),
      packets_(game.field, logged_cameras(game), published_teams(game),
               {1.0, kRefereeEvery_s, start_unix_s}),
      source_{tracker_uuid(options.speed.is_lockstep), "AutoRef"},
      vision_(options.interface, destination(options, kVisionGroup, options.ports.vision)),
      referee_(options.interface, destination(options, kRefereeGroup, options.ports.referee)),
      tracker_(options.interface, destination(options, kVisionGroup, options.ports.tracker)),
      sights_(latency_frames_) {}

void GamePublisher::on_frame(const Frame& frame, const RefereeSignal& signal,
                             const sim::World& /*world*/) {
  sights_.push({frame, others_, signal.blue_on_positive_half});
  if (!others_.is_empty()) others_ = {};
  now_s_ = frame.time_s + waited_s();
  next_frame_ = frame.number + 1;
  detections_.clear();
  if (frame.number >= latency_frames_) {
    Sight seen = sights_.oldest();
    seen.frame.number += waited_frames_;
    seen.frame.time_s += waited_s();
    packets_.add_vision(seen.frame, seen.others, seen.blue_on_positive_half, *this);
  }
  RefereeSignal sent = signal;
  sent.command_time_s += waited_s();
  packets_.add_referee(sent, now_s_, *this);
}

void GamePublisher::add_waiting_frame(const sim::WorldState& world, const RefereeSignal& signal) {
  Frame frame = true_frame(world);
  frame.number = next_frame_ + waited_frames_;
  frame.time_s = now_s_ = static_cast<double>(frame.number) / rate_hz_;
  detections_.clear();
  packets_.add_vision(frame, {}, signal.blue_on_positive_half, *this);
  packets_.add_referee(signal, now_s_, *this);
  ++waited_frames_;
}

double GamePublisher::waited_s() const { return static_cast<double>(waited_frames_) / rate_hz_; }

void GamePublisher::on_decision(const referee::Decision& decision) {
  if (decision.command) packets_.note(*decision.command);
  if (std::optional<GameEvent> event = game_event_of(decision)) packets_.note(*std::move(event));
}

void GamePublisher::add(const Tracks& tracks, bool blue_on_positive_half) {
  league::fill_tracker(blue_on_positive_half ? tracks : turned(tracks), source_,
                       start_unix_s_ + waited_s() + tracks.time_s, tracker_packet_);
  send(tracker_packet_, tracker_);
}

void GamePublisher::set_vision_port(int port) {
  options_.ports.vision = port;
  vision_ = DatagramSender(options_.interface, destination(options_, kVisionGroup, port));
}

std::int64_t GamePublisher::dropped() const {
  return vision_.dropped() + referee_.dropped() + tracker_.dropped();
}

void GamePublisher::on_vision(double /*time_s*/, const league::VisionPacket& packet) {
  sent_ = packet;
  if (sent_.has_detection()) {
    sent_.mutable_detection()->set_t_sent(start_unix_s_ + now_s_);
    detections_.push_back(sent_.detection().SerializeAsString());
  }
  send(sent_, vision_);
}

void GamePublisher::on_referee(double /*time_s*/, const league::RefereePacket& packet) {
  send(packet, referee_);
}

template <typename Message>
void GamePublisher::send(const Message& message, DatagramSender& sender) {
  message.SerializeToString(&bytes_);
  sender.send(bytes_);
}

}  // namespace autoref::runner
