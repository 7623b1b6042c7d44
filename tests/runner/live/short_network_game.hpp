// A short game whose teams are both on the network, all of it on the loopback.
#pragma once

#include <initializer_list>

#include "runner/bench/beside_live_game.hpp"
#include "runner/game/configuration.hpp"
#include "runner/live/live_options.hpp"
#include "runner/live/network.hpp"

namespace autoref::runner {

inline GameConfiguration short_network_game() {
  GameConfiguration game;
  game.match.half_s = 5;
  game.match.halves = 1;
  for (TeamConfiguration* team : {&game.a, &game.b}) {
    team->strategy = "network";
    team->on_network = true;
  }
  return game;
}

// Every port is a free one, but grSim's is closed.
inline LiveOptions loopback_options(Pace pace) {
  NetworkThread thread;
  LiveOptions options;
  options.speed = {pace};
  options.unicast = kLoopback;
  options.answer_s = 60;
  for (int* port : {&options.ports.vision, &options.ports.referee, &options.ports.tracker,
                    &options.ports.blue, &options.ports.yellow, &options.ports.control})
    *port = free_port(thread);
  options.ports.grsim = 0;
  return options;
}

}  // namespace autoref::runner
