#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "experiments/statistics/sample_size.hpp"
#include "io/errors.hpp"
#include "io/json.hpp"
#include "io/words.hpp"

namespace autoref::app {
namespace {

struct SampleSizeArguments {
  std::string delta;
  std::string sd;
  std::string power = "0.8";
  bool json = false;
};

// Parses a flag's value. Throws InputError unless it is above 0.
double positive(const std::string& flag, const std::string& text) {
  const std::optional<double> number = io::number_in(text);
  if (number && *number > 0) return *number;
  throw io::InputError({flag}, "", fmt::format("expected a number above 0, found '{}'", text));
}

double share(const std::string& flag, const std::string& text) {
  const std::optional<double> number = io::number_in(text);
  if (number && *number > 0 && *number < 1) return *number;
  throw io::InputError({flag}, "",
                       fmt::format("expected a number strictly between 0 and 1, such as 0.8, "
                                   "found '{}'",
                                   text));
}

int games_for(const experiments::DifferenceSought& sought, double power) {
  if (const std::optional<int> games = experiments::games_needed(sought, power)) return *games;
  throw io::InputError(
      {"--delta"}, "",
      fmt::format("detecting {} goals per game with a standard deviation of {} per "
                  "game takes more than {} games; choose a larger difference or "
                  "accept less power",
                  sought.delta, sought.sd, experiments::kMostScheduledGames));
}

std::string text_of(const experiments::DifferenceSought& sought, double power, int games) {
  return fmt::format(
      "{} pairs of legs, {} games, detect a true difference of {} goals per game with probability\n"
      "{:.3f} (requested: at least {}).\n\n"
      "--sd {} is the standard deviation of a single game's goal difference. The unit of the test\n"
      "is the pair of legs. With independent legs, its mean goal difference has the standard\n"
      "deviation {} / sqrt(2) = {:.4g}. The test is the two-sided t test of the pairs' means\n"
      "against 0, at level {}.\n",
      games / 2, games, sought.delta, experiments::power_of(sought, games / 2), power, sought.sd,
      sought.sd, sought.sd / std::numbers::sqrt2, sought.alpha);
}

std::string json_of(const experiments::DifferenceSought& sought, double power, int games) {
  return io::json_text({{"delta", sought.delta},
                        {"sd_of_a_game", sought.sd},
                        {"alpha", sought.alpha},
                        {"power_asked", power},
                        {"power", experiments::power_of(sought, games / 2)},
                        {"pairs", games / 2},
                        {"games", games}}) +
         "\n";
}

int sample_size_verb(const SampleSizeArguments& arguments) {
  const experiments::DifferenceSought sought{positive("--delta", arguments.delta),
                                             positive("--sd", arguments.sd)};
  const double power = share("--power", arguments.power);
  const int games = games_for(sought, power);
  fmt::print("{}", arguments.json ? json_of(sought, power, games) : text_of(sought, power, games));
  return io::kDone;
}

}  // namespace

void add_sample_size_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("sample-size",
                                      "Compute how many games are needed to detect a difference.");
  auto arguments = std::make_shared<SampleSizeArguments>();
  verb->add_option("--delta", arguments->delta, "Difference to detect, in goals per game.")
      ->required()
      ->type_name("GOALS");
  verb->add_option("--sd", arguments->sd,
                   "Standard deviation of a SINGLE GAME's goal difference (not of a pair's mean).")
      ->required()
      ->type_name("GOALS");
  verb->add_option("--power", arguments->power,
                   "Probability of detecting the difference, between 0 and 1. Default: 0.8.")
      ->type_name("SHARE");
  add_json_flag(*verb, arguments->json);
  verb->footer(
      "The unit of the test is the pair of legs, as in an experiment's intervals: a two-sided\n"
      "t test (level 0.05) of the pairs' mean goal differences. Legs are assumed independent, so\n"
      "the standard deviation of a pair's mean is that of a game divided by sqrt(2).\n\n"
      "Example:\n  autoref experiment sample-size --delta 0.5 --sd 2 --power 0.8");
  choose(*verb, chosen, arguments, sample_size_verb);
}

}  // namespace autoref::app
