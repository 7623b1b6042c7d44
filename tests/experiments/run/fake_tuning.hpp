// A tuning with fake games, in which one parameter matters.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "experiments/kinds/tune/tuning.hpp"
#include "tests/experiments/run/fake_games.hpp"

namespace autoref::experiments {

inline constexpr double kBestRisk = 0.7;

// Goal difference per game against a team with the best risk.
inline double fake_strength(const std::map<std::string, double>& params) {
  const auto risk = params.find("pass_risk");
  const double off = risk == params.end() ? 0 : risk->second - kBestRisk;
  return -16 * off * off;
}

// The difference in strength, with a noise of -2 to 2 goals that depends only on the seed.
inline game::GameRecord fake_tuned_game(const game::GameConfiguration& game) {
  game::GameRecord record = fake_game(game);
  const double noise = static_cast<double>(game.seed % 401) / 100 - 2;
  const double lead = fake_strength(game.a.params) - fake_strength(game.b.params) + noise;
  const int goals = static_cast<int>(std::lround(lead));
  record.goals_a = std::max(0, goals);
  record.goals_b = std::max(0, -goals);
  record.goals_by_half = {{record.goals_a, 0}, {record.goals_b, 0}};
  return record;
}

// "spsa" and "cma_es" play against a team, "self" is SPSA against itself.
inline Scenario small_tuning(const std::string& name) {
  Tuning tuning;
  tuning.team.strategy = "cobalt";
  tuning.parameters = {{.name = "pass_risk", .from = 0, .to = 1, .start = 0.25, .step = 0.2},
                       {.name = "width", .from = 0.2, .to = 1, .start = 0.6, .step = 0.2}};
  if (name != "self") tuning.opponents["other"].strategy = "zone";
  if (name == "cma_es") tuning.method = kCmaEsName;
  tuning.iterations = 12;
  tuning.pairs = 2;
  tuning.test.max_pairs = 40;
  tuning.seed = 5;
  return {"A test.", tuning};
}

}  // namespace autoref::experiments
