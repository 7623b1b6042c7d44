// The strong team. It dribbles at the goal as far as it may, passes only where that is better, and
// covers the goal with wall and keeper together.
#include "strategies/skills/ease_off.hpp"
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

// Nearly rules out crashes and pushes where they bring cards.
void approach_gently(Style& style) {
  const Easing easing;
  style.card_ease_from_m = easing.from_m;
  style.card_gentle_mps = easing.gentle_mps;
  style.card_ease_mps2 = easing.braking_mps2;
  style.contact_mps = 0;
}

}  // namespace

TeamPlaybook cobalt_playbook() {
  Style style;
  attack(style);
  defend(style);
  approach_gently(style);
  return {style};
}

}  // namespace autoref::strategies
