// Fuzzes the reading of vision, referee and tracker packets and of game events with arbitrary
// content, and lets AutoRef referee the resulting frames. Game events must be written as they were
// read. The input is a sequence of packets: one byte for the kind, two for the length, the packet.
#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "league/detection_merger.hpp"
#include "league/game_event_message.hpp"
#include "league/referee_message.hpp"
#include "league/tracker_message.hpp"
#include "league/vision_message.hpp"
#include "referee/referee.hpp"

namespace {

using namespace autoref;

class Game {
 public:
  void add(int kind, const std::uint8_t* data, int size) {
    if (kind == 0) add_as<league::VisionPacket>(data, size);
    if (kind == 1) add_as<league::RefereePacket>(data, size);
    if (kind == 2) add_as<league::VisionPacket2010>(data, size);
    if (kind == 3) add_as<league::TrackerPacket>(data, size);
    if (kind == 4) add_as<league::GameEventMessage>(data, size);
  }
  void finish() { judge(merger_.finish()); }

 private:
  template <typename Packet>
  void add_as(const std::uint8_t* data, int size) {
    Packet packet;
    if (packet.ParsePartialFromArray(data, size) && packet.IsInitialized()) read(packet);
  }

  void read(const league::VisionPacket& packet) {
    judge(merger_.add(packet, received_s_ += 0.004));
  }
  void read(league::VisionPacket2010& packet) {
    league::VisionPacket converted;
    league::convert(packet, converted);
    read(converted);
  }
  void read(const league::RefereePacket& packet) {
    league::signal_of(packet);
    league::command_age_s(packet);
    league::game_events_of(packet);
  }
  void read(const league::TrackerPacket& packet) {
    if (follower_.add(packet, received_s_ += 0.01) && !merger_.field()) judge(&follower_.frame());
  }
  static void read(const league::GameEventMessage& message) {
    const GameEvent event = league::game_event_of(message);
    if (message.event_case() == league::GameEventMessage::EVENT_NOT_SET) return;
    league::GameEventMessage again;
    league::fill_game_event(event, again);
    if (!again.IsInitialized() || !(league::game_event_of(again) == event)) std::abort();
  }

  void judge(const Frame* frame) {
    if (frame == nullptr) return;
    if (!referee_) {
      referee::Configuration configuration;
      if (merger_.field()) configuration.field = *merger_.field();
      referee_.emplace(configuration);
    }
    referee_->update(*frame, {});
  }

  league::DetectionMerger merger_;
  league::TrackFollower follower_;
  double received_s_ = 0;
  std::optional<referee::AutoRef> referee_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kHead = 3;
  Game game;
  while (size >= kHead) {
    const std::size_t length = std::min<std::size_t>(data[1] * 256U + data[2], size - kHead);
    game.add(data[0] % 5, data + kHead, static_cast<int>(length));
    data += kHead + length;
    size -= kHead + length;
  }
  game.finish();
  return 0;
}
