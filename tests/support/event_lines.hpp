// Reads back the event log of a whole game.
#pragma once

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "game/loop/event_log.hpp"
#include "game/loop/game.hpp"
#include "tests/support/short_game.hpp"

namespace autoref {

struct PlayedEvents {
  game::GameRecord record;
  std::string text;               // one JSON object per line
  std::vector<YAML::Node> lines;  // parsed

  std::vector<YAML::Node> of(const std::string& event) const {
    std::vector<YAML::Node> found;
    std::copy_if(lines.begin(), lines.end(), std::back_inserter(found),
                 [&](const YAML::Node& one) { return one["event"].as<std::string>() == event; });
    return found;
  }
};

inline PlayedEvents played_events(const game::GameConfiguration& game) {
  game::EventLog log(game::event_game_of(game));
  PlayedEvents events{game::play(game, &log), log.text(), {}};
  std::istringstream text(events.text);
  for (std::string line; std::getline(text, line);) events.lines.push_back(YAML::Load(line));
  return events;
}

// A game of `rowdy`, which breaks every rule now and then, against `basic`.
inline game::GameConfiguration foul_game(const std::string& book, std::uint64_t seed,
                                         double half_s) {
  game::GameConfiguration game = short_game_by(book, half_s, seed);
  game.a.strategy = "rowdy";
  return game;
}

}  // namespace autoref
