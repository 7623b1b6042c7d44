// Shots in simulated games, kept in files, so that a model can be fitted to them again without
// playing the games.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "game/play_counts/chance.hpp"
#include "tools/fitting/fitted_games.hpp"

namespace autoref::tools {

struct KeptShot {
  std::string team;
  std::string opponent;
  bool has_scored = false;
  game::ShotSituation situation;  // except where its path crosses the goal line
};

// The first `count` shots under a rule book in the games for this purpose (fitted_games.hpp); to
// test, only those by the team left out. Reads them from FOLDER/RULES-fit.csv or
// FOLDER/RULES-test.csv. If the file is missing or has fewer, plays the games from the first one on
// and writes the shots of both teams to the file. Throws std::runtime_error if a game fails, if
// 1000 batches of games are too few, or if the file cannot be understood.
std::vector<KeptShot> shots_under(const std::string& rules, Purpose purpose, std::size_t count,
                                  const std::filesystem::path& folder);

}  // namespace autoref::tools
