// Fits the chances of shots (game/play_counts/chance.hpp) to shots in simulated games.
//
//   chance_fit SHOTS FOLDER
//
// For each rule book, plays games between all teams that shoot, except cobalt and its predecessor,
// until these have taken SHOTS shots, and prints game/play_counts/chances.def with the coefficients
// fitted to them. Then plays games of cobalt against each of these teams and itself, until it has
// taken a fifth as many shots, and writes to FOLDER how well the chances of these shots hold:
// chances.csv has one row per rule book and model, and reliability.csv one row per range of
// predicted chances.
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/statistics/interval.hpp"
#include "game/loop/game.hpp"
#include "game/play_counts/chance.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/game_settings.hpp"
#include "io/csv.hpp"
#include "io/files.hpp"
#include "io/processes/workers.hpp"
#include "io/table_columns.hpp"
#include "strategies/registry.hpp"

namespace autoref::tools {
namespace {

// The team whose shots test the fit.
constexpr const char* kLeftOut = "cobalt";
// Teams that play neither in the games for the fit nor against cobalt: its predecessor, which plays
// similarly, and a team that never shoots.
constexpr std::array<std::string_view, 2> kNotUsed = {"cobalt1", "dummy"};
// The games for fitting and those for testing have different seeds.
constexpr std::uint64_t kFitSeed = 2026'0000'0000;
constexpr std::uint64_t kTestSeed = 2027'0000'0000;
// Games played before the shots are counted. The fit uses them in the order of their numbers, so it
// does not depend on the number of processors.
constexpr std::size_t kBatch = 100;
constexpr std::size_t kMostGames = 100'000;
constexpr int kTestShare = 5;
// The prior of every coefficient is normal, with mean 0 and this inverse variance.
constexpr double kPriorWeight = 1;
constexpr int kRounds = 40;

struct FittedShot {
  std::array<double, game::kChanceFeatures> features{};
  std::array<double, game::kTargetFeatures> target_features{};
  bool is_on_target = false;
  bool has_scored = false;
};

// The shots of a game as text, one per line, for the worker's answer.
class ShotLines final : public game::Observer {
 public:
  // `team`: the only one whose shots count; empty: both teams.
  ShotLines(const game::GameConfiguration& game, std::string team)
      : game_(game), team_(std::move(team)) {}

  void on_shot(const game::Shot& shot) override {
    if (!shot.situation) return;
    if (!team_.empty() && game::team_on(game_, shot.team).strategy != team_) return;
    text_ += fmt::format("{} {} {} {}\n", shot.has_scored ? 1 : 0,
                         shot.situation->path.is_on_target ? 1 : 0,
                         fmt::join(game::chance_features(*shot.situation), " "),
                         fmt::join(game::target_features(*shot.situation), " "));
  }
  // Never empty.
  std::string text() const { return text_ + "\n"; }

 private:
  const game::GameConfiguration& game_;
  std::string team_;
  std::string text_;
};

std::vector<FittedShot> shots_in(const std::string& text) {
  std::vector<FittedShot> shots;
  std::istringstream lines(text);
  for (FittedShot shot; lines >> shot.has_scored >> shot.is_on_target;) {
    for (double& feature : shot.features) lines >> feature;
    for (double& feature : shot.target_features) lines >> feature;
    shots.push_back(shot);
  }
  return shots;
}

struct TeamPair {
  std::string a;
  std::string b;
};

// All ordered pairs of teams, including each team against itself: with cobalt, or without it.
std::vector<TeamPair> pairs_of(bool has_left_out) {
  std::vector<std::string> teams;
  for (const strategies::Entry& entry : strategies::all_strategies()) {
    if (std::find(kNotUsed.begin(), kNotUsed.end(), entry.name) == kNotUsed.end())
      teams.emplace_back(entry.name);
  }
  std::vector<TeamPair> pairs;
  for (const std::string& a : teams) {
    for (const std::string& b : teams) {
      if ((a == kLeftOut || b == kLeftOut) == has_left_out) pairs.push_back({a, b});
    }
  }
  return pairs;
}

// Plays games until there are enough shots. Throws std::runtime_error if a game fails.
std::vector<FittedShot> shots_of_games(const std::string& rules, bool is_test, std::size_t enough) {
  const std::vector<TeamPair> pairs = pairs_of(is_test);
  io::WorkerOptions pool;
  pool.workers = io::processors();
  std::vector<FittedShot> shots;
  for (std::size_t first = 0; shots.size() < enough && first < kMostGames; first += kBatch) {
    std::vector<std::string> answers(kBatch);
    std::vector<std::size_t> jobs;
    for (std::size_t i = 0; i < kBatch; ++i) jobs.push_back(first + i);
    const auto work = [&](const io::Job& job) {
      game::GameSettings settings;
      game::set_by_path(settings, "match.rules", rules);
      settings.a.strategy = pairs[job.number % pairs.size()].a;
      settings.b.strategy = pairs[job.number % pairs.size()].b;
      settings.seed = (is_test ? kTestSeed : kFitSeed) + job.number;
      const game::GameConfiguration game = game::resolved(settings);
      ShotLines lines(game, is_test ? kLeftOut : "");
      game::play(game, &lines);
      return lines.text();
    };
    const auto done = [&](const io::JobResult& result) {
      if (!result.failure.empty()) throw std::runtime_error(result.failure);
      answers[result.job - first] = result.payload;
    };
    if (io::do_jobs(jobs, pool, {work, done, [] {}}) == io::Ending::kInterrupted)
      throw io::Interrupted();
    for (const std::string& answer : answers) {
      const std::vector<FittedShot> some = shots_in(answer);
      shots.insert(shots.end(), some.begin(), some.end());
    }
  }
  if (shots.size() < enough) throw std::runtime_error("too few shots under the rules " + rules);
  shots.resize(enough);
  return shots;
}

// Newton's method for the most probable coefficients of a logistic regression.
template <std::size_t kCount>
std::array<double, kCount> fit_coefficients(const std::vector<FittedShot>& shots,
                                            std::array<double, kCount> FittedShot::*features,
                                            const std::function<bool(const FittedShot&)>& counts) {
  using Vector = Eigen::Matrix<double, static_cast<int>(kCount), 1>;
  using Matrix = Eigen::Matrix<double, static_cast<int>(kCount), static_cast<int>(kCount)>;
  Vector coefficients = Vector::Zero();
  for (int round = 0; round < kRounds; ++round) {
    Vector gradient = -kPriorWeight * coefficients;
    Matrix curvature = kPriorWeight * Matrix::Identity();
    for (const FittedShot& shot : shots) {
      if (!counts(shot)) continue;
      const Vector x((shot.*features).data());
      const double p = 1 / (1 + std::exp(-coefficients.dot(x)));
      gradient += ((shot.has_scored ? 1.0 : 0.0) - p) * x;
      curvature += p * (1 - p) * x * x.transpose();
    }
    coefficients += curvature.ldlt().solve(gradient);
  }
  std::array<double, kCount> result{};
  std::copy(coefficients.begin(), coefficients.end(), result.begin());
  return result;
}

// A shot's predicted chance and its outcome.
struct Prediction {
  double chance = 0;
  bool has_scored = false;
};
using Predictions = std::vector<Prediction>;

template <std::size_t kCount>
Predictions predictions_of(const std::vector<FittedShot>& shots,
                           std::array<double, kCount> FittedShot::*features,
                           const std::array<double, kCount>& coefficients,
                           const std::function<bool(const FittedShot&)>& counts) {
  Predictions predictions;
  for (const FittedShot& shot : shots) {
    if (counts(shot))
      predictions.push_back({game::probability(coefficients, shot.*features), shot.has_scored});
  }
  return predictions;
}

struct ScoredModel {
  std::string rules;
  std::string model;
  int fitted = 0;
  int tested = 0;
  int goals = 0;
  std::optional<double> expected;       // sum of the chances of the tested shots
  std::optional<double> brier;          // Brier score of these chances
  std::optional<double> brier_of_rate;  // Brier score of the share of goals of the fitted shots
};

struct ReliabilityRow {
  std::string rules;
  std::string model;
  std::optional<double> from;
  std::optional<double> to;
  int shots = 0;
  std::optional<double> predicted;  // mean chance
  std::optional<double> scored;     // share of goals
  std::optional<double> low;
  std::optional<double> high;
};

const std::vector<double> kBounds = {0,   0.01, 0.02, 0.05, 0.1, 0.2, 0.3,
                                     0.4, 0.5,  0.6,  0.7,  0.8, 0.9, 1};

struct Scores {
  std::vector<ScoredModel> models;
  std::vector<ReliabilityRow> reliability;
};

void add_scores(const std::string& rules, const std::string& model, const Predictions& fitted_to,
                const Predictions& tested, Scores& scores) {
  double rate = 0;
  for (const Prediction& one : fitted_to)
    rate += (one.has_scored ? 1.0 : 0.0) / static_cast<double>(fitted_to.size());
  ScoredModel row{
      rules, model, static_cast<int>(fitted_to.size()), static_cast<int>(tested.size()), 0, 0.0,
      0.0,   0.0};
  for (const Prediction& one : tested) {
    const double goal = one.has_scored ? 1 : 0;
    row.goals += one.has_scored ? 1 : 0;
    *row.expected += one.chance;
    *row.brier += square(one.chance - goal) / static_cast<double>(tested.size());
    *row.brier_of_rate += square(rate - goal) / static_cast<double>(tested.size());
  }
  scores.models.push_back(row);
  for (std::size_t i = 0; i + 1 < kBounds.size(); ++i) {
    ReliabilityRow range{rules, model, kBounds[i], kBounds[i + 1], 0, {}, {}, {}, {}};
    double sum = 0;
    int goals = 0;
    for (const Prediction& one : tested) {
      if (one.chance < kBounds[i] || one.chance >= kBounds[i + 1]) continue;
      ++range.shots;
      sum += one.chance;
      goals += one.has_scored ? 1 : 0;
    }
    if (range.shots > 0) {
      range.predicted = sum / range.shots;
      range.scored = static_cast<double>(goals) / range.shots;
      const auto interval = experiments::proportion_interval(goals, range.shots);
      range.low = interval->low;
      range.high = interval->high;
    }
    scores.reliability.push_back(range);
  }
}

std::string text_of(const auto& coefficients) {
  std::string text;
  for (const double one : coefficients)
    text += fmt::format("{}{:.3f}", text.empty() ? "" : ", ", one);
  return text;
}

void fit(const std::string& rules, std::size_t enough, Scores& scores) {
  const std::vector<FittedShot> shots = shots_of_games(rules, false, enough);
  const std::vector<FittedShot> tests = shots_of_games(rules, true, enough / kTestShare);
  const auto all = [](const FittedShot& /*shot*/) { return true; };
  const auto on_target = [](const FittedShot& shot) { return shot.is_on_target; };
  const auto coefficients = fit_coefficients(shots, &FittedShot::features, all);
  const auto target = fit_coefficients(shots, &FittedShot::target_features, on_target);
  const auto predicted = [&](const std::vector<FittedShot>& some) {
    return predictions_of(some, &FittedShot::features, coefficients, all);
  };
  const auto predicted_on_target = [&](const std::vector<FittedShot>& some) {
    return predictions_of(some, &FittedShot::target_features, target, on_target);
  };
  add_scores(rules, "xg", predicted(shots), predicted(tests), scores);
  add_scores(rules, "xgot", predicted_on_target(shots), predicted_on_target(tests), scores);
  fmt::print(
      "AUTOREF_CHANCES(\"{}\",\n    AUTOREF_COEFFICIENTS({}),\n"
      "    AUTOREF_COEFFICIENTS({}))\n",
      rules, text_of(coefficients), text_of(target));
  std::fflush(stdout);
}

std::string csv_of(const auto& columns, const auto& rows) {
  return io::csv_text(io::table_rows(columns, rows));
}

void write(const Scores& scores, const std::filesystem::path& folder) {
  io::PendingFile(folder / "chances.csv")
      .commit(csv_of(io::TableColumns<ScoredModel>{{"rules", &ScoredModel::rules},
                                                   {"model", &ScoredModel::model},
                                                   {"fitted_shots", &ScoredModel::fitted},
                                                   {"tested_shots", &ScoredModel::tested},
                                                   {"goals", &ScoredModel::goals},
                                                   {"expected_goals", &ScoredModel::expected},
                                                   {"brier", &ScoredModel::brier},
                                                   {"brier_of_rate", &ScoredModel::brier_of_rate}},
                     scores.models));
  io::PendingFile(folder / "reliability.csv")
      .commit(csv_of(io::TableColumns<ReliabilityRow>{{"rules", &ReliabilityRow::rules},
                                                      {"model", &ReliabilityRow::model},
                                                      {"from", &ReliabilityRow::from},
                                                      {"to", &ReliabilityRow::to},
                                                      {"shots", &ReliabilityRow::shots},
                                                      {"predicted", &ReliabilityRow::predicted},
                                                      {"scored", &ReliabilityRow::scored},
                                                      {"low95", &ReliabilityRow::low},
                                                      {"high95", &ReliabilityRow::high}},
                     scores.reliability));
}

int main_of(std::size_t shots, const std::filesystem::path& folder) {
  fmt::print(
      "// How good a chance a shot is under each rule book: coefficients of the features in\n"
      "// chance.hpp, without and with knowledge of the shot's path. Written by "
      "scripts/fit-chances\n"
      "// from {} shots per rule book by all teams except {}, {}.\n",
      shots, kLeftOut, fmt::join(kNotUsed, ", "));
  Scores scores;
  for (const game::ChanceModel& model : game::chance_models())
    fit(std::string(model.rules), shots, scores);
  write(scores, folder);
  return 0;
}

}  // namespace
}  // namespace autoref::tools

int main(int argc, char** argv) try {
  const int shots = argc == 3 ? std::atoi(argv[1]) : 0;
  if (shots < 1) return 2;
  return autoref::tools::main_of(static_cast<std::size_t>(shots), argv[2]);
} catch (const std::exception& error) {
  std::fprintf(stderr, "chance_fit: %s\n", error.what());
  return 1;
}
