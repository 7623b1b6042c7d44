// The strong team. It dribbles at the goal at once, passes only where that is better, and covers
// the goal with wall and keeper together.
#include "strategies/teams/playbooks.hpp"

namespace autoref::strategies {
namespace {

// Going forward with the ball.
void attack(Style& style) {
  style.carry = 2.0;
  style.carry_worth = 0.45;
  style.limited_carry = 0.55;
  style.carry_mps = 1.9;
  style.shyness = 0.6;
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
  style.mark_ball_side = 0.85;
  style.large_team = 1;
}

void avoid_fouls(Style& style) {
  style.area_margin_m = 0.05;
  style.around_boxes = 1;
  style.area_braking_mps2 = 1.5;
  style.from_their_area_m = 0.15;
  style.from_own_area_m = 0.2;
  style.keeper_area_margin_m = 0.15;
  style.ball_margin_m = 0.06;
  style.contact_mps = 0;
  style.card_ease_from_m = 1.2;
  style.card_gentle_mps = 0.2;
  style.card_ease_mps2 = 1.2;
  style.dribble_gap_m = 0.03;
  style.hasty_share = 0.5;
  style.release_rad = 3.0;
  style.penalty_on_line = 1;
  style.restart_least_mps = 2.5;
  style.restart_commit_rad = 0.15;
  style.clear_of_placement = 1;
}

}  // namespace

TeamPlaybook cobalt_playbook() {
  Style style;
  attack(style);
  defend(style);
  avoid_fouls(style);
  return {style};
}

}  // namespace autoref::strategies
