// Fits the chances of shots (game/play_counts/chance.hpp) to shots in simulated games.
//
//   chance_fit SHOTS KEPT FOLDER
//
// For each rule book, reads SHOTS shots from the folder KEPT, or plays games and keeps their shots
// there (kept_shots.hpp), and prints game/play_counts/chances.def with what is fitted to them. The
// models are tested on a fifth as many shots by the team that is left out: FOLDER/chances.csv has
// one row per rule book and model, and reliability.csv one row per range of predicted chances. Then
// each other team is left out in turn: the models are fitted to the games without it and tested on
// its shots. teams.csv has one row per rule book, model and team.
#include <fmt/format.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "game/play_counts/chance.hpp"
#include "tools/fitting/fitted_games.hpp"
#include "tools/fitting/kept_shots.hpp"
#include "tools/fitting/logistic_fit.hpp"
#include "tools/fitting/scores.hpp"

namespace autoref::tools {
namespace {

constexpr int kTestShare = 5;

// The samples of the two models; the second one is only about shots on target.
struct Samples {
  std::vector<LogisticSample<game::kChanceFeatures>> all;
  std::vector<LogisticSample<game::kTargetFeatures>> on_target;
};

Samples samples_of(const std::vector<KeptShot>& shots, auto&& is_counted) {
  Samples samples;
  for (const KeptShot& shot : shots) {
    if (!is_counted(shot)) continue;
    samples.all.push_back({game::chance_features(shot.situation), shot.has_scored});
    if (shot.situation.path.is_on_target)
      samples.on_target.push_back({game::target_features(shot.situation), shot.has_scored});
  }
  return samples;
}

// Fits both models, and adds how well they hold for the tests.
game::ChanceModel fit(std::string_view rules, const std::string& left_out, const Samples& samples,
                      const Samples& tests, Scores& scores) try {
  const game::ChanceModel models = {rules, fit_limited_logistic(samples.all),
                                    fit_limited_logistic(samples.on_target)};
  const std::string book(rules);
  add_scores({book, "xg", left_out}, predictions_of(models.without_path, samples.all),
             predictions_of(models.without_path, tests.all), scores);
  add_scores({book, "xgot", left_out}, predictions_of(models.with_path, samples.on_target),
             predictions_of(models.with_path, tests.on_target), scores);
  return models;
} catch (const std::runtime_error& error) {
  throw std::runtime_error(fmt::format("{} without {}: {}", rules, left_out, error.what()));
}

// Adds how well models hold for each team if they are fitted without it.
void add_teams(std::string_view rules, const std::vector<KeptShot>& shots, Scores& scores) {
  std::set<std::string> teams;
  for (const KeptShot& shot : shots) teams.insert(shot.team);
  for (const std::string& team : teams) {
    const auto is_without_team = [&](const KeptShot& shot) {
      return shot.team != team && shot.opponent != team;
    };
    const auto is_by_team = [&](const KeptShot& shot) { return shot.team == team; };
    fit(rules, team, samples_of(shots, is_without_team), samples_of(shots, is_by_team), scores);
  }
}

std::string text_of(const auto& model) {
  return fmt::format("AUTOREF_CHANCE_MODEL({:.2f}, {:.3f})", model.upper_limit,
                     fmt::join(model.coefficients, ", "));
}

void print(const game::ChanceModel& models) {
  fmt::print("AUTOREF_CHANCES(\"{}\",\n    {},\n    {})\n", models.rules,
             text_of(models.without_path), text_of(models.with_path));
  std::fflush(stdout);
}

int main_of(std::size_t count, const std::filesystem::path& kept,
            const std::filesystem::path& folder) {
  fmt::print(
      "// How good a chance a shot is under each rule book: upper limit of the chance, and\n"
      "// coefficients of the features in chance.hpp; first without, then with knowledge of the\n"
      "// shot's path. Written by scripts/fit-chances from {} shots per rule book by all teams\n"
      "// except {}.\n",
      count, teams_left_out());
  Scores scores;
  Scores of_teams;
  const auto is_any = [](const KeptShot&) { return true; };
  for (const game::ChanceModel& model : game::chance_models()) {
    const std::string rules(model.rules);
    const std::vector<KeptShot> shots = shots_under(rules, Purpose::kFit, count, kept);
    const std::vector<KeptShot> tests =
        shots_under(rules, Purpose::kTest, count / kTestShare, kept);
    print(fit(model.rules, kLeftOut, samples_of(shots, is_any), samples_of(tests, is_any), scores));
    add_teams(model.rules, shots, of_teams);
  }
  const PredictedThings things = {"shots", "goals"};
  write_models(scores, things, folder / "chances.csv");
  write_reliability(scores, things, folder / "reliability.csv");
  write_models(of_teams, things, folder / "teams.csv");
  return 0;
}

}  // namespace
}  // namespace autoref::tools

int main(int argc, char** argv) try {
  const int shots = argc == 4 ? std::atoi(argv[1]) : 0;
  if (shots < 1) {
    std::fprintf(stderr, "usage: chance_fit SHOTS KEPT FOLDER\n");
    return 2;
  }
  return autoref::tools::main_of(static_cast<std::size_t>(shots), argv[2], argv[3]);
} catch (const std::exception& error) {
  std::fprintf(stderr, "chance_fit: %s\n", error.what());
  return 1;
}
