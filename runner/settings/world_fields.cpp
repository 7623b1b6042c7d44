// The settings of the simulated world and its robots.
#include "runner/settings/fields.hpp"
#include "runner/settings/settings_branch.hpp"
#include "sim/ball_presets.hpp"
#include "sim/camera_presets.hpp"
#include "sim/dribbler_presets.hpp"

namespace autoref::runner {
namespace {

void list_robot(sim::RobotParameters& robot, Branch to) {
  to.number("mass_kg", robot.mass_kg, {0.001, 100}, "kg", "of a robot");
  to.number("speed_mps", robot.speed_mps, {0.01, 20}, "m/s", "top speed");
  to.number("acceleration_mps2", robot.acceleration_mps2, positive(100), "m/s^2", "speeding up");
  to.number("braking_mps2", robot.braking_mps2, positive(100), "m/s^2", "slowing down");
  to.number("wheel_acceleration_mps2", robot.wheel_acceleration_mps2, positive(100), "m/s^2",
            "each wheel's tangential limit");
  to.number("angular_speed_radps", robot.angular_speed_radps, {0.01, 100}, "rad/s", "turning");
  to.number("angular_acceleration_radps2", robot.angular_acceleration_radps2, positive(1000),
            "rad/s^2", "of turning");
  to.number("front_wheels_deg", robot.front_wheels_deg, {5, 85}, "deg", "from the front");
  to.number("back_wheels_deg", robot.back_wheels_deg, {95, 175}, "deg", "from the front");
  to.number("wheel_distance_m", robot.wheel_distance_m, {0.01, 0.09}, "m",
            "from the robot's centre to each wheel");
  to.number("speed_noise", robot.speed_noise, {0, 0.5}, "", "share of a speed, one deviation");
}

void list_ball(sim::BallParameters& ball, Branch to) {
  to.preset("preset", BallPreset{&ball}, sim::ball_preset_names(),
            "sets how it slides, rolls and hops");
  to.number("slide_mps2", ball.slide_mps2, positive(100), "m/s^2", "deceleration when sliding");
  to.number("roll_mps2", ball.roll_mps2, positive(100), "m/s^2", "deceleration when rolling");
  to.number("switch_ratio", ball.switch_ratio, {0.05, 0.95}, "", "rolls below this share");
  to.number("hop_first_xy", ball.hop_first_xy, {0, 1}, "", "speed kept at the first landing");
  to.number("hop_later_xy", ball.hop_later_xy, {0, 1}, "", "speed kept at later landings");
  to.number("hop_z", ball.hop_z, {0, 0.95}, "", "upward speed kept at a landing");
  to.number("rest_mps", ball.rest_mps, {0, 1}, "m/s", "at rest below");
  to.number("rolls_below_hop_m", ball.rolls_below_hop_m, positive(1), "m", "no lower hops");
  to.number("net_mps2", ball.net_mps2, {0, 1000}, "m/s^2", "what the goal's net takes");
  to.number("mass_kg", ball.mass_kg, {0.001, 1}, "kg", "of the ball");
  to.number("contact_friction", ball.contact_friction, {0, 2}, "",
            "with what it hits, which takes spin");
}

void list_contacts(sim::ContactParameters& contacts, Branch to) {
  to.number("body_restitution", contacts.body_restitution, {0, 1}, "", "ball and a robot's hull");
  to.number("plate_restitution", contacts.plate_restitution, {0, 1}, "", "ball and front plate");
  to.number("dribbling_restitution", contacts.dribbling_restitution, {0, 1}, "",
            "ball and front plate with the dribbler on");
  to.number("robot_restitution", contacts.robot_restitution, {0, 1}, "", "two robots");
  to.number("wall_restitution", contacts.wall_restitution, {0, 1}, "",
            "walls around the field and goal sides");
  to.number("net_restitution", contacts.net_restitution, {0, 1}, "", "a goal's back");
  to.number("bar_restitution", contacts.bar_restitution, {0, 1}, "", "ball and goal bar");
  to.number("top_restitution", contacts.top_restitution, {0, 0.95}, "",
            "upward speed kept on top of a robot or goal");
  to.number("top_leaving_mps", contacts.top_leaving_mps, {0.05, 5}, "m/s",
            "least speed of a ball off the top of a robot or goal");
  to.number("friction", contacts.friction, {0, 2}, "", "between bodies");
  to.number("least_bounce_mps", contacts.least_bounce_mps, {0, 1}, "m/s",
            "slower hits do not bounce");
}

void list_line_up(sim::LineUpParameters& line_up, Branch to) {
  to.number("gap_m", line_up.gap_m, {0.19, 1}, "m", "between robots before the game");
  to.number("from_halfway_line_m", line_up.from_halfway_line_m, {0.1, 0.35}, "m",
            "to the first robot");
  to.number("from_touch_line_m", line_up.from_touch_line_m, {0.1, 0.5}, "m", "to the first row");
  to.number("from_goal_line_m", line_up.from_goal_line_m, {0.1, 0.35}, "m",
            "to the last robot, at least");
}

void list_kicker(sim::KickerParameters& kicker, Branch to) {
  to.number("reach_m", kicker.reach_m, {0, 0.1}, "m", "from the plate to the ball's surface");
  to.number("speed_limit_mps", kicker.speed_limit_mps, {0.1, 20}, "m/s", "of straight kicks");
  to.number("chip_limit_mps", kicker.chip_limit_mps, {0.1, 20}, "m/s", "of chip kicks");
  to.number("chip_angle_deg", kicker.chip_angle_deg, {5, 85}, "deg", "of chip kicks");
  to.number("dead_time_s", kicker.dead_time_s, {0, 60}, "s", "between two kicks");
  to.number("speed_noise", kicker.speed_noise, {0, 0.5}, "", "share of the speed, one deviation");
  to.number("direction_noise_deg", kicker.direction_noise_deg, {0, 45}, "deg", "one deviation");
}

void list_vision(sim::VisionParameters& vision, Branch to) {
  to.number("ball_noise_m", vision.ball_noise_m, {0, 0.1}, "m", "one deviation, along x and y");
  to.number("robot_noise_m", vision.robot_noise_m, {0, 0.1}, "m", "one deviation, along x and y");
  to.number("robot_noise_rad", vision.robot_noise_rad, {0, 0.5}, "rad", "one deviation, heading");
  to.number("ball_misses", vision.ball_misses, {0, 0.9}, "", "share of frames without the ball");
  to.number("robot_misses", vision.robot_misses, {0, 0.9}, "", "share of frames without a robot");
  to.yes_or_no("reports_height", vision.reports_height,
               "of the ball; else it is seen on the ground");
  to.yes_or_no("robots_hide_ball", vision.robots_hide_ball, "from the cameras");
  to.number("camera_height_m", vision.camera_height_m, {1, 20}, "m", "above the carpet");
  to.number("camera_overlap_m", vision.camera_overlap_m, {0, 5}, "m",
            "seen beyond the middle lines by each camera");
}

void list_dribbler(sim::DribblerParameters& dribbler, Branch to) {
  to.preset("preset", DribblerPreset{&dribbler}, sim::dribbler_preset_names(),
            "sets how it has the ball");
  to.number("force_n", dribbler.force_n, {0, 100}, "N", "the most it pulls with");
  to.number("reach_m", dribbler.reach_m, {0, 0.1}, "m", "from the plate to the ball");
  to.yes_or_no("holds", dribbler.holds, "keeps the ball in every motion");
  to.number("stiffness_npm", dribbler.stiffness_npm, {0, 1000}, "N/m",
            "of the pull to the plate's middle");
  to.number("damping_nspm", dribbler.damping_nspm, {0, 100}, "N s/m",
            "of the ball's motion along the plate");
  to.number("centring_mps", dribbler.centring_mps, {0, 5}, "m/s",
            "of a held ball to the plate's middle, at most");
}

}  // namespace

std::vector<Setting> settings_of(sim::RobotSpec& robot, const std::string& prefix) {
  std::vector<Setting> list;
  list_robot(robot.body, Branch(list, prefix + "robot."));
  list_kicker(robot.kicker, Branch(list, prefix + "kicker."));
  list_dribbler(robot.dribbler, Branch(list, prefix + "dribbler."));
  return list;
}

std::vector<Setting> settings_of(sim::Configuration& sim, sim::RobotSpec& robot) {
  std::vector<Setting> list;
  Branch to(list, "sim.");
  to.number("substeps", sim.substeps, {1, 16}, "", "physics steps per frame");
  to.number("contact_free_substeps", sim.contact_free_substeps, {1, 16}, "",
            "and while nothing can meet anything");
  to.number("frame_rate_hz", sim.frame_rate_hz, {30, 240}, "1/s", "frames per second");
  to.preset("camera", CameraPreset{&sim}, sim::camera_preset_names(),
            "sets vision, command_loss and latency_s");
  to.number("latency_s", sim.latency_s, {0, 0.5}, "s", "from a frame to the robots' motion");
  list_vision(sim.vision, Branch(list, "sim.vision."));
  Branch radio(list, "sim.radio.");
  radio.number("command_loss", sim.radio.command_loss, {0, 0.9}, "", "share of commands lost");
  radio.number("hold_s", sim.radio.hold_s, {0, 10}, "s", "stops without a command for so long");
  list_ball(sim.ball, Branch(list, "sim.ball."));
  list_contacts(sim.contacts, Branch(list, "sim.contacts."));
  for (Setting& setting : settings_of(robot, "sim.")) list.push_back(std::move(setting));
  Branch placement(list, "sim.placement.");
  placement.number("speed_mps", sim.placement.speed_mps, positive(100), "m/s",
                   "of the ball placement");
  placement.number("acceleration_mps2", sim.placement.acceleration_mps2, positive(1000), "m/s^2",
                   "of the ball placement");
  placement.number("catch_mps2", sim.placement.catch_mps2, positive(1000), "m/s^2",
                   "what a moving ball loses first");
  placement.number("clearance_m", sim.placement.clearance_m, {0.025, 0.3}, "m",
                   "from goals to the ball's centre");
  list_line_up(sim.line_up, Branch(list, "sim.line_up."));
  return list;
}

}  // namespace autoref::runner
