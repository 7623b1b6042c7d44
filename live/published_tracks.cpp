#include "live/published_tracks.hpp"

#include <fmt/format.h>

#include <random>

namespace autoref::live {

Tracks turned(Tracks tracks) {
  for (const Side side : kSides) {
    for (TrackedRobot& robot : tracks.robots[side]) robot = mirrored(robot);
  }
  if (tracks.ball) *tracks.ball = mirrored(*tracks.ball);
  return tracks;
}

std::string random_uuid() {
  std::random_device random;
  return fmt::format("{:08x}-{:04x}-4{:03x}-8{:03x}-{:08x}{:04x}", random(), random() & 0xffffU,
                     random() & 0xfffU, random() & 0xfffU, random(), random() & 0xffffU);
}

}  // namespace autoref::live
