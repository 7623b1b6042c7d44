// Which games are played to judge the referee.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "runner/settings/game_settings.hpp"

namespace autoref::runner {

struct JudgeSchedule {
  // Each book brings its field, and each camera its radio and latency; the base gives the rest.
  GameSettings base;
  std::vector<std::string> rules = {"paper"};
  std::vector<std::string> cameras;
  // Strategies of team a and b, by turns; where there are none, the base's teams play.
  std::vector<std::array<std::string, 2>> matchups;
  int games = 2;           // under each book and camera; 1 to 9999
  std::uint64_t seed = 1;  // of all games
};

struct JudgeGame {
  std::string id;  // for people: "2014 realistic basic~basic 3"
  std::string rules;
  std::string camera;
  GameSettings configuration;
  std::string game_id = {};  // of its row: "2014+realistic+basic~basic-p0002-1"
  int pair = 1;
  int leg = 1;
};

// "a~b", as in a file.
std::string name_of(const std::array<std::string, 2>& matchup);

// Game by game over all books and cameras: a game number has the same seed under each. Odd and even
// games change ends. Throws std::invalid_argument where values do not go together.
std::vector<JudgeGame> games_of(const JudgeSchedule& schedule);

}  // namespace autoref::runner
