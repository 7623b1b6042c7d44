#include "sim/configuration.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/box2d_bridge.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::sim {
namespace {

// std::to_string prints six decimals; strips the trailing zeros.
std::string text_of(double value) {
  std::string text = std::to_string(value);
  while (text.find('.') != std::string::npos && (text.back() == '0' || text.back() == '.')) {
    const bool is_point = text.back() == '.';
    text.pop_back();
    if (is_point) break;
  }
  return text;
}

[[noreturn]] void refuse(const char* name, double value, const std::string& allowed) {
  throw OutOfRange(name, " is " + text_of(value) + "; it must be " + allowed);
}

void check_range(const char* name, double value, double low, double high) {
  // Every comparison with NaN is false, so NaN is refused.
  if (value >= low && value <= high) return;
  refuse(name, value, "from " + text_of(low) + " to " + text_of(high));
}

void check_share(const char* name, double value) { check_range(name, value, 0.0, 1.0); }

void check_positive(const char* name, double value) {
  if (!std::isfinite(value) || value <= 0.0) refuse(name, value, "positive and finite");
}

void check_not_negative(const char* name, double value) {
  if (!std::isfinite(value) || value < 0.0) refuse(name, value, "0 or more, and finite");
}

void check_factor(const char* name, double value) {
  if (!(value > 0.0 && value <= 2.0)) refuse(name, value, "above 0 and at most 2");
}

void validate(const BallParameters& ball) {
  check_positive("ball.slide_mps2", ball.slide_mps2);
  check_positive("ball.roll_mps2", ball.roll_mps2);
  check_range("ball.roll_per_s", ball.roll_per_s, 0.0, 1.0);
  check_range("ball.switch_ratio", ball.switch_ratio, 0.05, 0.95);
  check_share("ball.hop_first_xy", ball.hop_first_xy);
  check_share("ball.hop_later_xy", ball.hop_later_xy);
  check_range("ball.hop_first_z", ball.hop_first_z, 0.0, 0.95);
  check_range("ball.hop_later_z", ball.hop_later_z, 0.0, 0.95);
  check_not_negative("ball.rest_mps", ball.rest_mps);
  check_positive("ball.rolls_below_hop_m", ball.rolls_below_hop_m);
  check_not_negative("ball.net_mps2", ball.net_mps2);
  check_range("ball.mass_kg", ball.mass_kg, 0.001, 1.0);
  check_range("ball.contact_friction", ball.contact_friction, 0.0, 2.0);
}

void validate(const ContactParameters& contacts) {
  check_share("contacts.body_restitution", contacts.body_restitution);
  check_share("contacts.plate_restitution", contacts.plate_restitution);
  check_share("contacts.dribbling_restitution", contacts.dribbling_restitution);
  check_share("contacts.robot_restitution", contacts.robot_restitution);
  check_share("contacts.wall_restitution", contacts.wall_restitution);
  check_share("contacts.net_restitution", contacts.net_restitution);
  check_share("contacts.bar_restitution", contacts.bar_restitution);
  check_range("contacts.top_restitution", contacts.top_restitution, 0.0, 0.95);
  check_range("contacts.top_leaving_mps", contacts.top_leaving_mps, 0.05, 5.0);
  check_range("contacts.friction", contacts.friction, 0.0, 2.0);
  check_range("contacts.least_bounce_mps", contacts.least_bounce_mps, 0.0, 1.0);
}

void validate(const DribblerParameters& dribbler) {
  check_range("dribbler.force_n", dribbler.force_n, 0.0, 100.0);
  check_range("dribbler.reach_m", dribbler.reach_m, 0.0, 0.1);
  check_range("dribbler.stiffness_npm", dribbler.stiffness_npm, 0.0, 1000.0);
  check_range("dribbler.damping_nspm", dribbler.damping_nspm, 0.0, 100.0);
  check_range("dribbler.centring_mps", dribbler.centring_mps, 0.0, 5.0);
}

void validate(const LineUpParameters& line_up) {
  // Eight robots must fit in a row on the smallest field, too.
  check_range("line_up.gap_m", line_up.gap_m, 0.19, 1.0);
  check_range("line_up.from_halfway_line_m", line_up.from_halfway_line_m, 0.1, 0.35);
  check_range("line_up.from_touch_line_m", line_up.from_touch_line_m, 0.1, 0.5);
  check_range("line_up.from_goal_line_m", line_up.from_goal_line_m, 0.1, 0.35);
}

void validate(const RobotParameters& robot) {
  check_range("robot.mass_kg", robot.mass_kg, 0.001, 100.0);  // Box2D replaces a mass of 0 by 1 kg
  check_range("robot.speed_mps", robot.speed_mps, 0.01, 20.0);
  check_positive("robot.acceleration_mps2", robot.acceleration_mps2);
  check_positive("robot.braking_mps2", robot.braking_mps2);
  check_positive("robot.wheel_acceleration_mps2", robot.wheel_acceleration_mps2);
  check_range("robot.angular_speed_radps", robot.angular_speed_radps, 0.01, 100.0);
  check_positive("robot.angular_acceleration_radps2", robot.angular_acceleration_radps2);
  check_range("robot.front_wheels_deg", robot.front_wheels_deg, 5.0, 85.0);
  check_range("robot.back_wheels_deg", robot.back_wheels_deg, 95.0, 175.0);
  check_range("robot.wheel_distance_m", robot.wheel_distance_m, 0.01, 0.09);
  check_range("robot.speed_noise", robot.speed_noise, 0.0, 0.5);
}

void validate(const KickerParameters& kicker) {
  check_range("kicker.reach_m", kicker.reach_m, 0.0, 0.1);
  check_range("kicker.speed_limit_mps", kicker.speed_limit_mps, 0.1, 20.0);
  check_range("kicker.chip_limit_mps", kicker.chip_limit_mps, 0.1, 20.0);
  check_range("kicker.chip_angle_deg", kicker.chip_angle_deg, 5.0, 85.0);
  check_range("kicker.dead_time_s", kicker.dead_time_s, 0.0, 60.0);
  check_range("kicker.speed_noise", kicker.speed_noise, 0.0, 0.5);
  check_range("kicker.direction_noise_deg", kicker.direction_noise_deg, 0.0, 45.0);
  check_range("kicker.chip_angle_noise_deg", kicker.chip_angle_noise_deg, 0.0, 20.0);
}

void validate(const VisionParameters& vision) {
  check_range("vision.ball_noise_m", vision.ball_noise_m, 0.0, 0.1);
  check_range("vision.robot_noise_m", vision.robot_noise_m, 0.0, 0.1);
  check_range("vision.robot_noise_rad", vision.robot_noise_rad, 0.0, 0.5);
  check_range("vision.ball_misses", vision.ball_misses, 0.0, 0.9);
  check_range("vision.robot_misses", vision.robot_misses, 0.0, 0.9);
  if (vision.cameras != 1 && vision.cameras != 2 && vision.cameras != 4)
    refuse("vision.cameras", vision.cameras, "1, 2 or 4");
  check_range("vision.camera_height_m", vision.camera_height_m, 1.0, 20.0);
  check_range("vision.camera_overlap_m", vision.camera_overlap_m, 0.0, 5.0);
  check_range("vision.camera_error_m", vision.camera_error_m, 0.0, 0.1);
  check_range("vision.camera_error_rad", vision.camera_error_rad, 0.0, 0.5);
  check_range("vision.false_balls_per_s", vision.false_balls_per_s, 0.0, 10.0);
  check_range("vision.misread_numbers", vision.misread_numbers, 0.0, 0.9);
}

void check_goals_end_before_walls(const Field& field) {
  constexpr double kRounding_m = 1e-9;
  const double behind_m = field.behind_goal_lines_m();
  const double deepest_m = behind_m - field.goal_wall_thickness_m;
  if (field.goal_depth_m <= deepest_m + kRounding_m) return;
  refuse("field.goal_depth_m", field.goal_depth_m,
         "at most " + text_of(deepest_m) + ", because the wall stands " + text_of(behind_m) +
             " m behind the goal line (" +
             (field.goal_line_run_off_m > 0 ? "field.goal_line_run_off_m" : "field.run_off_m") +
             ") and the goal's back is " + text_of(field.goal_wall_thickness_m) + " m thick");
}

}  // namespace

void validate(const Configuration& configuration) {
  check_range("substeps", configuration.substeps, 1, 16);
  check_range("contact_free_substeps", configuration.contact_free_substeps, 1, 16);
  check_range("frame_rate_hz", configuration.frame_rate_hz, 30.0, 240.0);
  check_range("latency_s", configuration.latency_s, 0.0, 0.5);
  check_range("latency_error_s", configuration.latency_error_s, 0.0, 0.1);
  validate(configuration.vision);
  check_range("radio.command_loss", configuration.radio.command_loss, 0.0, 0.9);
  check_range("radio.hold_s", configuration.radio.hold_s, 0.0, 10.0);
  validate(configuration.ball);
  validate(configuration.contacts);
  check_positive("placement.speed_mps", configuration.placement.speed_mps);
  check_positive("placement.acceleration_mps2", configuration.placement.acceleration_mps2);
  check_positive("placement.catch_mps2", configuration.placement.catch_mps2);
  check_range("placement.clearance_m", configuration.placement.clearance_m, 0.025, 0.3);
  validate(configuration.line_up);
}

void validate(const RobotSpec& robot) {
  validate(robot.body);
  validate(robot.kicker);
  validate(robot.dribbler);
  check_factor("speed_factor", robot.speed_factor);
  check_factor("acceleration_factor", robot.acceleration_factor);
}

void validate(const PerSide<TeamSpec>& specs) {
  for (const Side side : kSides) {
    const auto& robots = specs[side].robots;
    for (std::size_t number = 0; number < robots.size(); ++number) {
      try {
        validate(robots[number]);
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(std::string(name_of(side)) + " robot " +
                                    std::to_string(number) + ": " + error.what());
      }
    }
  }
}

void validate(const Field& field) {
  // Smaller fields have no room for 16 robots per side, larger ones exceed Box2D's range of sizes.
  check_range("field.length_m", field.length_m, 4.0, 30.0);
  check_range("field.width_m", field.width_m, 2.0, 20.0);
  // A robot that takes a free kick from a line, or comes back after a card, stands beyond it.
  check_range("field.run_off_m", field.run_off_m, 2 * kRobotRadius_m, 5.0);
  if (field.goal_line_run_off_m > 0)
    check_range("field.goal_line_run_off_m", field.goal_line_run_off_m, 2 * kRobotRadius_m, 5.0);
  check_range("field.goal_width_m", field.goal_width_m, 0.2, field.width_m - 0.4);
  check_range("field.goal_depth_m", field.goal_depth_m, 0.05, 1.0);
  check_range("field.goal_wall_thickness_m", field.goal_wall_thickness_m, 0.01, 0.1);
  check_goals_end_before_walls(field);
  check_positive("field.goal_opening_height_m", field.goal_opening_height_m);
  check_range("field.goal_bar_radius_m", field.goal_bar_radius_m, 0.001, 0.05);
  check_range("field.line_width_m", field.line_width_m, 0.0, 0.05);
  check_range("field.centre_circle_radius_m", field.centre_circle_radius_m, 0.1,
              field.half_width_m());
  // There must be room for a neutral spot between the two areas (Laws: 700 mm from both).
  check_range("field.defence_area.depth_m", field.defence_area.depth_m, 0.1,
              field.half_length_m() - 0.8);
  check_range("field.defence_area.straight_m", field.defence_area.straight_m, 0.0,
              field.width_m - 0.4);
}

double fastest_mps(const Configuration& configuration) {
  return kLongestStep_m * configuration.substeps * configuration.frame_rate_hz;
}

double fastest_mps(const RobotSpec& robot) {
  return std::max({robot.body.speed_mps * robot.speed_factor, robot.kicker.speed_limit_mps,
                   robot.kicker.chip_limit_mps});
}

}  // namespace autoref::sim
