// How a team of this folder's tactics plays: its tunables.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "strategies/parameter.hpp"

namespace autoref::strategies {

// Each number's unit, default, range and meaning stand in its Parameter, below. Teams differ in
// their defaults.
struct Style {
  double shot_mps = 8.0;
  double shot_threshold = 0.10;
  double pass_arrival_mps = 1.8;
  double pass_risk = 0.5;
  double carry = 1.6;
  double wall = 2;
  double markers = 2;
  double forwards = 0;
  double receivers = 3;
  double width = 0.85;
  double line_m = -0.4;
  double keeper_out_m = 0.25;
  double ahead = 0;
  double patience = 0;
  double net_m = 1.3;
};

// One number of a style, and what is said of it.
struct Tunable {
  double Style::*number;
  Parameter about;
};
std::span<const Tunable> tunables();

// The numbers of `style` as a team's parameters, its own values being their standards.
std::vector<Parameter> parameters_of(const Style& style);

// `style` with the numbers that `params` gives.
Style tuned(const Style& style, const std::map<std::string, double>& params);

}  // namespace autoref::strategies
