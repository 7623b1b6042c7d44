// The strong team. It takes a clear shot if there is one, otherwise the most valuable pass, dribble
// or clearance; a kick for which it may not have time to turn is worth less. Wall and keeper cover
// the goal together.
#include "strategies/skills/limits.hpp"
#include "strategies/teams/playbooks.hpp"

namespace autoref::strategies {
namespace {

// Cobalt takes less care to avoid fouls than the other teams.
void avoid_few_fouls(Style& style) {
  style.area_margin_m = 0;
  style.around_boxes = false;
  style.area_braking_mps2 = 0;
  style.from_their_area_m = 0.1;
  style.from_own_area_m = 0.12;
  style.keeper_area_margin_m = 30_mm;
  style.ball_margin_m = 0;
  style.contact_mps = 3.0;
  style.dribble_gap_m = 0;
  style.hasty_share = 0;
  style.release_rad = 1.5;
  style.release_lead_s = 0;
  style.release_faster_mps = 0;
  style.holder_bonus_s = 0;
  style.indirect_shots = true;
  style.penalty_on_line = false;
  style.restart_least_mps = 0;
  style.restart_commit_rad = 0;
  style.clear_of_placement = false;
  style.narrow_wall = false;
}

// These values were fitted in games of cobalt against itself, with six robots per team, under the
// rules 2014 and 2026-b. Larger dribbling shares win no more games, and lead to fouls more often.
void fit(Style& style) {
  style.late_cost = 0.35;
  style.pass_arrival_mps = 3.6;
  style.pass_tolerance_rad = 0.035;
  style.turn_nll = 0.05;
  style.dribbling_share = 0.6;
  style.hasty_share = 0.7;
  style.clear_mps = 3.6;
  style.clear_worth = 0.11;
  style.fight_m = 0.7;
  style.receivers_apart_m = 1.6;
  style.receiver_loyalty = 0.12;
  style.far_cost_per_m = 0.02;
  style.line_m = 0.2;
  style.width = 0.95;
  style.mark_ball_side = 0.6;
}

// Parameters for going forward with the ball.
void attack(Style& style) {
  style.carry = 2.0;
  style.carry_worth = 0.45;
  style.limited_carry = 0.55;
  style.carry_mps = 1.9;
  style.avoid_opponents = 0.6;
  style.choice_loyalty = 0.12;
  style.receiver_hold_frames = 10;
  style.dribbled_restart = 0.4;
  style.ball_turn_radps = 8.5;
  style.ball_turn_braking_radps2 = 28;
}

void defend(Style& style) {
  style.keeper_fills_gap = 1;
  style.anticipation = 0.3;
  style.threat_lead_s = 0.25;
  style.block_lead_s = 0.12;
  style.mark_m = 0.35;
  style.large_team = true;
}

// These values nearly rule out crashes and pushes if these bring cards.
void approach_gently(Style& style) {
  const Easing easing;
  style.card_ease_from_m = easing.from_m;
  style.card_gentle_mps = easing.gentle_mps;
  style.card_ease_mps2 = easing.braking_mps2;
  style.contact_mps = 0;
}

}  // namespace

// The previous cobalt, kept for comparison; its parameters must not change.
TeamPlaybook cobalt1_playbook() {
  Style style;
  avoid_few_fouls(style);
  return {style};
}

TeamPlaybook cobalt_playbook() {
  Style style;
  attack(style);
  defend(style);
  fit(style);
  approach_gently(style);
  return {style};
}

}  // namespace autoref::strategies
