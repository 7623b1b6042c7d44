// Plays an experiment in its folder for a verb: progress, pages, results, exit code.
#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <optional>
#include <string>

#include "app/experiment/batch_arguments.hpp"
#include "app/network_flags.hpp"
#include "experiments/kinds/scenario.hpp"
#include "experiments/run/run_experiment.hpp"

namespace autoref::app {

struct RunArguments : BatchArguments {
  std::string shard = "0/1";
  bool allow_mixed_build = false;
  std::string reused_folder;  // results folder whose games are taken over; empty: none
  bool quiet = false;
  bool json = false;             // print only what PrintTables prints
  std::string progress;          // "plain", "json" or "none"; empty: depends on the stream
  WebFlags web;                  // where to show the standings on the network
  std::optional<double> wait_s;  // maximum wait for games of other shards
};

// Adds --shard, --allow-mixed-build, --progress, --web and --quiet.
void add_run_options(CLI::App& verb, RunArguments& arguments);

// Prints the tables of a complete experiment. The files in the folder follow, unless the output is
// JSON.
using PrintTables = std::function<void(const experiments::ExperimentReport& report)>;

// The outcome of play_experiment().
struct PlayedExperiment {
  int exit_code = 0;
  experiments::ExperimentReport report;
};

// Plays the experiment's games that its folder lacks, updates an existing report, and prints the
// outcome. The exit code is kDone, kTooManyVoid or kInterrupted (io/errors.hpp).
PlayedExperiment play_experiment(const experiments::Scenario& scenario,
                                 const RunArguments& arguments, const PrintTables& print_tables);

}  // namespace autoref::app
