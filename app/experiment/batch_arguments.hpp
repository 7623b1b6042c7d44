// Arguments of the verbs that play many games, and what they print in common.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/kinds/scenario.hpp"
#include "experiments/run/run_experiment.hpp"

namespace autoref::app {

struct BatchArguments {
  std::string file;
  std::string folder;             // empty: results/runs/<scenario>
  int workers = 0;                // 0: one per processor
  std::string pairs;              // overrides the file's pairs unless empty
  std::string seed;               // overrides the file's seed unless empty
  std::vector<std::string> sets;  // "key=value"

  std::filesystem::path results_folder() const;
};

// Adds the argument for a scenario that `verb_name` can play.
void add_experiment_argument(CLI::App& verb, BatchArguments& arguments,
                             const std::string& verb_name);

// Adds --output, --workers and --set.
void add_batch_options(CLI::App& verb, BatchArguments& arguments);

// Adds --pairs and --seed.
void add_override_options(CLI::App& verb, BatchArguments& arguments);

// Reads an experiment that `autoref run` plays, and applies --set, --pairs and --seed. Throws
// InputError for a scenario of another kind, naming the verb that plays it.
experiments::Scenario read_experiment(const BatchArguments& arguments);

// Sets the experiment's seed to the value of --seed; an empty text changes nothing. Throws
// InputError.
void override_seed(const std::string& text, experiments::Scenario& scenario);

// Prints which games were not played by the official rules, and an empty line; nothing if all were.
void print_rule_notes(const experiments::ExperimentReport& report);

}  // namespace autoref::app
