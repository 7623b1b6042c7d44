// Fuzzes the reading of vision and referee packets with arbitrary content, and lets AutoRef referee
// the resulting frames. The input is a sequence of packets: one byte for the kind, two for the
// length, the packet.
#include <algorithm>
#include <cstdint>

#include "league/detection_merger.hpp"
#include "league/referee_message.hpp"
#include "referee/referee.hpp"

namespace {

using namespace autoref;

class Game {
 public:
  void take(bool is_vision, const std::uint8_t* data, int size) {
    if (is_vision) {
      league::VisionPacket packet;
      if (packet.ParsePartialFromArray(data, size) && packet.IsInitialized())
        judge(merger_.add(packet));
    } else {
      league::RefereePacket packet;
      if (packet.ParsePartialFromArray(data, size) && packet.IsInitialized())
        league::signal_of(packet);
    }
  }
  void finish() { judge(merger_.finish()); }

 private:
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
  std::optional<referee::Referee> referee_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kHead = 3;
  Game game;
  while (size >= kHead) {
    const std::size_t length = std::min<std::size_t>(data[1] * 256U + data[2], size - kHead);
    game.take(data[0] % 2 == 0, data + kHead, static_cast<int>(length));
    data += kHead + length;
    size -= kHead + length;
  }
  game.finish();
  return 0;
}
