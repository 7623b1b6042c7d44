// The previous cobalt, kept for comparison: its numbers must not change.
#include "strategies/teams/playbooks.hpp"

namespace autoref::strategies {
namespace {

// Takes less care to avoid fouls than the other teams.
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
}

}  // namespace

TeamPlaybook cobalt1_playbook() {
  Style style;
  avoid_few_fouls(style);
  return {style};
}

}  // namespace autoref::strategies
