#include "runner/settings/fields.hpp"

#include <fmt/format.h>

#include "sim/ball_presets.hpp"
#include "sim/camera_presets.hpp"
#include "sim/dribbler_presets.hpp"
#include "soccer/rule_table.hpp"
#include "strategies/registry.hpp"

namespace autoref::runner {
namespace {

// Collects the settings of one branch.
class Branch {
 public:
  Branch(std::vector<Setting>& list, std::string path) : list_(list), path_(std::move(path)) {}

  template <typename T>
  void number(std::string_view name, T& value, Range range, std::string_view unit,
              std::string_view about) {
    list_.push_back({path_ + std::string(name), &value, range, {}, unit, about});
  }

  template <typename T>
  void word(std::string_view name, T& value, std::vector<std::string> words,
            std::string_view about) {
    list_.push_back({path_ + std::string(name), &value, {}, std::move(words), "", about});
  }

  void yes_or_no(std::string_view name, bool& value, std::string_view about) {
    list_.push_back({path_ + std::string(name), &value, {}, {"false", "true"}, "", about});
  }

  void add(std::string_view name, Target target, Range range, std::string_view about) {
    list_.push_back({path_ + std::string(name), std::move(target), range, {}, "", about});
  }

  void preset(std::string_view name, Target target, std::vector<std::string> words,
              std::string_view about) {
    list_.push_back(
        {path_ + std::string(name), std::move(target), {}, std::move(words), "", about});
  }

  Branch below(const std::string& name) const { return {list_, path_ + name + "."}; }

 private:
  std::vector<Setting>& list_;
  std::string path_;
};

constexpr Range positive(double high) { return {0, high, true}; }

std::vector<std::string> strategy_names() {
  std::vector<std::string> names;
  for (const strategies::Entry& entry : strategies::all_strategies()) {
    names.emplace_back(entry.name);
  }
  return names;
}

void list_changes(RobotChanges& changes, Branch to) {
  to.add("robot", ChangesOf{&changes, "robot"}, {}, "what differs from sim.robot");
  to.add("kicker", ChangesOf{&changes, "kicker"}, {}, "what differs from sim.kicker");
  to.add("dribbler", ChangesOf{&changes, "dribbler"}, {}, "what differs from sim.dribbler");
}

// What robots of a team are like, or one of them.
template <typename Of>
void list_robots(Of& of, const RobotTypes& types, Branch to) {
  to.add("type", TypeName{&of.type, &types}, {}, "type of robots");
  to.number("speed_factor", of.speed_factor, positive(2), "", "scales the robots' top speed");
  to.number("acceleration_factor", of.acceleration_factor, positive(2), "",
            "scales their acceleration and braking");
  to.add("handicap", BothFactors{&of.speed_factor, &of.acceleration_factor}, positive(2),
         "sets speed_factor and acceleration_factor");
  list_changes(of.changes, to);
}

void list_types(RobotTypes& types, Branch to) {
  to.add("types", &types, {}, "types of robots by name");
  for (auto& [name, changes] : types) list_changes(changes, to.below("types").below(name));
}

void list_team(TeamConfiguration& team, const RobotTypes& types, Branch to) {
  to.word("strategy", team.strategy, strategy_names(), "who plays");
  to.number("robots", team.robots, {1, kMaxRobots}, "", "robots on the field");
  list_robots(team, types, to);
  to.add("players", &team.players, {}, "robots that differ from the team's, by number");
  for (auto& [number, player] : team.players) {
    list_robots(player, types, to.below("players").below(std::to_string(number)));
  }
  // check_team() knows the strategy, and with it each number's own range.
  to.add("params", &team.params, {-1e9, 1e9}, "the strategy's own numbers, by name");
}

void list_match(GameConfiguration& game, Branch to) {
  MatchConfiguration& match = game.match;
  const std::vector<std::string> sides = {"west", "east"};
  to.preset("rules", RulesChoice{&game}, rule_book_names(),
            "rule book; sets switch, half_s, extra_half_s, field and both teams' robots");
  to.number("half_s", match.half_s, positive(36000), "s", "length of a half");
  to.number("halves", match.halves, {1, 2}, "", "halves of a game");
  to.number("break_s", match.break_s, {0, 3600}, "s", "break between halves");
  to.yes_or_no("knockout", match.knockout, "extra time and a shoot-out after a draw");
  to.number("extra_half_s", match.extra_half_s, positive(36000), "s", "each of extra time's two");
  to.word("a_plays", match.a_plays, sides, "side of team a; b has the other");
  to.word("first_kickoff", match.first_kickoff, sides, "side that kicks off first");
  Branch switches = to.below("switch");
  for (const RuleEntry& entry : rule_table()) {
    switches.yes_or_no(std::string(name_of(entry.rule)), match.in_force[entry.rule], entry.about);
  }
}

void list_field(Field& field, Branch to) {
  const std::vector<std::string> shapes = {"quarter_circles", "box"};
  to.number("length_m", field.length_m, {4, 30}, "m", "between the goal lines' outer edges");
  to.number("width_m", field.width_m, {2, 20}, "m", "between the touch lines' outer edges");
  to.number("run_off_m", field.run_off_m, {0.1, 5}, "m", "from the lines to the wall");
  to.number("penalty_mark_m", field.penalty_mark_m, positive(20), "m", "from the goal shot at");
  to.word("defence_area.shape", field.defence_area.shape, shapes, "of the area before a goal");
  to.number("defence_area.depth_m", field.defence_area.depth_m, positive(5), "m",
            "radius of the quarter circles, or the box's size along x");
  to.number("defence_area.straight_m", field.defence_area.straight_m, {0, 10}, "m",
            "line between the quarter circles, or the box's size along y");
  to.number("goal_width_m", field.goal_width_m, {0.2, 5}, "m", "between the posts");
  to.number("goal_depth_m", field.goal_depth_m, {0.05, 1}, "m", "from goal line to back wall");
  to.number("goal_opening_height_m", field.goal_opening_height_m, positive(2), "m",
            "under the bar");
  to.number("goal_wall_thickness_m", field.goal_wall_thickness_m, {0.01, 0.1}, "m",
            "of the goal walls");
}

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
  to.number("ball_misses", vision.ball_misses, {0, 0.9}, "", "share of pictures without the ball");
  to.number("robot_misses", vision.robot_misses, {0, 0.9}, "", "share of pictures without a robot");
  to.yes_or_no("reports_height", vision.reports_height,
               "of the ball; else it is seen on the ground");
  to.yes_or_no("robots_hide_ball", vision.robots_hide_ball, "from the cameras");
}

void list_dribbler(sim::DribblerParameters& dribbler, Branch to) {
  to.preset("preset", DribblerPreset{&dribbler}, sim::dribbler_preset_names(),
            "sets how it has the ball");
  to.number("force_n", dribbler.force_n, {0, 100}, "N", "the most it pulls with");
  to.number("reach_m", dribbler.reach_m, {0, 0.1}, "m", "from the plate to the ball");
  to.yes_or_no("holds", dribbler.holds, "keeps the ball in every motion");
}

void list_sim(sim::Configuration& sim, sim::RobotSheet& robot, std::vector<Setting>& list) {
  Branch to(list, "sim.");
  to.number("substeps", sim.substeps, {1, 16}, "", "physics steps per picture");
  to.number("calm_substeps", sim.calm_substeps, {1, 16}, "", "and while nothing can meet anything");
  to.number("frame_rate_hz", sim.frame_rate_hz, {30, 240}, "1/s", "pictures per second");
  to.preset("camera", CameraPreset{&sim}, sim::camera_preset_names(),
            "sets vision, command_loss and latency_s");
  to.number("latency_s", sim.latency_s, {0, 0.5}, "s", "from a picture to the robots' motion");
  list_vision(sim.vision, Branch(list, "sim.vision."));
  Branch radio(list, "sim.radio.");
  radio.number("command_loss", sim.radio.command_loss, {0, 0.9}, "", "share of orders lost");
  radio.number("hold_s", sim.radio.hold_s, {0, 10}, "s", "stops without an order for so long");
  list_ball(sim.ball, Branch(list, "sim.ball."));
  for (Setting& setting : settings_of(robot, "sim.")) list.push_back(std::move(setting));
  Branch placement(list, "sim.placement.");
  placement.number("speed_mps", sim.placement.speed_mps, positive(100), "m/s", "of the hand");
  placement.number("acceleration_mps2", sim.placement.acceleration_mps2, positive(1000), "m/s^2",
                   "of the hand");
  placement.number("catch_mps2", sim.placement.catch_mps2, positive(1000), "m/s^2",
                   "what a moving ball loses first");
}

}  // namespace

std::vector<Setting> settings_of(GameConfiguration& game) {
  std::vector<Setting> list;
  list_types(game.types, Branch(list, ""));
  list_team(game.a, game.types, Branch(list, "teams.a."));
  list_team(game.b, game.types, Branch(list, "teams.b."));
  list_match(game, Branch(list, "match."));
  list_field(game.field, Branch(list, "field."));
  list_sim(game.sim, game.robot, list);
  Branch(list, "").number("seed", game.seed, {0, 18446744073709551615.0}, "",
                          "names the game's chances");
  return list;
}

std::vector<Setting> settings_of(TeamConfiguration& team, const RobotTypes& types,
                                 const std::string& prefix) {
  std::vector<Setting> list;
  list_team(team, types, Branch(list, prefix));
  return list;
}

std::vector<Setting> settings_of(sim::RobotSheet& robot, const std::string& prefix) {
  std::vector<Setting> list;
  list_robot(robot.body, Branch(list, prefix + "robot."));
  list_kicker(robot.kicker, Branch(list, prefix + "kicker."));
  list_dribbler(robot.dribbler, Branch(list, prefix + "dribbler."));
  return list;
}

std::vector<Setting> settings_of(RobotChanges& changes) {
  std::vector<Setting> list;
  list_changes(changes, Branch(list, ""));
  return list;
}

}  // namespace autoref::runner
