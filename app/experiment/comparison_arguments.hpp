// The arguments of `autoref compare`, and the scenario that they describe.
#pragma once

#include <string>
#include <vector>

#include "app/experiment/played_experiment.hpp"
#include "experiments/kinds/scenario.hpp"
#include "experiments/statistics/anytime_interval.hpp"

namespace autoref::app {

struct CompareArguments : RunArguments {
  std::string old_team;
  std::string new_team;              // empty: the old one, with the settings of --set
  std::vector<std::string> against;  // common opponents, separated by commas
  std::string rules = "2026-b";
  std::string camera;  // empty: the default of sim.camera
  double least = experiments::ComparisonTest{}.least;
  int games = 2 * experiments::ComparisonTest{}.max_pairs;
};

// The comparison as a short scenario file, for those who want to change more than the options
// allow.
std::string scenario_text(const CompareArguments& arguments);

// The scenario that scenario_text() describes. Throws InputError naming the argument, the option or
// the team's file.
experiments::Scenario comparison_in(const CompareArguments& arguments);

// The command with the options that decide what is played, as one line for a shell.
std::string command_text(const CompareArguments& arguments);

// "compare-basic-my_team-1c9f03ae": a name for the results folder that differs if the games or the
// build do, so that every comparison has its own, and repeating one continues it.
std::string results_name(const CompareArguments& arguments, const experiments::Scenario& scenario);

}  // namespace autoref::app
