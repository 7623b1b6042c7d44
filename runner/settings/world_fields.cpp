// Settings of the simulated world and its robots.
#include "runner/settings/fields.hpp"
#include "runner/settings/settings_branch.hpp"
#include "sim/ball_presets.hpp"
#include "sim/camera_presets.hpp"
#include "sim/robot_presets.hpp"

namespace autoref::runner {
namespace {

void list_robot(sim::RobotParameters& robot, Branch to) {
  to.number("mass_kg", robot.mass_kg, {0.001, 100}, "kg", "mass of a robot");
  to.number("speed_mps", robot.speed_mps, {0.01, 20}, "m/s", "top speed");
  to.number("acceleration_mps2", robot.acceleration_mps2, positive(100), "m/s^2",
            "maximum acceleration");
  to.number("braking_mps2", robot.braking_mps2, positive(100), "m/s^2", "maximum deceleration");
  to.number("wheel_acceleration_mps2", robot.wheel_acceleration_mps2, positive(100), "m/s^2",
            "limit on each wheel's tangential acceleration");
  to.number("angular_speed_radps", robot.angular_speed_radps, {0.01, 100}, "rad/s",
            "maximum turning rate");
  to.number("angular_acceleration_radps2", robot.angular_acceleration_radps2, positive(1000),
            "rad/s^2", "maximum angular acceleration");
  to.number("front_wheels_deg", robot.front_wheels_deg, {5, 85}, "deg",
            "angle of the front wheels from the front");
  to.number("back_wheels_deg", robot.back_wheels_deg, {95, 175}, "deg",
            "angle of the back wheels from the front");
  to.number("wheel_distance_m", robot.wheel_distance_m, {0.01, 0.09}, "m",
            "distance from the robot's centre to each wheel");
  to.number("speed_noise", robot.speed_noise, {0, 0.5}, "",
            "standard deviation as a fraction of the speed");
}

void list_ball(sim::BallParameters& ball, Branch to) {
  to.preset("preset", BallPreset{&ball}, sim::ball_preset_names(),
            "sets how the ball slides, rolls and hops");
  to.number("slide_mps2", ball.slide_mps2, positive(100), "m/s^2", "deceleration when sliding");
  to.number("roll_mps2", ball.roll_mps2, positive(100), "m/s^2", "deceleration when rolling");
  to.number("roll_per_s", ball.roll_per_s, {0, 1}, "1/s",
            "additional deceleration when rolling, per m/s of speed");
  to.number("switch_ratio", ball.switch_ratio, {0.05, 0.95}, "",
            "rolls below this fraction of the kick's speed");
  to.number("hop_first_xy", ball.hop_first_xy, {0, 1}, "",
            "fraction of horizontal speed kept at the first landing");
  to.number("hop_later_xy", ball.hop_later_xy, {0, 1}, "",
            "fraction of horizontal speed kept at later landings");
  to.number("hop_first_z", ball.hop_first_z, {0, 0.95}, "",
            "fraction of vertical speed kept at the first landing");
  to.number("hop_later_z", ball.hop_later_z, {0, 0.95}, "",
            "fraction of vertical speed kept at later landings");
  to.number("rest_mps", ball.rest_mps, {0, 1}, "m/s", "at rest below this speed");
  to.number("rolls_below_hop_m", ball.rolls_below_hop_m, positive(1), "m",
            "a lower hop ends the flight");
  to.number("net_mps2", ball.net_mps2, {0, 1000}, "m/s^2", "deceleration in the goal's net");
  to.number("mass_kg", ball.mass_kg, {0.001, 1}, "kg", "mass of the ball");
  to.number("contact_friction", ball.contact_friction, {0, 2}, "",
            "friction against anything that the ball hits; changes its spin");
}

void list_contacts(sim::ContactParameters& contacts, Branch to) {
  to.number("body_restitution", contacts.body_restitution, {0, 1}, "", "ball and a robot's hull");
  to.number("plate_restitution", contacts.plate_restitution, {0, 1}, "", "ball and front plate");
  to.number("dribbling_restitution", contacts.dribbling_restitution, {0, 1}, "",
            "ball and front plate with the dribbler on");
  to.number("robot_restitution", contacts.robot_restitution, {0, 1}, "", "two robots");
  to.number("wall_restitution", contacts.wall_restitution, {0, 1}, "",
            "walls around the field and goal sides");
  to.number("net_restitution", contacts.net_restitution, {0, 1}, "", "back wall of a goal");
  to.number("bar_restitution", contacts.bar_restitution, {0, 1}, "", "ball and goal bar");
  to.number("top_restitution", contacts.top_restitution, {0, 0.95}, "",
            "fraction of vertical speed kept on top of a robot or goal");
  to.number("top_leaving_mps", contacts.top_leaving_mps, {0.05, 5}, "m/s",
            "minimum speed of a ball leaving the top of a robot or goal");
  to.number("friction", contacts.friction, {0, 2}, "", "between bodies");
  to.number("least_bounce_mps", contacts.least_bounce_mps, {0, 1}, "m/s",
            "slower impacts do not bounce");
}

void list_line_up(sim::LineUpParameters& line_up, Branch to) {
  to.number("gap_m", line_up.gap_m, {0.19, 1}, "m", "distance between robots before the game");
  to.number("from_halfway_line_m", line_up.from_halfway_line_m, {0.1, 0.35}, "m",
            "distance to the first robot");
  to.number("from_touch_line_m", line_up.from_touch_line_m, {0.1, 0.5}, "m",
            "distance to the first row");
  to.number("from_goal_line_m", line_up.from_goal_line_m, {0.1, 0.35}, "m",
            "minimum distance to the last robot");
}

void list_kicker(sim::KickerParameters& kicker, Branch to) {
  to.preset("preset", KickerPreset{&kicker}, sim::kicker_preset_names(),
            "sets all parameters of the kicker");
  to.number("reach_m", kicker.reach_m, {0, 0.1}, "m", "maximum gap between plate and ball");
  to.number("speed_limit_mps", kicker.speed_limit_mps, {0.1, 20}, "m/s",
            "top speed of straight kicks");
  to.number("chip_limit_mps", kicker.chip_limit_mps, {0.1, 20}, "m/s", "top speed of chip kicks");
  to.number("chip_angle_deg", kicker.chip_angle_deg, {5, 85}, "deg", "elevation of chip kicks");
  to.number("dead_time_s", kicker.dead_time_s, {0, 60}, "s", "minimum time between two kicks");
  to.number("speed_noise", kicker.speed_noise, {0, 0.5}, "",
            "standard deviation as a fraction of the speed");
  to.number("direction_noise_deg", kicker.direction_noise_deg, {0, 45}, "deg",
            "standard deviation");
  to.number("chip_angle_noise_deg", kicker.chip_angle_noise_deg, {0, 20}, "deg",
            "standard deviation of a chip's elevation");
}

void list_vision(sim::VisionParameters& vision, Branch to) {
  to.number("ball_noise_m", vision.ball_noise_m, {0, 0.1}, "m", "standard deviation along x and y");
  to.number("robot_noise_m", vision.robot_noise_m, {0, 0.1}, "m",
            "standard deviation along x and y");
  to.number("robot_noise_rad", vision.robot_noise_rad, {0, 0.5}, "rad",
            "standard deviation of the heading");
  to.number("ball_misses", vision.ball_misses, {0, 0.9}, "", "fraction of frames without the ball");
  to.number("robot_misses", vision.robot_misses, {0, 0.9}, "",
            "fraction of frames without a robot");
  to.yes_or_no("reports_height", vision.reports_height,
               "report the ball's height; otherwise it appears on the ground");
  to.yes_or_no("robots_hide_ball", vision.robots_hide_ball,
               "robots can hide the ball from the cameras");
  to.number("cameras", vision.cameras, {1, 4}, "",
            "4 above the field's quarters, 2 above its halves or 1 above its centre");
  to.number("camera_height_m", vision.camera_height_m, {1, 20}, "m", "height above the carpet");
  to.number("camera_overlap_m", vision.camera_overlap_m, {0, 5}, "m",
            "how far each camera sees beyond the middle lines");
  to.number("camera_error_m", vision.camera_error_m, {0, 0.1}, "m",
            "systematic error of each camera's positions, drawn for each game");
  to.number("camera_error_rad", vision.camera_error_rad, {0, 0.5}, "rad",
            "systematic error of each camera's headings");
  to.number("false_balls_per_s", vision.false_balls_per_s, {0, 10}, "1/s",
            "false balls ahead of each robot");
  to.number("misread_numbers", vision.misread_numbers, {0, 0.9}, "",
            "fraction of robot detections with a team-mate's number");
}

void list_dribbler(sim::DribblerParameters& dribbler, Branch to) {
  to.preset("preset", DribblerPreset{&dribbler}, sim::dribbler_preset_names(),
            "sets how the dribbler grips the ball");
  to.number("force_n", dribbler.force_n, {0, 100}, "N", "maximum pulling force");
  to.number("reach_m", dribbler.reach_m, {0, 0.1}, "m", "maximum gap between plate and ball");
  to.yes_or_no("holds", dribbler.holds, "keeps the ball in every motion");
  to.number("stiffness_npm", dribbler.stiffness_npm, {0, 1000}, "N/m",
            "stiffness of the pull to the plate's middle");
  to.number("damping_nspm", dribbler.damping_nspm, {0, 100}, "N s/m",
            "damping of the ball's motion along the plate");
  to.number("centring_mps", dribbler.centring_mps, {0, 5}, "m/s",
            "top speed of a held ball towards the plate's middle");
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
            "physics steps per frame of a body that can meet nothing");
  to.yes_or_no("free_motion", sim.free_motion,
               "bodies that can meet nothing move without Box2D; false: to compare");
  to.number("frame_rate_hz", sim.frame_rate_hz, {30, 240}, "1/s", "frames per second");
  to.preset("camera", CameraPreset{&sim}, sim::camera_preset_names(),
            "sets vision, frame_rate_hz, command_loss and latency_s");
  to.number("latency_s", sim.latency_s, {0, 0.5}, "s", "delay from a frame to the robots' motion");
  to.number("latency_error_s", sim.latency_error_s, {0, 0.1}, "s",
            "standard deviation of what a team believes that delay to be, drawn for each game");
  list_vision(sim.vision, Branch(list, "sim.vision."));
  Branch radio(list, "sim.radio.");
  radio.number("command_loss", sim.radio.command_loss, {0, 0.9}, "", "fraction of commands lost");
  radio.number("hold_s", sim.radio.hold_s, {0, 10}, "s",
               "a robot without a command for this long stops");
  list_ball(sim.ball, Branch(list, "sim.ball."));
  list_contacts(sim.contacts, Branch(list, "sim.contacts."));
  for (Setting& setting : settings_of(robot, "sim.")) list.push_back(std::move(setting));
  Branch placement(list, "sim.placement.");
  placement.number("speed_mps", sim.placement.speed_mps, positive(100), "m/s",
                   "speed of ball placement");
  placement.number("acceleration_mps2", sim.placement.acceleration_mps2, positive(1000), "m/s^2",
                   "acceleration of ball placement");
  placement.number("catch_mps2", sim.placement.catch_mps2, positive(1000), "m/s^2",
                   "deceleration that first stops a moving ball");
  placement.number("clearance_m", sim.placement.clearance_m, {0.025, 0.3}, "m",
                   "distance from goals to the ball's centre");
  list_line_up(sim.line_up, Branch(list, "sim.line_up."));
  return list;
}

}  // namespace autoref::runner
