// Logistic models are fitted to samples of known models.
#include "tools/fitting/logistic_fit.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "soccer/random.hpp"

namespace autoref::tools {
namespace {

constexpr game::LimitedModel<3> kKnown = {0.8, {-2, 6, 1}};

std::vector<LogisticSample<3>> samples_of(const game::LimitedModel<3>& model, int count) {
  RandomStream random(1);
  std::vector<LogisticSample<3>> samples;
  for (int i = 0; i < count; ++i) {
    LogisticSample<3> sample;
    sample.features = {1, random.uniform(), random.uniform()};
    sample.has_happened = random.uniform() < model.probability(sample.features);
    samples.push_back(sample);
  }
  return samples;
}

void expect_coefficients(const game::LimitedModel<3>& fitted, const game::LimitedModel<3>& known) {
  for (std::size_t i = 0; i < known.coefficients.size(); ++i)
    EXPECT_NEAR(fitted.coefficients[i], known.coefficients[i], 0.5) << i;
}

TEST(LogisticFit, FindsTheCoefficients) {
  game::LimitedModel<3> known = kKnown;
  known.upper_limit = 1;
  expect_coefficients(fit_logistic(samples_of(known, 20'000)), known);
}

TEST(LogisticFit, FindsTheUpperLimit) {
  const game::LimitedModel<3> fitted = fit_limited_logistic(samples_of(kKnown, 20'000));
  EXPECT_NEAR(fitted.upper_limit, kKnown.upper_limit, 0.03);
  expect_coefficients(fitted, kKnown);
}

// Any change of a coefficient makes the model less probable.
void expect_most_probable(const game::LimitedModel<3>& fitted,
                          const std::vector<LogisticSample<3>>& samples) {
  for (const double change : {-0.01, 0.01}) {
    for (std::size_t i = 0; i < fitted.coefficients.size(); ++i) {
      game::LimitedModel<3> changed = fitted;
      changed.coefficients[i] += change;
      EXPECT_LT(log_posterior(changed, samples), log_posterior(fitted, samples))
          << fitted.upper_limit << ", " << i;
    }
  }
}

TEST(LogisticFit, IsTheMostProbableModel) {
  const std::vector<LogisticSample<3>> samples = samples_of(kKnown, 500);
  for (const double limit : {0.9, 1.0})
    expect_most_probable(fit_logistic(samples, game::LimitedModel<3>{limit}), samples);
}

// If more happens than the upper limit allows, whole steps lead too far.
TEST(LogisticFit, ConvergesWithALimitThatIsTooLow) {
  const std::vector<LogisticSample<3>> samples = samples_of(kKnown, 5'000);
  expect_most_probable(fit_logistic(samples, game::LimitedModel<3>{0.7}), samples);
}

// Without a prior, the coefficient would grow without bound.
TEST(LogisticFit, StaysFiniteIfItAlwaysHappened) {
  const game::LimitedModel<1> fitted =
      fit_logistic(std::vector<LogisticSample<1>>(100, {{1}, true}));
  EXPECT_GT(fitted.probability({1}), 0.95);
  EXPECT_LT(fitted.coefficients[0], 10);
}

}  // namespace
}  // namespace autoref::tools
