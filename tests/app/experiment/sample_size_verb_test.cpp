#include <gtest/gtest.h>

#include <utility>

#include "io/errors.hpp"
#include "tests/app/answer.hpp"

namespace autoref::app {
namespace {

Answer answer_to_sample_size(const std::vector<const char*>& arguments) {
  return answer_to("experiment sample-size", arguments);
}

// Pairs and power are those of statsmodels (sample_size_test.cpp).
TEST(SampleSizeVerb, PrintsGamesAndAssumptions) {
  const Answer answer = answer_to_sample_size({"--delta", "0.5", "--sd", "2", "--power", "0.8"});
  EXPECT_EQ(answer.code, io::kDone);
  EXPECT_EQ(
      answer.out,
      R"(65 pairs of legs, 130 games, detect a true difference of 0.5 goals per game with probability
0.802 (requested: at least 0.8).

--sd 2 is the standard deviation of a single game's goal difference. The unit of the test
is the pair of legs. With independent legs, its mean goal difference has the standard
deviation 2 / sqrt(2) = 1.414. The test is the two-sided t test of the pairs' means
against 0, at level 0.05.
)");
}

TEST(SampleSizeVerb, ExplainsItself) {
  const Answer answer = answer_to_sample_size({"--help"});
  EXPECT_EQ(answer.code, io::kDone);
  EXPECT_EQ(answer.out, R"(Compute how many games are needed to detect a difference.
Usage: autoref experiment sample-size [OPTIONS]

Options:
  -h,--help                   Print this help message and exit
  --delta GOALS REQUIRED      Difference to detect, in goals per game.
  --sd GOALS REQUIRED         Standard deviation of a SINGLE GAME's goal difference (not of a pair's mean).
  --power SHARE               Probability of detecting the difference, between 0 and 1. Default: 0.8.
  --json                      Print one JSON object.

The unit of the test is the pair of legs, as in an experiment's intervals: a two-sided
t test (level 0.05) of the pairs' mean goal differences. Legs are assumed independent, so
the standard deviation of a pair's mean is that of a game divided by sqrt(2).

Example:
  autoref experiment sample-size --delta 0.5 --sd 2 --power 0.8
)");
}

TEST(SampleSizeVerb, UsesAPowerOf80PercentByDefault) {
  EXPECT_EQ(answer_to_sample_size({"--delta", "0.5", "--sd", "2"}).out,
            answer_to_sample_size({"--delta", "0.5", "--sd", "2", "--power", "0.8"}).out);
}

TEST(SampleSizeVerb, PrintsTheSameAsJson) {
  const Answer answer = answer_to_sample_size({"--delta", "0.5", "--sd", "2", "--json"});
  EXPECT_TRUE(answer.out.starts_with(
      R"({"delta": 0.5, "sd_of_a_game": 2, "alpha": 0.05, "power_asked": 0.8, "power": 0.80163163)"))
      << answer.out;
  EXPECT_TRUE(answer.out.ends_with(", \"pairs\": 65, \"games\": 130}\n")) << answer.out;
}

struct WrongNumbers {
  const char* delta;
  const char* sd;
  const char* power;
  const char* message;
};

TEST(SampleSizeVerb, RefusesInvalidArguments) {
  for (const WrongNumbers& wrong : std::vector<WrongNumbers>{
           {"0", "2", "0.8", "--delta: expected a number above 0, found '0'"},
           {"-1", "2", "0.8", "--delta: expected a number above 0, found '-1'"},
           {"nan", "2", "0.8", "--delta: expected a number above 0, found 'nan'"},
           {"1", "0", "0.8", "--sd: expected a number above 0, found '0'"},
           {"1", "inf", "0.8", "--sd: expected a number above 0, found 'inf'"},
           {"1", "2", "0", "--power: expected a number strictly between 0 and 1"},
           {"1", "2", "1", "--power: expected a number strictly between 0 and 1"},
           {"1", "2", "80", "--power: expected a number strictly between 0 and 1"},
           {"0.001", "2", "0.8", "takes more than 1000000 games"}}) {
    const Answer answer = answer_to_sample_size({"--delta", wrong.delta, "--sd", wrong.sd,  //
                                                 "--power", wrong.power});
    EXPECT_EQ(answer.code, io::kBadInput);
    EXPECT_NE(answer.err.find(wrong.message), std::string::npos) << answer.err;
    EXPECT_EQ(answer.out, "");
  }
}

TEST(SampleSizeVerb, NeedsADifferenceAndADeviation) {
  EXPECT_EQ(answer_to_sample_size({"--delta", "1"}).code, io::kBadInput);
  EXPECT_EQ(answer_to_sample_size({"--sd", "1"}).code, io::kBadInput);
}

}  // namespace
}  // namespace autoref::app
