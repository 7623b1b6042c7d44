#include "tests/runner/lab_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "soccer/robot_shape.hpp"

namespace autoref::runner {
namespace {

using sim::BallState;
using sim::RobotState;
using sim::WorldState;

constexpr double kFrame_s = 1.0 / 60;
constexpr double kSlide_mps2 = 3.4;
constexpr double kRoll_mps2 = 0.30;
constexpr double kNet_mps2 = 10.0;  // what the net takes besides
constexpr double kG_mps2 = 9.81;

const RobotState& west(const WorldState& state, std::size_t number = 0) {
  return state.robots[Side::kWest][number];
}
const RobotState& east(const WorldState& state) { return state.robots[Side::kEast][0]; }

// The first frame, from the second on, for which `holds`.
std::size_t first_frame(const LabRecord& record,
                        const std::function<bool(const WorldState&, const WorldState&)>& holds) {
  for (std::size_t f = 1; f < record.states.size(); ++f) {
    if (holds(record.states[f - 1], record.states[f])) return f;
  }
  throw std::runtime_error("what was to be measured never happened");
}

// Where and how fast the ball began to roll, between the frames that show it sliding and rolling.
struct Switch {
  double way_m = 0;
  double speed_mps = 0;
};

Switch switch_of(const LabRecord& record) {
  const std::size_t f = first_frame(record, [](const WorldState&, const WorldState& now) {
    return now.ball.is_rolling && now.ball.velocity_mps.x() > 0.0;
  });
  const BallState& slides = record.states[f - 1].ball;
  const BallState& rolls = record.states[f].ball;
  const double v_mps = slides.velocity_mps.x();
  const double after_s =
      (v_mps - rolls.velocity_mps.x() - kRoll_mps2 * kFrame_s) / (kSlide_mps2 - kRoll_mps2);
  const double start_m = record.states[0].ball.position_m.x();
  return {slides.position_m.x() + v_mps * after_s - kSlide_mps2 * after_s * after_s / 2 - start_m,
          v_mps - kSlide_mps2 * after_s};
}

double slide_m(const LabRecord& record) { return switch_of(record).way_m; }
double switch_mps(const LabRecord& record) { return switch_of(record).speed_mps; }
double roll_m(const LabRecord& record) {
  return record.states.back().ball.position_m.x() - record.states[0].ball.position_m.x() -
         slide_m(record);
}

// The speed with which a flying ball meets the carpet, or left it.
double carpet_mps(const BallState& ball) {
  return std::sqrt(ball.vertical_mps * ball.vertical_mps + 2 * kG_mps2 * ball.height_m);
}

// The frame after landing number `count`, from 1.
std::size_t frame_after_landing(const LabRecord& record, int count) {
  return first_frame(record, [&count](const WorldState& former, const WorldState& now) {
    const bool lands = former.ball.vertical_mps < 0.0 && now.ball.vertical_mps > 0.0;
    return lands && --count == 0;
  });
}

double chip_m(const LabRecord& record) {
  const BallState& last = record.states[frame_after_landing(record, 1) - 1].ball;
  const double falls_s = (last.vertical_mps + carpet_mps(last)) / kG_mps2;
  return last.position_m.x() + last.velocity_mps.x() * falls_s -
         record.states[0].ball.position_m.x();
}

double kept_xy(const LabRecord& record, int landing) {
  const std::size_t f = frame_after_landing(record, landing);
  return record.states[f].ball.velocity_mps.x() / record.states[f - 1].ball.velocity_mps.x();
}
double first_xy(const LabRecord& record) { return kept_xy(record, 1); }
double later_xy(const LabRecord& record) { return kept_xy(record, 2); }

double hop_z(const LabRecord& record) {
  const std::size_t f = frame_after_landing(record, 1);
  return carpet_mps(record.states[f].ball) / carpet_mps(record.states[f - 1].ball);
}

// Share of its speed that a ball keeps: from the frames around the bounce, less what the carpet
// takes before it and `loses_mps2` after it.
double rebound(const LabRecord& record, int axis, double loses_mps2 = kSlide_mps2) {
  const std::size_t f =
      first_frame(record, [axis](const WorldState& former, const WorldState& now) {
        return former.ball.velocity_mps[axis] > 0.0 && now.ball.velocity_mps[axis] < 0.0;
      });
  const BallState& last = record.states[f - 1].ball;
  const BallState& first = record.states[f].ball;
  const double to_mps = last.velocity_mps[axis];
  const double from_mps = first.velocity_mps[axis];
  const double after_s =
      (first.position_m[axis] - last.position_m[axis] - from_mps * kFrame_s) / (to_mps - from_mps);
  return (-from_mps + loses_mps2 * (kFrame_s - after_s)) / (to_mps - kSlide_mps2 * after_s);
}
double rebound_x(const LabRecord& record) { return rebound(record, 0); }
double rebound_net(const LabRecord& record) { return rebound(record, 0, kSlide_mps2 + kNet_mps2); }
double rebound_y(const LabRecord& record) { return rebound(record, 1); }

// The same in the air, where nothing else slows the ball.
double rebound_flying(const LabRecord& record) {
  const std::size_t f = first_frame(record, [](const WorldState& former, const WorldState& now) {
    return former.ball.velocity_mps.x() > 0.0 && now.ball.velocity_mps.x() < 0.0;
  });
  return -record.states[f].ball.velocity_mps.x() / record.states[f - 1].ball.velocity_mps.x();
}

double behind_line_mm(const LabRecord& record) {
  return 1000 * (record.states.back().ball.position_m.x() - Field{}.half_length_m());
}

// From the first motion to the first frame at the speed, by the speed in the frame before.
double to_three_s(const LabRecord& record) {
  const std::size_t f = first_frame(record, [](const WorldState&, const WorldState& now) {
    return west(now).velocity_mps.norm() > 2.999;
  });
  const double missing_mps = 3.0 - west(record.states[f - 1]).velocity_mps.norm();
  return static_cast<double>(f - 1) * kFrame_s + missing_mps / 3.0;
}

double top_mps(const LabRecord& record) {
  double top = 0.0;
  for (const WorldState& state : record.states) {
    top = std::max(top, west(state).velocity_mps.norm());
  }
  return top;
}

constexpr std::size_t kStopOrder = 75;  // frame of the order to stop, at 1.25 s

double stop_s(const LabRecord& record) {
  std::size_t f = kStopOrder;
  while (west(record.states[f + 1]).velocity_mps.norm() > 1e-3) ++f;
  return static_cast<double>(f - kStopOrder) * kFrame_s +
         west(record.states[f]).velocity_mps.norm() / 5.0;
}

double stop_m(const LabRecord& record) {
  return (west(record.states.back()).position_m - west(record.states[kStopOrder]).position_m)
      .norm();
}

double turning_radps2(const LabRecord& record) {
  return west(record.states[12]).angular_velocity_radps / (12 * kFrame_s);
}
double turning_radps(const LabRecord& record) {
  return west(record.states[60]).angular_velocity_radps;
}

// A robot that speeds up evenly began to move where its speed, drawn backwards, is zero.
double delay_ms(const LabRecord& record) {
  const std::size_t last = record.states.size() - 1;
  const double first_mps = west(record.states[last - 6]).velocity_mps.x();
  const double mps = west(record.states[last]).velocity_mps.x();
  const double mps2 = (mps - first_mps) / (6 * kFrame_s);
  return 1000 * (static_cast<double>(last) * kFrame_s - mps / mps2 - 0.1);
}

// Both robots once they are together, by their mean speed from 0.95 to 1.15 s.
double pair_mps2(const LabRecord& record) {
  const auto mean_mps = [&](std::size_t f) {
    const WorldState& state = record.states[f];
    return (west(state).velocity_mps.x() + east(state).velocity_mps.x()) / 2;
  };
  return (mean_mps(57) - mean_mps(69)) / (12 * kFrame_s);
}

// Of the speed towards each other. Both brake at once, at 5 m/s^2, what throws them apart.
double robots_rebound(const LabRecord& record) {
  const std::size_t f = first_frame(record, [](const WorldState& former, const WorldState& now) {
    return west(former).velocity_mps.x() > 0.0 && west(now).velocity_mps.x() < 0.0;
  });
  const RobotState& last = west(record.states[f - 1]);
  const RobotState& first = west(record.states[f]);
  const double to_mps = last.velocity_mps.x();
  const double from_mps = first.velocity_mps.x();
  const double after_s =
      (first.position_m.x() - last.position_m.x() - from_mps * kFrame_s) / (to_mps - from_mps);
  return (-from_mps + 5.0 * (kFrame_s - after_s)) / to_mps;
}

double middle_mm(const LabRecord& record) {
  const WorldState& end = record.states.back();
  return 500 * (west(end).position_m.x() + east(end).position_m.x());
}

// From the plate's middle to where a ball lies at it.
double off_plate_mm(const WorldState& state, std::size_t robot) {
  const RobotState& its = west(state, robot);
  const Vec2 place_m = its.position_m + its.heading * (kFrontDistance_m + kBallRadius_m);
  return 1000 * (state.ball.position_m - place_m).norm();
}

constexpr std::size_t kHardTurn = 360;  // frame of the order to turn hard, at 6 s

double most_off_in_gentle_turn_mm(const LabRecord& record) {
  double most = 0.0;
  for (std::size_t f = 0; f <= kHardTurn; ++f) {
    most = std::max(most, off_plate_mm(record.states[f], 0));
  }
  return most;
}

// How fast the robot turned when the ball had left the reach of the dribbler.
double loses_at_radps(const LabRecord& record) {
  std::size_t f = kHardTurn;
  while (off_plate_mm(record.states.at(f), 0) < 10.0) ++f;
  return west(record.states[f]).angular_velocity_radps;
}

constexpr std::size_t kEvenPull = 36;   // frame in the midst of the gentle pull, at 0.6 s
constexpr std::size_t kHardPull = 108;  // frame of the order to pull hard, at 1.8 s

double off_in_gentle_pull_mm(const LabRecord& record) {
  return off_plate_mm(record.states[kEvenPull], 0);
}

// Of the ball, where the dribbler pulls as hard as it can: from 5 mm off to the end of its reach.
double most_pull_mps2(const LabRecord& record) {
  std::size_t f = kHardPull;
  while (off_plate_mm(record.states.at(f), 0) < 5.0) ++f;
  std::size_t last = f;
  while (off_plate_mm(record.states.at(last + 1), 0) < 10.0) ++last;
  return (record.states[f].ball.velocity_mps.x() - record.states[last].ball.velocity_mps.x()) /
         (static_cast<double>(last - f) * kFrame_s);
}

double is_lost_in_hard_pull(const LabRecord& record) {
  return off_plate_mm(record.states.back(), 0) > 100.0 ? 1.0 : 0.0;
}

constexpr std::size_t kKickOrder = 348;  // frame of the order to kick, at 5.8 s

double most_off_when_held_mm(const LabRecord& record) {
  double most = 0.0;
  for (std::size_t f = 0; f <= kKickOrder; ++f) {
    most = std::max(most, off_plate_mm(record.states[f], 0));
  }
  return most;
}

double plate_mps(const WorldState& state) {
  const RobotState& its = west(state);
  const Vec2 arm_m = state.ball.position_m - its.position_m;
  return (its.velocity_mps + its.angular_velocity_radps * left_of(arm_m)).norm();
}

// How much faster than the plate the ball gets, now or a frame ago.
double most_faster_when_held_mps(const LabRecord& record) {
  double most = 0.0;
  for (std::size_t f = 1; f <= kKickOrder; ++f) {
    const double plates_mps =
        std::max(plate_mps(record.states[f - 1]), plate_mps(record.states[f]));
    most = std::max(most, record.states[f].ball.velocity_mps.norm() - plates_mps);
  }
  return most;
}

double kicked_mps(const LabRecord& record) {
  return record.states[kKickOrder + 1].ball.velocity_mps.norm() + kSlide_mps2 * kFrame_s;
}

double way_m(const LabRecord& record, std::size_t robot) {
  return (west(record.states.back(), robot).position_m - west(record.states[0], robot).position_m)
      .norm();
}
double fast_way_m(const LabRecord& record) { return way_m(record, 0); }
double slow_way_m(const LabRecord& record) { return way_m(record, 1); }

double arrival_mps(const LabRecord& record) {
  const std::size_t f = first_frame(record, [](const WorldState& former, const WorldState& now) {
    return former.ball.is_rolling && former.ball.velocity_mps.x() > 1.0 &&
           now.ball.velocity_mps.x() < 1.0;
  });
  return record.states[f - 1].ball.velocity_mps.x();
}

double received_off_mm(const LabRecord& record) { return off_plate_mm(record.states.back(), 1); }

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
      {"under_bar", "rest behind the line of one whose top is 130 mm high there", "bar-under", 90,
       68, "mm", "within the goal of 180 mm; the bar begins at 155 mm", behind_line_mm},
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
      {"delay", "delay from picture to motion", "delay", 40, 2.1, "ms",
       "the league's simulators, 35 + 5 ms; to the nearest of 240 sub-steps a second", delay_ms},
      {"pushing", "a robot pushes one that holds: slowing of both", "push", 1.0, 0.05, "m/s²",
       "closed form (5 - 3) / 2", pair_mps2},
      {"robots_rebound", "speed kept when two robots meet", "head-on", 0.2, 0.02, "", kModels,
       robots_rebound},
      {"equal_pushing", "where two equal robots push each other after 3 s", "head-on", 0, 1, "mm",
       "symmetry", middle_mm},
      {"gentle_turn", "ball off the plate's middle in a circle of 1 m at 0.8 m/s", "dribble-circle",
       0, 10, "mm", "within the reach of the dribbler", most_off_in_gentle_turn_mm},
      {"hard_turn", "turning that loses the ball", "dribble-circle", 10.07, 0.7, "rad/s",
       "closed form: 0.45 N carry 46 g at 96.5 mm", loses_at_radps},
      {"gentle_pull", "ball off the plate's middle when pulled back at 3 m/s²", "dribble-back",
       2.52, 0.4, "mm", "closed form (3 + 0.30) m/s² * 46 g / 0.67 / 90 N/m",
       off_in_gentle_pull_mm},
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
       "scenarios/robots/fast.yaml (3.5 m/s, 3.5 m/s²); closed form", fast_way_m},
      {"slow_way", "way of a slow robot in 2 s", "types", 2.787, 0.02, "m",
       "scenarios/robots/slow.yaml (2.2 m/s, 1.5 m/s²); closed form", slow_way_m},
      {"pass_arrival", "speed of a 3 m/s pass at its receiver", "pass", 1.759, 0.02, "m/s",
       kBallSource, arrival_mps},
      {"pass_received", "received pass: ball off the plate's middle", "pass", 0, 2, "mm",
       "the receiver's dribbler keeps it", received_off_mm},
  };
  return claims;
}

std::string lab_file(const std::string& scene) {
  return AUTOREF_SOURCE_DIR "/scenarios/lab/" + scene + ".yaml";
}

double measured(const Claim& claim) {
  return claim.measure(play_lab_scene(read_lab_scene(lab_file(claim.scene))));
}

double measured_with(const Claim& claim, int substeps) {
  LabScene scene = read_lab_scene(lab_file(claim.scene));
  scene.sim.substeps = substeps;
  scene.sim.calm_substeps = substeps;
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
