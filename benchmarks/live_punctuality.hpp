// Measures how punctual live games are, relative to a loop that does nothing but sleep.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "live/frame_pacer.hpp"

namespace autoref::benchmarks {

struct LiveConditions {
  double seconds = 60;  // of each game
  int load = 0;         // processes that compute all the time
};

// A live game at real time, and a bare loop of the same period beside it.
struct MeasuredLiveGame {
  std::string teams;
  live::Punctuality game;
  live::Punctuality bare;
  std::int64_t received = 0;  // frames of vision and of the tracker that arrived
  std::int64_t lost = 0;      // those that did not

  // How many times as many of the game's frames as of the bare loop's are late; nullopt if none of
  // the bare loop's is.
  std::optional<double> ratio() const;
};

// Plays two games on the loopback, one of compiled-in teams and one of teams that are commanded
// over the network, and counts what arrives. Throws InputError if the network cannot be used.
std::vector<MeasuredLiveGame> measure_live_games(const LiveConditions& conditions);

void print_live_punctuality(const LiveConditions& conditions);

}  // namespace autoref::benchmarks
