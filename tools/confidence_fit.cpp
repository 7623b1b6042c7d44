// Fits the referee's confidence in its calls to calls in simulated games, each judged by ground
// truth.
//
//   confidence_fit SCENARIO [GAMES]     GAMES per rule book and camera (default: the scenario's)
//
// Plays the games of a `kind: judge` scenario with its tuning seed (never those with its test seed)
// and prints referee/machine/confidence.def. Each event's coefficients are those of a logistic
// regression on the features of confidence.hpp, regularised towards those of all calls together, so
// that events that are rarely called do not get extreme coefficients.
#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "experiments/kinds/judge/judge_schedule.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/schedule/schedule.hpp"
#include "judge/evaluate_calls.hpp"
#include "referee/machine/confidence.hpp"

namespace autoref::tools {
namespace {

using referee::kConfidenceFeatures;
using Coefficients = Eigen::Matrix<double, kConfidenceFeatures, 1>;

struct JudgedCall {
  Coefficients features;
  bool is_right = false;
};
using JudgedCalls = std::vector<JudgedCall>;

// Weight of the prior, which is the coefficients of all calls together. It counts as much as a few
// calls.
constexpr double kPooledWeight = 2;
constexpr int kRounds = 50;

// Newton's method for the most probable coefficients, given a prior that is normally distributed
// around `prior` with variance 1 / `weight`.
Coefficients fitted(const JudgedCalls& calls, const Coefficients& prior, double weight) {
  Coefficients coefficients = prior;
  for (int round = 0; round < kRounds; ++round) {
    Coefficients gradient = weight * (prior - coefficients);
    Eigen::Matrix<double, kConfidenceFeatures, kConfidenceFeatures> curvature =
        weight * decltype(curvature)::Identity();
    for (const JudgedCall& call : calls) {
      const double p = 1 / (1 + std::exp(-coefficients.dot(call.features)));
      gradient += ((call.is_right ? 1.0 : 0.0) - p) * call.features;
      curvature += p * (1 - p) * call.features * call.features.transpose();
    }
    coefficients += curvature.ldlt().solve(gradient);
  }
  return coefficients;
}

// The features of a game's calls, by event name and time in units of 0.1 ms.
class CallFeatures final : public game::Observer {
 public:
  void on_decision(const referee::Decision& decision) override {
    const referee::Finding& finding = decision.finding;
    if (!referee::is_call(finding.event)) return;
    features_[{std::string(referee::name_of(finding.event)), ticks(decision.time_s)}] =
        Coefficients(finding.confidence_features.data());
  }
  const Coefficients* find(const std::string& name, double time_s) const {
    const auto found = features_.find({name, ticks(time_s)});
    return found == features_.end() ? nullptr : &found->second;
  }

 private:
  static long ticks(double time_s) { return std::lround(time_s * 1e4); }
  std::map<std::pair<std::string, long>, Coefficients> features_;
};

using CallsByName = std::map<std::string, JudgedCalls>;

void add_game(const game::GameConfiguration& game, CallsByName& calls) {
  CallFeatures features;
  const judge::EvaluatedGame judged =
      judge::evaluate_calls(game, game::make_registered_team, &features);
  for (const experiments::CallVerdict& verdict : judged.evaluation.verdicts) {
    const bool is_right = verdict.outcome == experiments::CallOutcome::kRight;
    if (!is_right && verdict.outcome != experiments::CallOutcome::kWrong) continue;
    const double called_s = verdict.time_s + (is_right ? verdict.delay_s : 0);
    const Coefficients* found = features.find(verdict.name, called_s);
    if (found != nullptr) calls[verdict.name].push_back({*found, is_right});
  }
}

std::string_view id_of(std::string_view name) {
#define AUTOREF_EVENT(id, ...) \
  if (referee::name_of(referee::Event::id) == name) return #id;
#include "referee/events.def"
#undef AUTOREF_EVENT
  return name;
}

void print_table(const CallsByName& calls, std::string_view seed, int games) {
  JudgedCalls all;
  for (const auto& [name, judged] : calls) all.insert(all.end(), judged.begin(), judged.end());
  const Coefficients pooled = fitted(all, Coefficients::Zero(), kPooledWeight);
  fmt::print(
      "// How sure the referee is of each call: coefficients of the features in confidence.hpp, "
      "and "
      "the\n"
      "// number of calls that they were fitted to. Written by scripts/fit-confidence from {} "
      "games with\n"
      "// the seed {}.\n",
      games, seed);
  for (const auto& [name, judged] : calls) {
    const Coefficients c = fitted(judged, pooled, kPooledWeight);
    fmt::print("AUTOREF_CONFIDENCE({}, {:.2f}, {:.2f}, {:.2f}, {:.2f}, {:.2f})  // {}\n",
               id_of(name), c[0], c[1], c[2], c[3], c[4], judged.size());
  }
}

int main_of(const std::string& file, int games) {
  experiments::JudgeSchedule schedule =
      experiments::read_scenario(file).get<experiments::JudgeSchedule>();
  if (schedule.seeds.size() > 1) experiments::keep_seed(schedule, "tuning");
  if (games > 0) schedule.games_each = games;
  CallsByName calls;
  const std::vector<experiments::ScheduledGame> scheduled = schedule.games();
  for (const experiments::ScheduledGame& game : scheduled)
    add_game(experiments::resolved(game), calls);
  print_table(calls, schedule.seeds.front().text, static_cast<int>(scheduled.size()));
  return 0;
}

}  // namespace
}  // namespace autoref::tools

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  return autoref::tools::main_of(argv[1], argc > 2 ? std::atoi(argv[2]) : 0);
}
