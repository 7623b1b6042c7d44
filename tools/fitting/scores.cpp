#include "tools/fitting/scores.hpp"

#include "experiments/statistics/interval.hpp"
#include "io/csv.hpp"
#include "io/files.hpp"
#include "io/table_columns.hpp"
#include "soccer/geometry.hpp"

namespace autoref::tools {
namespace {

const std::vector<double> kBounds = {0,   0.01, 0.02, 0.05, 0.1, 0.2, 0.3,
                                     0.4, 0.5,  0.6,  0.7,  0.8, 0.9, 1};

double as_number(bool has_happened) { return has_happened ? 1 : 0; }

ReliabilityRow row_of_range(double from, double to, const Predictions& tested) {
  ReliabilityRow row;
  row.from = from;
  row.to = to;
  double sum = 0;
  int happened = 0;
  for (const Prediction& one : tested) {
    const bool is_above = one.probability >= to && to < 1;  // 1 belongs to the last range
    if (one.probability < from || is_above) continue;
    ++row.cases;
    sum += one.probability;
    happened += one.has_happened ? 1 : 0;
  }
  if (row.cases == 0) return row;
  row.predicted = sum / row.cases;
  row.happened = static_cast<double>(happened) / row.cases;
  const auto interval = experiments::proportion_interval(happened, row.cases);
  row.low = interval->low;
  row.high = interval->high;
  return row;
}

}  // namespace

void add_scores(const ModelName& name, const Predictions& fitted, const Predictions& tested,
                Scores& scores) {
  double rate = 0;
  for (const Prediction& one : fitted)
    rate += as_number(one.has_happened) / static_cast<double>(fitted.size());
  ScoredModel row;
  row.name = name;
  row.fitted = static_cast<int>(fitted.size());
  row.tested = static_cast<int>(tested.size());
  if (!tested.empty()) row.expected = row.brier = row.brier_of_rate = 0;
  for (const Prediction& one : tested) {
    const double happened = as_number(one.has_happened);
    row.happened += one.has_happened ? 1 : 0;
    *row.expected += one.probability;
    *row.brier += square(one.probability - happened) / static_cast<double>(tested.size());
    *row.brier_of_rate += square(rate - happened) / static_cast<double>(tested.size());
  }
  scores.models.push_back(row);
  for (std::size_t i = 0; i + 1 < kBounds.size(); ++i) {
    ReliabilityRow range = row_of_range(kBounds[i], kBounds[i + 1], tested);
    range.name = name;
    scores.reliability.push_back(range);
  }
}

void write_models(const Scores& scores, const PredictedThings& things,
                  const std::filesystem::path& file) {
  const io::TableColumns<ScoredModel> columns = {
      {"rules", [](const ScoredModel& row) { return row.name.rules; }},
      {"model", [](const ScoredModel& row) { return row.name.model; }},
      {"left_out", [](const ScoredModel& row) { return row.name.left_out; }},
      {"fitted_" + things.cases, &ScoredModel::fitted},
      {"tested_" + things.cases, &ScoredModel::tested},
      {things.happened, &ScoredModel::happened},
      {"expected_" + things.happened, &ScoredModel::expected},
      {"brier", &ScoredModel::brier},
      {"brier_of_rate", &ScoredModel::brier_of_rate}};
  io::PendingFile(file).commit(io::csv_text(io::table_rows(columns, scores.models)));
}

void write_reliability(const Scores& scores, const PredictedThings& things,
                       const std::filesystem::path& file) {
  const io::TableColumns<ReliabilityRow> columns = {
      {"rules", [](const ReliabilityRow& row) { return row.name.rules; }},
      {"model", [](const ReliabilityRow& row) { return row.name.model; }},
      {"from", &ReliabilityRow::from},
      {"to", &ReliabilityRow::to},
      {things.cases, &ReliabilityRow::cases},
      {"predicted", &ReliabilityRow::predicted},
      {"happened", &ReliabilityRow::happened},
      {"low95", &ReliabilityRow::low},
      {"high95", &ReliabilityRow::high}};
  io::PendingFile(file).commit(io::csv_text(io::table_rows(columns, scores.reliability)));
}

}  // namespace autoref::tools
