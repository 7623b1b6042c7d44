// The games played to evaluate the referee.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "runner/settings/game_settings.hpp"

namespace autoref::runner {

struct JudgeSchedule {
  // Settings of all games, except that rule books set the field, and cameras set radio and latency.
  GameSettings base;
  std::vector<std::string> rules = {"paper"};
  std::vector<std::string> cameras;
  // Strategies of teams a and b. The games cycle through the matchups; if there are none, the
  // base's teams play.
  std::vector<std::array<std::string, 2>> matchups;
  int games = 2;           // per rule book and camera, 1 to 9999
  std::uint64_t seed = 1;  // master seed of all games
};

struct JudgeGame {
  std::string id;  // for display: "2014 realistic basic~basic 3"
  std::string rules;
  std::string camera;
  GameSettings configuration;
  std::string game_id = {};  // id of its row: "2014+realistic+basic~basic-p0002-1"
  int pair = 1;
  int leg = 1;
};

// "a~b", as written in scenario files.
std::string name_of(const std::array<std::string, 2>& matchup);

// Returns every game number under every rule book and camera. A game number has the same seed under
// all of them. The teams change ends between odd and even games. Throws std::invalid_argument if
// values contradict each other.
std::vector<JudgeGame> games_of(const JudgeSchedule& schedule);

}  // namespace autoref::runner
