// Measures how punctual live games are, compared with a loop that does nothing but sleep.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "live/frame_pacer.hpp"

namespace autoref::benchmarks {

struct LiveConditions {
  double seconds = 60;  // length of each game
  int load = 0;         // number of processes that run all the time to put load on the machine
};

// A live game in real time, and a bare loop with the same period that runs alongside it.
struct MeasuredLiveGame {
  std::string teams;
  live::Punctuality game;
  live::Punctuality bare;
  std::int64_t received = 0;  // frames of vision and of the tracker that arrived
  std::int64_t lost = 0;      // frames that did not arrive

  // The number of late frames of the game relative to that of the bare loop; nullopt if the bare
  // loop was never late.
  std::optional<double> ratio() const;
};

// Plays two games over the loopback interface, one between compiled-in teams and one between teams
// that are commanded over the network, and counts the packets that arrive. Throws InputError if the
// network cannot be used.
std::vector<MeasuredLiveGame> measure_live_games(const LiveConditions& conditions);

void print_live_punctuality(const LiveConditions& conditions);

}  // namespace autoref::benchmarks
