#include "runner/experiments/tuning_settings.hpp"

#include <fmt/format.h>

namespace autoref::runner {
namespace {

constexpr Range kIterationCount = {1, 9999};
constexpr Range kTuningPairs = {1, 9999};
constexpr Range kTestPairs = {2, 9999};              // a single pair has no variance
constexpr Range kGain = {0, 100, true};              // above 0
constexpr Range kDelta = {0, 50, true};              // goals
constexpr Range kTuningErrorRate = {0, 0.49, true};  // alpha + beta must stay below 1
constexpr Range kWeight = {0, 1e6, true};            // above 0
constexpr Range kParameterValue = {-1e9, 1e9};       // as of `params`

}  // namespace

std::vector<Setting> settings_of(Tuning& tuning) {
  SequentialTest& test = tuning.test;
  return {
      {"method", &tuning.method, {}, {kSpsaName, kCmaEsName}, "", "optimiser"},
      {"iterations", &tuning.iterations, kIterationCount, {}, "", "steps of the optimiser"},
      {"pairs",
       &tuning.pairs,
       kTuningPairs,
       {},
       "",
       "pairs of legs per candidate, opponent and iteration"},
      {"gain",
       &tuning.gain,
       kGain,
       {},
       "",
       "of spsa: steps that a usual difference moves the parameters in the first iteration"},
      {"test.delta", &test.d1, kDelta, {}, "goals per game", "gain that the final test looks for"},
      {"test.alpha",
       &test.alpha,
       kTuningErrorRate,
       {},
       "",
       "probability of better without any gain"},
      {"test.beta", &test.beta, kTuningErrorRate, {}, "", "probability of missing a gain of delta"},
      {"test.min_pairs", &test.min_pairs, kTestPairs, {}, "", "minimum number of pairs of legs"},
      {"test.max_pairs",
       &test.max_pairs,
       kTestPairs,
       {},
       "",
       "pairs of legs after which the test ends undecided"}};
}

std::vector<Setting> settings_of(TunedParameter& parameter) {
  const auto path = [&parameter](const char* key) {
    return fmt::format("tune.{}.{}", parameter.name, key);
  };
  return {{path("from"), &parameter.from, kParameterValue, {}, "", "least value"},
          {path("to"), &parameter.to, kParameterValue, {}, "", "largest value"},
          {path("start"), &parameter.start, kParameterValue, {}, "", "value to improve on"},
          {path("step"),
           &parameter.step,
           kParameterValue,
           {},
           "",
           "distance over which its effect is looked for at first"},
          {path("whole"),
           &parameter.whole,
           {},
           {"false", "true"},
           "",
           "whether only whole numbers are played"}};
}

std::vector<Setting> weight_settings_of(Tuning& tuning) {
  std::vector<Setting> settings;
  settings.reserve(tuning.weights.size());
  for (auto& [name, weight] : tuning.weights) {
    settings.push_back(
        {"weights." + name, &weight, kWeight, {}, "", "weight of its games in the score"});
  }
  return settings;
}

}  // namespace autoref::runner
