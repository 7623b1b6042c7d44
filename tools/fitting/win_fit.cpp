// Fits what situations are worth (game/play_counts/situation_value.hpp) and the win probability
// (game/play_counts/win_probability.hpp) to simulated games.
//
//   win_fit BATCHES FOLDER
//
// For each rule book, plays BATCHES batches of games without the team that is left out
// (fitted_games.hpp), and half as many of that team. Writes FOLDER/situation_values.def and
// FOLDER/win_models.def, and how well they hold for the team left out: win-probability.csv has one
// row per rule book and model, and reliability.csv one row per range of predicted probabilities.
//
// The models and the cases that test them are
//
//   scores, concedes    one frame of each spell of play, drawn at random
//   win_after_QUARTER   west wins, predicted after a quarter, half and three quarters of each game
//                       that has not ended by then
//   draw_after_QUARTER  likewise, a draw
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/files.hpp"
#include "tools/fitting/fitted_games.hpp"
#include "tools/fitting/logistic_fit.hpp"
#include "tools/fitting/scores.hpp"
#include "tools/fitting/win_samples.hpp"

namespace autoref::tools {
namespace {

using ValueSamples = std::vector<LogisticSample<game::kValueFeatures>>;

// While a shot is on its way, its chance comes first, so only the other samples are fitted to.
game::ValueModel fit_values(const std::string& rules, const std::vector<SpellSample>& spells) {
  ValueSamples scores;
  ValueSamples concedes;
  for (const SpellSample& spell : spells) {
    if (spell.ball.shot_chance) continue;
    scores.push_back({spell.ball.features, spell.has_scored});
    concedes.push_back({spell.ball.features, spell.has_conceded});
  }
  return {rules, fit_logistic(scores).coefficients, fit_logistic(concedes).coefficients};
}

Predictions value_predictions(const game::ValueModel& values,
                              const std::vector<SpellSample>& spells,
                              double game::SituationValue::*predicted,
                              bool SpellSample::*has_happened) {
  Predictions predictions;
  predictions.reserve(spells.size());
  for (const SpellSample& spell : spells)
    predictions.push_back({spell.ball.value(values).*predicted, spell.*has_happened});
  return predictions;
}

void add_situations(const game::ValueModel& values, std::vector<PlayedSample>& samples) {
  for (PlayedSample& sample : samples) {
    if (!sample.ball) continue;
    const game::SituationValue value = sample.ball->value(values);
    sample.match.scores[sample.ball->owner] = value.scores;
    sample.match.scores[opponent_of(sample.ball->owner)] = value.concedes;
  }
}

// Parameters of a WinModel on scales on which every number is allowed.
using WinParameters = std::array<double, 4>;

game::WinModel model_of(const std::string& rules, const WinParameters& parameters) {
  constexpr double kLeastPrior_s = 10;
  return {rules, std::exp(parameters[0]), kLeastPrior_s + std::exp(parameters[1]),
          1 / (1 + std::exp(-parameters[2])), parameters[3]};
}

// The mean logarithm of the probability of the results.
double mean_log_likelihood(const game::WinModel& model, const std::vector<PlayedSample>& samples) {
  constexpr double kLeast = 1e-6;
  double sum = 0;
  for (const PlayedSample& sample : samples) {
    const game::WinProbability p = model.probability(sample.match);
    const double of_result = sample.result > 0 ? p.west : sample.result < 0 ? p.east : p.draw;
    sum += std::log(std::max(of_result, kLeast));
  }
  return sum / static_cast<double>(samples.size());
}

// Pattern search: one parameter after the other by steps that become smaller.
WinParameters fit_win_model(const std::string& rules, const std::vector<PlayedSample>& samples) {
  constexpr double kFirstStep = 0.5;
  constexpr double kLastStep = 0.01;
  constexpr int kMostRounds = 200;
  WinParameters best = {0, std::log(100.0), 0, 0};
  double best_value = mean_log_likelihood(model_of(rules, best), samples);
  double step = kFirstStep;
  for (int round = 0; round < kMostRounds && step >= kLastStep; ++round) {
    bool is_better = false;
    for (double& parameter : best) {
      for (const double change : {step, -step}) {
        parameter += change;
        const double value = mean_log_likelihood(model_of(rules, best), samples);
        if (value > best_value) {
          best_value = value;
          is_better = true;
          break;
        }
        parameter -= change;
      }
    }
    if (!is_better) step /= 2;
  }
  return best;
}

// Of the result `result`, predicted after this quarter.
Predictions result_predictions(const game::WinModel& model,
                               const std::vector<PlayedSample>& samples, int quarter,
                               double game::WinProbability::*predicted, int result) {
  Predictions predictions;
  for (const PlayedSample& sample : samples) {
    if (sample.quarter == quarter)
      predictions.push_back({model.probability(sample.match).*predicted, sample.result == result});
  }
  return predictions;
}

struct FittedText {
  std::string values;
  std::string wins;
};

FittedText fit(const std::string& rules, std::size_t batches, Scores& scores) {
  FittedSamples samples = samples_of_games(rules, Purpose::kFit, batches);
  FittedSamples tests = samples_of_games(rules, Purpose::kTest, (batches + 1) / 2);
  const game::ValueModel values = fit_values(rules, samples.spells);
  const auto add_value_scores = [&](const std::string& model,
                                    double game::SituationValue::*predicted,
                                    bool SpellSample::*has_happened) {
    add_scores({rules, model, kLeftOut},
               value_predictions(values, samples.spells, predicted, has_happened),
               value_predictions(values, tests.spells, predicted, has_happened), scores);
  };
  add_value_scores("scores", &game::SituationValue::scores, &SpellSample::has_scored);
  add_value_scores("concedes", &game::SituationValue::concedes, &SpellSample::has_conceded);
  add_situations(values, samples.played);
  add_situations(values, tests.played);
  const game::WinModel win = model_of(rules, fit_win_model(rules, samples.played));
  const auto add_result_scores = [&](const std::string& name,
                                     double game::WinProbability::*predicted, int result) {
    for (int quarter = 1; quarter < kQuarters; ++quarter) {
      add_scores({rules, fmt::format("{}_after_{}", name, quarter), kLeftOut},
                 result_predictions(win, samples.played, quarter, predicted, result),
                 result_predictions(win, tests.played, quarter, predicted, result), scores);
    }
  };
  add_result_scores("win", &game::WinProbability::west, 1);
  add_result_scores("draw", &game::WinProbability::draw, 0);
  return {fmt::format("AUTOREF_SITUATION_VALUES(\"{}\",\n    AUTOREF_COEFFICIENTS({:.3f}),\n"
                      "    AUTOREF_COEFFICIENTS({:.3f}))\n",
                      rules, fmt::join(values.scores, ", "), fmt::join(values.concedes, ", ")),
          fmt::format("AUTOREF_WIN_MODEL(\"{}\", {:.3f}, {:.1f}, {:.3f}, {:.3f})\n", rules,
                      win.prior_goals, win.prior_s, win.xg_share, win.per_robot)};
}

int main_of(std::size_t batches, const std::filesystem::path& folder) {
  const std::string games = fmt::format("{} games per rule book by all teams except {}",
                                        batches * kBatch, teams_left_out());
  FittedText text = {
      fmt::format("// What situations are worth under each rule book: coefficients of the features "
                  "in\n// situation_value.cpp, for goals by the owner of the ball and by the "
                  "opponents. Written by\n// scripts/fit-win-probability from {}.\n",
                  games),
      fmt::format("// The win probability's parameters under each rule book, in the order of "
                  "WinModel. Written by\n// scripts/fit-win-probability from {}.\n",
                  games)};
  Scores scores;
  for (const game::ChanceModel& model : game::chance_models()) {
    const FittedText fitted = fit(std::string(model.rules), batches, scores);
    text.values += fitted.values;
    text.wins += fitted.wins;
    fmt::print("{}{}", fitted.values, fitted.wins);
    std::fflush(stdout);
  }
  io::PendingFile(folder / "situation_values.def").commit(text.values);
  io::PendingFile(folder / "win_models.def").commit(text.wins);
  const PredictedThings things = {"cases", "happened"};
  write_models(scores, things, folder / "win-probability.csv");
  write_reliability(scores, things, folder / "reliability.csv");
  return 0;
}

}  // namespace
}  // namespace autoref::tools

int main(int argc, char** argv) try {
  const int batches = argc == 3 ? std::atoi(argv[1]) : 0;
  if (batches < 1) return 2;
  return autoref::tools::main_of(static_cast<std::size_t>(batches), argv[2]);
} catch (const std::exception& error) {
  std::fprintf(stderr, "win_fit: %s\n", error.what());
  return 1;
}
