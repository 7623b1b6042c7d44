#include "tests/runner/lab/lab_claims.hpp"
#include "tests/checkout.hpp"

#include <fmt/format.h>

#include "tests/runner/lab/lab_measures.hpp"

namespace autoref::runner {
namespace {

using namespace lab_measures;

const std::string kBallSource = "default ball; closed form of the two-phase model";
const std::string kDriveSource = "the paper, section 3 (up to 3 m/s), with 3 m/s² forward";
const std::string kBrakeSource = "braking of 5 m/s², as the league's robots reach";
const std::string kModels = "ER-Force's and grSim's models";

}  // namespace

// Closed forms, from 4 m/s: slides (4² - 2.68²) / (2 * 3.4), rolls 2.68² / (2 * 0.30); a chip of
// 5 m/s lands after 5² / 9.81. A pass of 3 m/s switches at 2.01 m/s after 0.729 m and rolls 1.578 m
// more. Pulled by a force, a rolling ball speeds up as if it weighed 46 g / 0.67. A robot that
// speeds up at a to v goes v t - v² / (2 a) in a time t. A robot pushed at 3 m/s² that holds its
// place with 5 m/s² slows the pair down at 1 m/s².
const std::vector<Claim>& lab_claims() {
  static const std::vector<Claim> claims = {
      {"sliding_distance", "sliding distance of a kick at 4 m/s", "straight-kick", 1.297, 0.02, "m",
       kBallSource, slide_m},
      {"rolling_distance", "rolling distance after it", "straight-kick", 11.97, 0.06, "m",
       kBallSource, roll_m},
      {"switching_speed", "speed at which it starts to roll", "straight-kick", 2.68, 0.02, "m/s",
       kBallSource, switch_mps},
      {"chip_distance", "first landing of a chip at 5 m/s", "chip", 2.548, 0.03, "m",
       "closed form v²/g", chip_m},
      {"first_hop_along", "speed along kept at its first landing", "chip", 0.75, 0.005, "",
       "default ball", first_xy},
      {"later_hop_along", "speed along kept at its second landing", "chip", 0.95, 0.005, "",
       "default ball", later_xy},
      {"hop_upwards", "speed upwards kept at its first landing", "chip", 0.5, 0.005, "",
       "default ball", hop_z},
      {"rebound_body", "speed kept at a robot's body", "bounce-body", 0.55, 0.05, "", kModels,
       rebound_x},
      {"rebound_plate", "speed kept at its front plate", "bounce-plate", 0.4, 0.1, "", kModels,
       rebound_x},
      {"rebound_dribbler", "the same, dribbler running", "bounce-dribbler", 0.2, 0.03, "", kModels,
       rebound_x},
      {"rebound_wall", "speed kept at the wall around the field", "bounce-wall", 0.3, 0.01, "",
       kModels, rebound_y},
      {"rebound_post", "speed kept at a goal's post", "bounce-post", 0.3, 0.01, "", kModels,
       rebound_x},
      {"rebound_goal_back", "speed kept at a goal's back", "bounce-goal-back", 0.1, 0.02, "",
       kModels, rebound_net},
      {"over_bar", "landing of a chip of 5 m/s whose lowest point is 175 mm high at the goal line",
       "bar-over", 2.548, 0.03, "m", "closed form v²/g; the bar ends at 165 mm", chip_m},
      {"under_bar", "rest behind the line of one whose top is 130 mm high there", "bar-under",
       152.3, 3, "mm", "closed form: 180 mm - 21.5 mm - (0.1 * 5 m/s * cos 45°)² / (2 * 10 m/s²)",
       behind_line_mm},
      {"rebound_bar", "speed along kept at the bar, met with the ball's middle", "bar-hit", 0.3,
       0.03, "", kModels, rebound_flying},
      {"over_robot", "landing of a chip whose lowest point is 166 mm high at a robot's hull",
       "chip-over-robot", 2.548, 0.03, "m", "closed form v²/g; a robot ends at 147 mm", chip_m},
      {"into_robot", "speed along kept by one 104 mm high there", "chip-into-robot", 0.55, 0.05, "",
       kModels, rebound_flying},
      {"time_to_3_mps", "time from rest to 3 m/s", "sprint", 1.0, 0.01, "s", kDriveSource,
       to_three_s},
      {"top_speed_along", "top speed along", "sprint", 3.0, 0.005, "m/s", kDriveSource, top_mps},
      {"top_speed_across", "top speed across", "sidestep", 3.0, 0.005, "m/s", kDriveSource,
       top_mps},
      {"time_to_stop", "time from 3 m/s to rest", "sprint", 0.6, 0.01, "s", kBrakeSource, stop_s},
      {"way_to_stop", "way from 3 m/s to rest", "sprint", 0.9, 0.02, "m", kBrakeSource, stop_m},
      {"turning_up", "turning faster", "turn", 40, 0.5, "rad/s²", "the league's robots",
       turning_radps2},
      {"turning", "fastest turning", "turn", 15, 0.05, "rad/s", "the league's robots",
       turning_radps},
      {"delay", "delay from frame to motion", "delay", 40, 2.1, "ms",
       "the league's simulators, 35 + 5 ms; to the nearest of 240 sub-steps a second", delay_ms},
      {"pushing", "a robot pushes one that holds: slowing of both", "push", 1.0, 0.05, "m/s²",
       "closed form (5 - 3) / 2", pair_mps2},
      {"robots_rebound", "speed kept when two robots meet", "head-on", 0.2, 0.02, "", kModels,
       robots_rebound},
      {"equal_pushing", "where two equal robots push each other after 3 s", "head-on", 0, 1, "mm",
       "symmetry", middle_mm},
      {"gentle_turn", "ball off the plate's middle in a circle of 1 m at 0.8 m/s", "dribble-circle",
       0, 10, "mm", "within the reach of the dribbler", most_off_in_slow_turn_mm},
      {"hard_turn", "turning that loses the ball", "dribble-circle", 10.07, 0.7, "rad/s",
       "closed form: 0.45 N carry 46 g at 96.5 mm", loses_at_radps},
      {"gentle_pull", "ball off the plate's middle when pulled back at 3 m/s²", "dribble-back",
       2.52, 0.4, "mm", "closed form (3 + 0.30) m/s² * 46 g / 0.67 / 90 N/m", off_in_slow_pull_mm},
      {"most_pull", "the most the dribbler speeds up a ball it pulls back", "dribble-back", 6.254,
       0.05, "m/s²", "closed form 0.67 * 0.45 N / 46 g - 0.30 m/s²: carry limit on the carpet",
       most_pull_mps2},
      {"hard_pull", "whether the ball is lost when pulled back at 7.5 m/s² (1: yes)",
       "dribble-back", 1, 0, "", "more than the carry limit", is_lost_in_hard_pull},
      {"perfect_hold", "perfect dribbler: ball off the plate's middle in hard motion",
       "dribble-perfect", 0, 1.5, "mm", "what the preset promises", most_off_when_held_mm},
      {"perfect_energy", "how much faster than the plate it makes the ball", "dribble-perfect", 0,
       0.03, "m/s", "what the preset promises: 6 m/s² for a sub-step", most_faster_when_held_mps},
      {"perfect_kick", "speed of a 4 m/s kick out of it", "dribble-perfect", 4, 0.01, "m/s",
       "the order", kicked_mps},
      {"fast_way", "way of a fast robot in 2 s", "types", 5.25, 0.02, "m",
       "scenarios/robots/fast.yaml (3.5 m/s, 3.5 m/s²); closed form", fast_path_m},
      {"slow_way", "way of a slow robot in 2 s", "types", 2.787, 0.02, "m",
       "scenarios/robots/slow.yaml (2.2 m/s, 1.5 m/s²); closed form", slow_path_m},
      {"pass_arrival", "speed of a 3 m/s pass at its receiver", "pass", 1.759, 0.02, "m/s",
       kBallSource, arrival_mps},
      {"pass_received", "received pass: ball off the plate's middle", "pass", 0, 2, "mm",
       "the receiver's dribbler keeps it", received_off_mm},
  };
  return claims;
}

std::string lab_file(const std::string& scene) {
  return in_checkout("scenarios/lab/" + scene + ".yaml");
}

double measured(const Claim& claim) {
  return claim.measure(play_lab_scene(read_lab_scene(lab_file(claim.scene))));
}

double measured_with(const Claim& claim, int substeps) {
  LabScene scene = read_lab_scene(lab_file(claim.scene));
  scene.sim.substeps = substeps;
  scene.sim.contact_free_substeps = substeps;
  return claim.measure(play_lab_scene(scene));
}

std::string lab_table() {
  std::string text =
      "| what | claimed | measured | always 2 | always 4 | always 8 | whose number | scene | "
      "test `Lab/LabClaim.*/` |\n|---|---|---|---|---|---|---|---|---|\n";
  for (const Claim& claim : lab_claims()) {
    const std::string unit = claim.unit.empty() ? "" : " " + claim.unit;
    text += fmt::format(
        "| {} | {:.4g} ± {:.2g}{} | {:.4g} | {:.4g} | {:.4g} | {:.4g} | {} | {} | `{}` |\n",
        claim.what, claim.claimed, claim.tolerance, unit, measured(claim), measured_with(claim, 2),
        measured_with(claim, 4), measured_with(claim, 8), claim.source, claim.scene, claim.name);
  }
  return text;
}

}  // namespace autoref::runner
