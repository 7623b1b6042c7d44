// The tunables of `basic`.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "soccer/units.hpp"
#include "strategies/parameter.hpp"

namespace autoref::strategies::basic {

// The Parameter of each number, in style.cpp, gives its unit, range and meaning.
struct Style {
  double shot_mps = 6.5;
  double pass_mps = 4.0;
  double slowest_pass_mps = 1.3;
  double pass_per_metre_per_s = 0.7;
  double push_mps = 1.6;
  double clearance_mps = 3.0;
  double kick_caution = 0.93;
  double duel_m = 250_mm;
  double pass_lane_m = 200_mm;
  double shot_lane_m = 110_mm;
  double free_lane_m = 300_mm;
  double aim_share = 0.5;
  double back_pass_m = 200_mm;
  double robot_gap_m = 30_mm;
  double ball_gap_m = 20_mm;
  double stop_speed_share = 0.8;
  double sidestep_m = 60_mm;
  double from_their_area_m = 100_mm;
  double keeper_fetch_mps = 1.5;
  double keeper_area_margin_m = 0.05;
  double keeper_shot_mps = 0.3;
  double margin_m = 30_mm;
  double wall_gap_m = 220_mm;
  double mark_radii = 3.2;
  double mark_off_ball_m = 0.3;
  double supporter_ahead = 0.25;
  double supporter_back = -0.2;
  double supporter_front = 0.6;
  double supporter_row = 0.3;
  double supporter_wing = 0.45;
  double loyalty_s = 0.3;
  double go_round_s = 0.8;
};

// The style's numbers as parameters, and the style with the numbers set by a scenario's `params`.
std::vector<Parameter> parameters();
Style tuned(const std::map<std::string, double>& params);

}  // namespace autoref::strategies::basic
