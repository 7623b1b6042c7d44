// A short game in which both teams play over the network, on the loopback interface.
#pragma once

#include <vector>

#include "benchmarks/beside_live_game.hpp"
#include "game/loop/game_configuration.hpp"
#include "live/live_options.hpp"
#include "live/network/network.hpp"

namespace autoref::live {

inline game::GameConfiguration short_network_game() {
  game::GameConfiguration game;
  game.match.half_s = 5;
  game.match.halves = 1;
  for (game::TeamConfiguration* team : {&game.a, &game.b}) {
    team->strategy = "network";
    team->on_network = true;
  }
  return game;
}

// All ports are free ones, except that grSim's is closed.
inline LiveOptions loopback_options(Pace pace) {
  NetworkThread thread;
  LiveOptions options;
  options.speed = {pace};
  options.unicast = kLoopback;
  options.answer_s = 60;
  const std::vector<int> free = benchmarks::free_ports(thread, 6);
  options.ports.vision = free[0];
  options.ports.referee = free[1];
  options.ports.tracker = free[2];
  options.ports.blue = free[3];
  options.ports.yellow = free[4];
  options.ports.control = free[5];
  options.ports.grsim = 0;
  return options;
}

}  // namespace autoref::live
