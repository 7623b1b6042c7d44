// The tunables of teams that are built from these tactics.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "soccer/units.hpp"
#include "strategies/parameter.hpp"

namespace autoref::strategies {

// The Parameter of each number, below, gives its unit, default, range and meaning. Teams differ in
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

  // Driving, and distances required by the rules.
  double usable_braking = 0.55;
  double turn_braking_radps2 = 14.0;
  double approach_per_s = 9;
  double stop_speed_share = 0.85;
  double off_area_m = 60_mm;
  double near_room_m = 20_mm;
  double ease_from_m = 0.6;
  double gentle_mps = 0.7;
  double ease_mps2 = 2.5;
  double possession_margin_s = 0.15;
  double from_their_area_m = 0.15;
  double from_own_area_m = 0.2;
  double beyond_line_m = 0.57;
  double room_for_taker_m = 0.5;
  double kick_caution = 0.93;

  // Values and execution of kicks.
  double miss_cost = 0.04;
  double shot_share = 0.6;
  double nearest_pass_m = 0.5;
  double pass_lead_s = 0.25;
  double after_pass = 0.7;
  double after_chip = 0.45;
  double pass_tolerance_rad = 0.05;
  double chip_hops_m = 1.0;
  double shortest_chip_m = 0.8;
  double flown_over_m = 0.35;
  double chip_along_mps = 3.0;
  double free_room_m = 0.6;
  double no_room_m = 0.2;
  double carry_worth = 0.3;
  double limited_carry = 1.0;
  double clear_worth = 0.04;
  double clear_mps = 2.3;
  double push_mps = 1.5;
  double clear_m = 1.8;
  double clear_tolerance_rad = 0.25;
  double widest_clear_rad = 80_deg;
  double clear_turn_cost = 0.3;
  double clear_heading_cost = 0.5;

  // The robot at the ball.
  double pass_flight_s = 2.0;
  double choice_loyalty = 0.06;
  double still_shoots = 0.5;
  double turn_nll = 0.3;
  double late_cost = 0;
  double late_spread_s = 0.07;
  double contested_hold_s = 0.2;
  double turning_ball_mps = 0.7;
  double worthless = 0.04;
  double pressed = 0.5;
  double rough_clear_rad = 0.6;
  double carry_mps = 1.6;
  double shy_m = 1.0;
  double shyness = 1.5;
  double edge_m = 0.5;
  double edge_shyness = 3.0;
  double hurry_s = 0.4;
  double pressed_bend_rad = 0.12;
  double free_bend_rad = 1.4;
  double fight_m = 0.45;
  double dribbling_share = 0.4;
  double release_rad = 3.0;
  double near_line_m = 0.2;
  double block_from_m = 60_mm;
  double block_press_mps = 0.5;
  double block_close_per_s = 6.0;
  double face_off_s = 0.5;
  double face_off_ahead_mps = 0.3;
  double face_off_aside_mps = 0.8;
  double face_off_turn_radps = 5.0;

  // Positions of receivers.
  double receiver_hold_frames = 20;
  double ahead_worth = 0.2;
  double stopped_share = 0.35;
  double first_time_cosine = 0.35;
  double field_pass_mps = 5.0;
  double unsafe_share = 0.3;
  double receivers_apart_m = 1.0;
  double far_cost_per_m = 0.04;
  double far_cost_in_stop_per_m = 0.15;
  double receiver_loyalty = 0.05;
  double receivers_from_edge_m = 0.25;

  // Wall, markers and keeper.
  double wall_gap_m = 6_mm;
  double wall_off_area_m = 60_mm;
  double mark_m = 0.30_m;
  double mark_ball_side = 0.35;
  double harmless_m = 0.8;
  double mark_off_ball_m = 0.35_m;
  double keeper_shot_mps = 0.6;
  double keeper_beside_post_m = 150_mm;
  double keeper_off_line_m = 20_mm;
  double keeper_fetch_mps = 1.2;
  double keeper_area_margin_m = 0.15;
  double keeper_aim_trust = 0.6;

  // Covering the goal together, and restarts. The defaults switch these behaviours off.
  double anticipation = 0;
  double threat_lead_s = 0;
  double block_lead_s = 0;
  double keeper_fills_gap = 0;
  double keeper_dives = 0;
  double wall_near_post_m = 0;
  double dribbled_restart = 0;
  double large_team = 0;

  // Avoiding fouls.
  double area_margin_m = 0.05;
  double around_boxes = 1;
  double area_braking_mps2 = 1.5;
  double ball_margin_m = 0.06;
  double contact_mps = 0.4;
  double card_gentle_mps = 3.0;
  double card_ease_mps2 = 10.0;
  double card_ease_from_m = 0;
  double dribble_gap_m = 0.03;
  double hasty_share = 0.5;
  double release_lead_s = 0.05;
  double release_faster_mps = 1.0;
  double holder_bonus_s = 1.0;
  double indirect_shots = 0;
  double penalty_on_line = 1;
  double restart_least_mps = 2.5;
  double restart_commit_rad = 0.15;
  double clear_of_placement = 1;

  // Turning with the ball. In a steady turn the dribbler holds it up to 10 rad/s (sim/README.md).
  double ball_turn_radps = 6.0;
  double ball_turn_braking_radps2 = 16.0;

  // Assignment of roles.
  double places_gap_m = 4_mm;
  double rather_beside_m = 0.1;
  double moves_on_s = 0.3;
  double worth_a_change_m = 1.0;
  double choosing_s = 0.2;
  double taker_back_m = 0.62_m;
  double before_goal_m = 1.2;
  double restart_pass_mps = 4.0;
  double block_m = 0.68_m;
  double own_wall = 2;
  double taker_loyalty_m = 0.5;
  double taker_patience_s = 3.0;
  double upfield_m = 1.0;
  double ball_loyalty_s = 0.2;
  double receiver_bonus_s = 0.6;
  double forbidden_s = 1.0;
  double next_touch_s = 2.0;
  double beside_ball_m = 0.3;
  double cover_m = 0.8;
  double contested_s = 0.5;

  // Formations of individual teams: possession's net, counter's row, zone's and shadow's positions.
  double net_widest_rad = 75_deg;
  double net_aside_rad = 20_deg;
  double net_nearest = 0.75;
  double net_from_edge_m = 0.3;
  double net_pass_mps = 3.5;
  double net_plain = 0.15;
  double net_too_near = 1.0;
  double row_behind_ball_m = 0.7;
  double row_farthest = -0.25;
  double row_deepest = -0.5;
  double row_apart_m = 0.8;
  double row_with_ball = 0.6;
  double robots_per_forward = 3;
  double zone_along = 0.45;
  double zone_across = 0.35;
  double zone_up = 0.12;
  double way_around_m = 0.25;
};

using Tunable = TunableOf<Style>;
std::span<const Tunable> tunables();

// The numbers of `style` as parameters, with its values as defaults.
std::vector<Parameter> parameters_of(const Style& style);

// `style` with the numbers set by `params`.
Style tuned(const Style& style, const std::map<std::string, double>& params);

}  // namespace autoref::strategies
