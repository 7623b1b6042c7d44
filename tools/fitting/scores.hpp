// How well predicted probabilities hold.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace autoref::tools {

// A predicted probability and what happened.
struct Prediction {
  double probability = 0;
  bool has_happened = false;
};
using Predictions = std::vector<Prediction>;

// The words for what is predicted, in the names of columns.
struct PredictedThings {
  std::string cases;     // "shots"
  std::string happened;  // "goals"
};

// Which model is scored.
struct ModelName {
  std::string rules;
  std::string model;
  std::string left_out;  // the team left out of the fit; its games test the model
};

struct ScoredModel {
  ModelName name;
  int fitted = 0;  // number of cases
  int tested = 0;
  int happened = 0;                     // number of tested cases in which it happened
  std::optional<double> expected;       // sum of the probabilities of the tested cases
  std::optional<double> brier;          // Brier score of these probabilities
  std::optional<double> brier_of_rate;  // Brier score of the share among the fitted cases
};

// The tested cases in a range of predicted probabilities.
struct ReliabilityRow {
  ModelName name;
  std::optional<double> from;
  std::optional<double> to;
  int cases = 0;
  std::optional<double> predicted;  // mean probability
  std::optional<double> happened;   // share of cases in which it happened
  std::optional<double> low;        // Wilson's 95 % interval of this share, for independent cases
  std::optional<double> high;
};

struct Scores {
  std::vector<ScoredModel> models;
  std::vector<ReliabilityRow> reliability;
};

// Adds a row about the model, and a row for each range of probabilities; the ranges are narrower
// near 0.
void add_scores(const ModelName& name, const Predictions& fitted, const Predictions& tested,
                Scores& scores);

// Writes one row per model.
void write_models(const Scores& scores, const PredictedThings& things,
                  const std::filesystem::path& file);

// Writes one row per model and range of probabilities, without the team left out.
void write_reliability(const Scores& scores, const PredictedThings& things,
                       const std::filesystem::path& file);

}  // namespace autoref::tools
