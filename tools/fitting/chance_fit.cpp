// Fits the chances of shots (game/play_counts/chance.hpp) to shots in simulated games.
//
//   chance_fit SHOTS FOLDER
//
// For each rule book, plays games without the team that is left out (fitted_games.hpp) until SHOTS
// shots have been taken, and prints game/play_counts/chances.def with the coefficients fitted to
// them. Then plays games of the team left out, until it has taken a fifth as many shots, and writes
// to FOLDER how well the chances of these shots hold: chances.csv has one row per rule book and
// model, and reliability.csv one row per range of predicted chances.
#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "game/play_counts/chance.hpp"
#include "tools/fitting/fitted_games.hpp"
#include "tools/fitting/logistic_fit.hpp"
#include "tools/fitting/scores.hpp"

namespace autoref::tools {
namespace {

constexpr std::size_t kMostBatches = 1000;
constexpr int kTestShare = 5;

// Of the two models, the second only for shots on target.
struct FittedShots {
  std::vector<LogisticSample<game::kChanceFeatures>> all;
  std::vector<LogisticSample<game::kTargetFeatures>> on_target;
};

// The shots of a game, one per line.
class ShotLines final : public GameText {
 public:
  // `team`: the only one whose shots count; empty: both teams.
  ShotLines(const game::GameConfiguration& game, std::string team)
      : game_(game), team_(std::move(team)) {}

  void on_shot(const game::Shot& shot) override {
    if (!shot.situation) return;
    if (!team_.empty() && game::team_on(game_, shot.team).strategy != team_) return;
    text_ += fmt::format("{:d} {:d} {} {}\n", shot.has_scored, shot.situation->path.is_on_target,
                         fmt::join(game::chance_features(*shot.situation), " "),
                         fmt::join(game::target_features(*shot.situation), " "));
  }
  std::string text(const game::GameRecord& /*record*/) const override { return text_ + "\n"; }

 private:
  const game::GameConfiguration& game_;
  std::string team_;
  std::string text_;
};

// Adds the shots of a game until there are enough.
void add_shots(const std::string& text, std::size_t enough, FittedShots& shots) {
  std::istringstream lines(text);
  LogisticSample<game::kChanceFeatures> shot;
  LogisticSample<game::kTargetFeatures> on_target;
  for (bool is_on_target = false;
       shots.all.size() < enough && lines >> shot.has_happened >> is_on_target;) {
    for (double& feature : shot.features) lines >> feature;
    for (double& feature : on_target.features) lines >> feature;
    on_target.has_happened = shot.has_happened;
    shots.all.push_back(shot);
    if (is_on_target) shots.on_target.push_back(on_target);
  }
}

FittedShots shots_of_games(const std::string& rules, Purpose purpose, std::size_t enough) {
  const std::string team = purpose == Purpose::kTest ? kLeftOut : "";
  const auto make = [&team](const game::GameConfiguration& game) {
    return std::make_unique<ShotLines>(game, team);
  };
  FittedShots shots;
  for (std::size_t batch = 0; shots.all.size() < enough && batch < kMostBatches; ++batch) {
    for (const std::string& text : texts_of_batch(rules, purpose, batch, make))
      add_shots(text, enough, shots);
  }
  if (shots.all.size() < enough) throw std::runtime_error("too few shots under the rules " + rules);
  return shots;
}

void fit(const std::string& rules, std::size_t enough, Scores& scores) {
  const FittedShots shots = shots_of_games(rules, Purpose::kFit, enough);
  const FittedShots tests = shots_of_games(rules, Purpose::kTest, enough / kTestShare);
  const auto chances = fit_logistic(shots.all);
  const auto on_target = fit_logistic(shots.on_target);
  add_scores(rules, "xg", predictions_of(chances, shots.all), predictions_of(chances, tests.all),
             scores);
  add_scores(rules, "xgot", predictions_of(on_target, shots.on_target),
             predictions_of(on_target, tests.on_target), scores);
  fmt::print(
      "AUTOREF_CHANCES(\"{}\",\n    AUTOREF_COEFFICIENTS({:.3f}),\n"
      "    AUTOREF_COEFFICIENTS({:.3f}))\n",
      rules, fmt::join(chances, ", "), fmt::join(on_target, ", "));
  std::fflush(stdout);
}

int main_of(std::size_t shots, const std::filesystem::path& folder) {
  fmt::print(
      "// How good a chance a shot is under each rule book: coefficients of the features in\n"
      "// chance.hpp, without and with knowledge of the shot's path. Written by "
      "scripts/fit-chances\n"
      "// from {} shots per rule book by all teams except {}.\n",
      shots, teams_left_out());
  Scores scores;
  for (const game::ChanceModel& model : game::chance_models())
    fit(std::string(model.rules), shots, scores);
  write_scores(scores, {"shots", "goals"}, folder, "chances");
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
