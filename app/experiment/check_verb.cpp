#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "app/experiment/batch_arguments.hpp"
#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "experiments/kinds/scenario.hpp"
#include "experiments/run/trial_games.hpp"
#include "game/team_programs/program_games.hpp"
#include "io/errors.hpp"
#include "io/processes/progress.hpp"
#include "io/table.hpp"
#include "io/terminal.hpp"

namespace autoref::app {
namespace {

struct CheckArguments : BatchArguments {
  bool games = false;
};

std::string verdict_on(const experiments::Trial& trial) {
  if (!trial.void_reason.empty()) return "void: " + trial.void_reason;
  if (!trial.was_tried) return "not tried: would take too long";
  if (trial.share >= 1) return "plays";
  const double percent = 100 * trial.share;
  return fmt::format("plays; estimated from {} % of a game",
                     percent < 1 ? "less than 1" : fmt::format("{:.0f}", percent));
}

std::string table_of(const std::vector<experiments::Trial>& trials) {
  std::vector<io::Cells> rows = {{"variant", "games", "s per game (est.)", ""}};
  for (const experiments::Trial& trial : trials) {
    rows.push_back({trial.played, std::to_string(trial.games),
                    fmt::format("{:.1f}", trial.wall_s_a_game), verdict_on(trial)});
  }
  return io::table_text(
      {std::move(rows), {io::Align::kLeft, io::Align::kRight, io::Align::kRight, io::Align::kLeft}},
      io::text_width(stdout));
}

// Sorts the trials in the order of summary.csv.
std::vector<experiments::Trial> sorted(std::vector<experiments::Trial> trials) {
  std::stable_sort(trials.begin(), trials.end(),
                   [](const experiments::Trial& one, const experiments::Trial& other) {
                     return one.variant < other.variant;
                   });
  return trials;
}

int check_verb(const CheckArguments& arguments) {
  const experiments::Scenario scenario = read_experiment(arguments);
  const experiments::Experiment& experiment = scenario.experiment();
  const std::vector<experiments::ScheduledGame> games = experiment.games();
  if (arguments.games) {
    for (const experiments::ScheduledGame& game : games) fmt::print("{}\n", game.id);
    return io::kDone;
  }
  const int workers = worker_count(arguments.workers);
  const std::vector<experiments::Trial> trials = experiments::play_trials(
      experiment.trial_games(games),
      {[](const game::GameConfiguration& game, double most_wall_s) {
         return experiments::play_part(game, most_wall_s, game::make_program_or_registered_team);
       },
       workers});
  fmt::print("{}\n{} games, about {} with {} in parallel\n", table_of(sorted(trials)), games.size(),
             io::duration_text(experiments::duration_s(trials, workers)), workers);
  const std::string programs = experiments::cost_of_programs(trials, workers);
  if (!programs.empty()) fmt::print("{}\n", io::wrapped(programs, io::text_width(stdout)));
  const std::string caveat = experiment.caveat();
  if (!caveat.empty()) fmt::print("{}\n", caveat);
  const bool all_play =
      std::all_of(trials.begin(), trials.end(),
                  [](const experiments::Trial& trial) { return trial.void_reason.empty(); });
  return all_play ? io::kDone : io::kTooManyVoid;
}

}  // namespace

void add_check_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb =
      app.add_subcommand("check", "Validate an experiment and estimate how long it takes.");
  auto arguments = std::make_shared<CheckArguments>();
  add_experiment_argument(*verb, *arguments, "run");
  add_workers_option(*verb, arguments->workers,
                     "Number of parallel games that the estimate assumes.");
  add_set_option(*verb, arguments->sets);
  add_override_options(*verb, *arguments);
  verb->add_flag("--games", arguments->games, "Only print the id of every game.");
  verb->footer(
      "Takes at most ten seconds: plays a few seconds of every variant, then more of each while\n"
      "time allows. If a variant's games take too long, the estimate is based on part of a game.\n"
      "If teams are programs, the last line shows how much of the time each of them takes. The\n"
      "estimate assumes that the machine stays as busy as it is now.\n\n"
      "Example:\n  autoref check scenarios/handicap-speed.yaml");
  choose(*verb, chosen, arguments, check_verb);
}

}  // namespace autoref::app
