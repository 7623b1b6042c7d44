#include "tests/game/lab/lab_claims.hpp"
#include "tests/checkout.hpp"

#include <fmt/format.h>

#include "tests/game/lab/lab_measures.hpp"

namespace autoref::game {
namespace {

using namespace lab_measures;

const std::string kBallSource = "default ball; closed form of the two-phase model";
const std::string kDriveSource = "the paper, section 3 (up to 3 m/s), with 3 m/s² forward";
const std::string kBrakeSource = "braking at 5 m/s², which the league's robots reach";
const std::string kModels = "ER-Force's and grSim's models";

}  // namespace

// Closed forms: a kick at 4 m/s slides (4² - 2.68²) / (2 * 3.4), then rolls 2.68² / (2 * 0.30); a
// chip at 5 m/s lands after 5² / 9.81. A pass at 3 m/s starts to roll at 2.01 m/s after 0.729 m and
// rolls another 1.578 m. The effective mass of a pulled rolling ball is 46 g / 0.67. A robot
// accelerating at a up to v covers v t - v² / (2 a) in a time t. A robot that holds its position
// with 5 m/s² against one pushing with 3 m/s² decelerates the pair at 1 m/s².
const std::vector<Claim>& lab_claims() {
  static const std::vector<Claim> claims = {
      {"sliding_distance", "sliding distance of a kick at 4 m/s", "straight-kick", 1.297, 0.02, "m",
       kBallSource, slide_m},
      {"rolling_distance", "rolling distance of that kick", "straight-kick", 11.97, 0.06, "m",
       kBallSource, roll_m},
      {"switching_speed", "speed at which that ball starts to roll", "straight-kick", 2.68, 0.02,
       "m/s", kBallSource, switch_mps},
      {"chip_distance", "distance to the first landing of a chip at 5 m/s", "chip", 2.548, 0.03,
       "m", "closed form v²/g", chip_m},
      {"first_hop_along", "horizontal speed kept at its first landing", "chip", 0.75, 0.005, "",
       "default ball", first_xy},
      {"later_hop_along", "horizontal speed kept at its second landing", "chip", 0.95, 0.005, "",
       "default ball", later_xy},
      {"hop_upwards", "vertical speed kept at its first landing", "chip", 0.5, 0.005, "",
       "default ball", hop_z},
      {"rebound_body", "speed kept when bouncing off a robot's body", "bounce-body", 0.55, 0.05, "",
       kModels, rebound_x},
      {"rebound_plate", "speed kept when bouncing off its front plate", "bounce-plate", 0.4, 0.1,
       "", kModels, rebound_x},
      {"rebound_dribbler", "the same with the dribbler running", "bounce-dribbler", 0.2, 0.03, "",
       kModels, rebound_x},
      {"rebound_wall", "speed kept when bouncing off the wall around the field", "bounce-wall", 0.3,
       0.01, "", kModels, rebound_y},
      {"rebound_post", "speed kept when bouncing off a goal post", "bounce-post", 0.3, 0.01, "",
       kModels, rebound_x},
      {"rebound_goal_back", "speed kept when bouncing off the back of a goal", "bounce-goal-back",
       0.1, 0.02, "", kModels, rebound_net},
      {"over_bar",
       "distance to the landing of a chip at 5 m/s that is 175 mm above the carpet at the goal "
       "line",
       "bar-over", 2.548, 0.03, "m", "closed form v²/g; the bar's top is at 165 mm", chip_m},
      {"under_bar", "stopping distance behind the goal line of a chip with its top at 130 mm there",
       "bar-under", 152.3, 3, "mm",
       "closed form: 180 mm - 21.5 mm - (0.1 * 5 m/s * cos 45°)² / (2 * 10 m/s²)", behind_line_mm},
      {"rebound_bar", "horizontal speed kept when the ball's centre hits the bar", "bar-hit", 0.3,
       0.03, "", kModels, rebound_flying},
      {"over_robot",
       "distance to the landing of a chip that is 166 mm above the carpet at a robot's hull",
       "chip-over-robot", 2.548, 0.03, "m", "closed form v²/g; a robot's top is at 147 mm", chip_m},
      {"into_robot", "horizontal speed kept by a chip that is 104 mm above the carpet there",
       "chip-into-robot", 0.55, 0.05, "", kModels, rebound_flying},
      {"time_to_3_mps", "time from rest to 3 m/s", "sprint", 1.0, 0.01, "s", kDriveSource,
       to_three_s},
      {"top_speed_along", "top speed forward", "sprint", 3.0, 0.005, "m/s", kDriveSource, top_mps},
      {"top_speed_across", "top speed sideways", "sidestep", 3.0, 0.005, "m/s", kDriveSource,
       top_mps},
      {"time_to_stop", "time from 3 m/s to rest", "sprint", 0.6, 0.01, "s", kBrakeSource, stop_s},
      {"way_to_stop", "braking distance from 3 m/s", "sprint", 0.9, 0.02, "m", kBrakeSource,
       stop_m},
      {"turning_up", "angular acceleration", "turn", 40, 0.5, "rad/s²", "the league's robots",
       turning_radps2},
      {"turning", "maximum angular speed", "turn", 15, 0.05, "rad/s", "the league's robots",
       turning_radps},
      {"delay", "delay from frame to motion", "delay", 83.3, 2.1, "ms",
       "five frames, as in a simulator of one of the paper's authors; rounded to one of 240 "
       "sub-steps per second",
       delay_ms},
      {"pushing", "deceleration of two robots, one pushing and one holding its position", "push",
       1.0, 0.05, "m/s²", "closed form (5 - 3) / 2", pair_mps2},
      {"robots_rebound", "speed kept when two robots collide", "head-on", 0.2, 0.02, "", kModels,
       robots_rebound},
      {"equal_pushing", "midpoint of two equal robots after pushing each other for 3 s", "head-on",
       0, 1, "mm", "symmetry", middle_mm},
      {"gentle_turn", "ball's offset from the plate's centre in a circle of 1 m at 0.8 m/s",
       "dribble-circle", 0, 10, "mm", "within the dribbler's reach", most_off_in_slow_turn_mm},
      {"hard_turn", "angular speed at which the ball is lost", "dribble-circle", 10.07, 0.7,
       "rad/s", "closed form: 0.45 N hold 46 g on a radius of 96.5 mm", loses_at_radps},
      {"gentle_pull", "ball's offset from the plate's centre when pulled back at 3 m/s²",
       "dribble-back", 2.52, 0.4, "mm", "closed form (3 + 0.30) m/s² * 46 g / 0.67 / 90 N/m",
       off_in_slow_pull_mm},
      {"most_pull", "maximum acceleration of a ball that the dribbler pulls back", "dribble-back",
       6.254, 0.05, "m/s²",
       "closed form 0.67 * 0.45 N / 46 g - 0.30 m/s²: the dribbler's limit on the carpet",
       most_pull_mps2},
      {"hard_pull", "whether the ball is lost when pulled back at 7.5 m/s² (1: yes)",
       "dribble-back", 1, 0, "", "above the dribbler's limit", is_lost_in_hard_pull},
      {"perfect_hold", "perfect dribbler: ball's offset from the plate's centre in hard motion",
       "dribble-perfect", 0, 1.5, "mm", "guaranteed by the preset", most_off_when_held_mm},
      {"perfect_energy", "perfect dribbler: how much faster than the plate the ball becomes",
       "dribble-perfect", 0, 0.03, "m/s", "guaranteed by the preset: 6 m/s² for one sub-step",
       most_faster_when_held_mps},
      {"perfect_kick", "perfect dribbler: speed of a kick at 4 m/s", "dribble-perfect", 4, 0.01,
       "m/s", "the command", kicked_mps},
      {"kick_on_the_run",
       "kick at 8 m/s by a robot that moves sideways at 2 m/s: angle to its heading",
       "kick-on-the-run", 14.04, 0.2, "°", "closed form: arctan(2 / 8)", kick_on_the_run_deg},
      {"fast_way", "distance driven by a fast robot in 2 s", "types", 5.25, 0.02, "m",
       "scenarios/robots/fast.yaml (3.5 m/s, 3.5 m/s²); closed form", fast_path_m},
      {"slow_way", "distance driven by a slow robot in 2 s", "types", 2.787, 0.02, "m",
       "scenarios/robots/slow.yaml (2.2 m/s, 1.5 m/s²); closed form", slow_path_m},
      {"pass_arrival", "speed of a 3 m/s pass when it reaches its receiver", "pass", 1.759, 0.02,
       "m/s", kBallSource, arrival_mps},
      {"pass_received", "received pass: ball's offset from the plate's centre", "pass", 0, 2, "mm",
       "the receiver's dribbler holds it", received_off_mm},
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
      "| quantity | claimed | measured | always 2 | always 4 | always 8 | source | scene | "
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

}  // namespace autoref::game
