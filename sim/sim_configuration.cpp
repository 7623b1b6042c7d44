#include "sim/sim_configuration.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <stdexcept>
#include <string>

#include "sim/box2d_bridge.hpp"

namespace autoref::sim {
namespace {

void check_at_most(const std::string& path, double value, double most) {
  if (!(value <= most)) refuse_value(path, value, fmt::format("at most {:.6g}", most));
}

void check_goals_end_before_walls(const Field& field) {
  constexpr double kRounding_m = 1e-9;
  const double behind_m = field.behind_goal_lines_m();
  const double deepest_m = behind_m - field.goal_wall_thickness_m;
  if (field.goal_depth_m <= deepest_m + kRounding_m) return;
  refuse_value(
      "field.goal_depth_m", field.goal_depth_m,
      fmt::format("at most {:.6g}, because the wall stands {:.6g} m behind the goal line ({}) and "
                  "the goal's back is {:.6g} m thick",
                  deepest_m, behind_m,
                  field.goal_line_run_off_m > 0 ? "field.goal_line_run_off_m" : "field.run_off_m",
                  field.goal_wall_thickness_m));
}

}  // namespace

void validate(const Configuration& configuration) {
  const int cameras = configuration.vision.cameras;
  if (cameras != 1 && cameras != 2 && cameras != 4)
    refuse_value("vision.cameras", cameras, "1, 2 or 4");
  check_ranges(configuration);
}

void validate(const RobotSpec& robot) {
  check_ranges(robot);
  check_number("speed_factor", robot.speed_factor, kFactorRange);
  check_number("acceleration_factor", robot.acceleration_factor, kFactorRange);
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
  check_ranges(field, "field.");
  if (field.goal_line_run_off_m > 0)
    check_number("field.goal_line_run_off_m", field.goal_line_run_off_m, kRunOffRange);
  check_at_most("field.goal_width_m", field.goal_width_m, field.width_m - 0.4);
  check_goals_end_before_walls(field);
  check_at_most("field.centre_circle_radius_m", field.centre_circle_radius_m, field.half_width_m());
  // A neutral spot must fit between the two defence areas (Laws: 700 mm from both).
  check_at_most("field.defence_area.depth_m", field.defence_area.depth_m,
                field.half_length_m() - 0.8);
  check_at_most("field.defence_area.straight_m", field.defence_area.straight_m,
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
