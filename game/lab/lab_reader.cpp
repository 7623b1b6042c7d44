// Reads laboratory scenes.
#include <fmt/format.h>

#include <stdexcept>

#include "game/lab/lab.hpp"
#include "game/settings/mapping.hpp"
#include "game/settings/robot_types.hpp"
#include "game/settings/setting_value.hpp"
#include "game/settings/settings_reader.hpp"
#include "game/settings/yaml.hpp"
#include "io/files.hpp"
#include "soccer/named.hpp"
#include "soccer/trigonometry.hpp"
#include "soccer/units.hpp"

namespace autoref::game {
namespace {

using Entries = std::vector<YamlEntry>;

const std::vector<std::string> kTop = {"schema", "kind", "about", "duration_s", "field",
                                       "sim",    "seed", "ball",  "robots"};
const std::vector<std::string> kBallKeys = {"x_m",    "y_m",    "height_m", "vx_mps",
                                            "vy_mps", "vz_mps", "rolls"};
const std::vector<std::string> kRobot = {"side",   "type",   "x_m",        "y_m",     "heading_deg",
                                         "vx_mps", "vy_mps", "turn_radps", "commands"};
const std::vector<std::string> kCommand = {"at_s",       "over_s",   "forward_mps", "left_mps",
                                           "turn_radps", "kick_mps", "chip",        "dribble"};

constexpr Range kSpeed_mps{-20, 20};
constexpr Range kTurn_radps{-100, 100};

class LabReader {
 public:
  explicit LabReader(const YamlFile& file) : file_(file), top_(file.top()) {}

  LabScene read() {
    expect_value(file_, top_, "schema", "1");
    expect_value(file_, top_, "kind", "lab");
    refuse_unknown(file_, top_, kTop);
    read_settings();
    if (const YamlEntry* about = find_entry(top_, "about")) {
      scene_.about = file_.scalar(*about, "about", "a sentence", false);
    }
    read_duration(required_entry(file_, top_, "duration_s"));
    if (const YamlEntry* ball = find_entry(top_, "ball")) read_ball(*ball);
    if (const YamlEntry* robots = find_entry(top_, "robots")) read_robots(*robots);
    return scene_;
  }

 private:
  // Reads those branches of settings that scenes have in common with games.
  void read_settings() {
    GameSettings game;
    game.sim = scene_.sim;
    game.robot = scene_.robot;
    game.seed = scene_.seed;
    SettingLocations locations;
    SettingsReader settings(file_, game, locations);
    for (const YamlEntry& entry : top_) {
      if (entry.key == "field" || entry.key == "sim" || entry.key == "seed") {
        settings.read(entry, entry.key);
      }
    }
    try {
      check_game(game);
    } catch (const SettingError& error) {
      file_.refuse(location_in(locations, error.path()), "", error.what());
    }
    scene_.field = game.field;
    scene_.sim = game.sim;
    scene_.robot = game.robot;
    scene_.seed = game.seed;
  }

  void read_duration(const YamlEntry& entry) {
    assign_entry(file_, entry, {"duration_s", &scene_.duration_s, {0, 600, true}, {}, "s", ""});
  }

  // The position must be inside the walls around the field.
  void read_position(const Mapping& from, Vec2& position_m) const {
    const double x = scene_.field.wall_x_m();
    const double y = scene_.field.wall_y_m();
    from.number("x_m", position_m.x(), {-x, x}, "m");
    from.number("y_m", position_m.y(), {-y, y}, "m");
  }

  static void read_velocity(const Mapping& from, Vec2& velocity_mps) {
    from.number("vx_mps", velocity_mps.x(), kSpeed_mps, "m/s");
    from.number("vy_mps", velocity_mps.y(), kSpeed_mps, "m/s");
  }

  void read_ball(const YamlEntry& entry) {
    const Mapping from(file_, entry, "ball", kBallKeys);
    sim::BallState& ball = scene_.ball;
    ball.is_rolling = false;
    read_position(from, ball.position_m);
    read_velocity(from, ball.velocity_mps);
    from.number("height_m", ball.height_m, {0, 10}, "m");
    from.number("vz_mps", ball.vertical_mps, kSpeed_mps, "m/s");
    from.yes_or_no("rolls", ball.is_rolling);
  }

  void read_robots(const YamlEntry& robots) {
    PerSide<int> count{};
    for (const YamlEntry& entry : elements(robots, "robots")) {
      const Mapping from(file_, entry, entry.key, kRobot);
      std::string side;
      from.word("side", side, all_names<Side>());
      if (side.empty()) file_.refuse(entry.location, entry.key, "the key 'side' is missing");
      LabRobot robot;
      robot.spec = scene_.robot;
      if (const YamlEntry* type = from.find("type")) read_type(*type, from.path_to("type"), robot);
      robot.id.side = find_named<Side>(side).value();
      robot.id.number = count[robot.id.side]++;
      if (robot.id.number == kMaxRobots) {
        file_.refuse(entry.location, entry.key,
                     fmt::format("expected at most {} robots per side", kMaxRobots));
      }
      read_robot(from, robot);
      scene_.robots.push_back(robot);
    }
  }

  void read_type(const YamlEntry& entry, const std::string& path, LabRobot& robot) const {
    static const std::string kExpected = "a file such as ../robots/slow.yaml";
    const std::string text = file_.scalar(entry, path, kExpected, false);
    RobotTypes types;
    try {
      take_type(text, file_.folder(), types);
    } catch (const std::invalid_argument& error) {
      file_.refuse(value_location(entry), path, error.what());
    }
    if (types.empty()) {
      file_.refuse(value_location(entry), path,
                   fmt::format("expected {}, found '{}'", kExpected, text));
    }
    apply_changes(types.begin()->second, robot.spec);
  }

  void read_robot(const Mapping& from, LabRobot& robot) const {
    robot.start.number = robot.id.number;
    read_position(from, robot.start.position_m);
    read_velocity(from, robot.start.velocity_mps);
    double heading_deg = 0.0;
    from.number("heading_deg", heading_deg, {-360, 360}, "deg");
    robot.start.heading = heading_of(heading_deg * kPi / 180.0);
    from.number("turn_radps", robot.start.angular_velocity_radps, kTurn_radps, "rad/s");
    const YamlEntry* commands = from.find("commands");
    if (commands == nullptr) return;
    for (const YamlEntry& entry : elements(*commands, from.path_to("commands"))) {
      robot.commands.push_back(read_command(entry));
      if (robot.commands.size() > 1 &&
          robot.commands.end()[-2].at_s >= robot.commands.back().at_s) {
        file_.refuse(entry.location, entry.key,
                     "expected a time after that of the previous command");
      }
    }
  }

  TimedCommand read_command(const YamlEntry& entry) const {
    const Mapping from(file_, entry, entry.key, kCommand);
    if (from.find("at_s") == nullptr) {
      file_.refuse(entry.location, entry.key, "the key 'at_s' is missing");
    }
    TimedCommand timed;
    RobotCommand& command = timed.command;
    from.number("at_s", timed.at_s, {0, 600}, "s");
    from.number("over_s", timed.over_s, {0, 600}, "s");
    from.number("forward_mps", command.velocity_mps.x(), kSpeed_mps, "m/s");
    from.number("left_mps", command.velocity_mps.y(), kSpeed_mps, "m/s");
    from.number("turn_radps", command.angular_velocity_radps, kTurn_radps, "rad/s");
    from.number("kick_mps", command.kick_mps, {0, 20}, "m/s");
    from.yes_or_no("chip", command.chip);
    from.yes_or_no("dribble", command.dribble);
    return timed;
  }

  // The elements of a list, named by their index, such as "robots[0]".
  Entries elements(const YamlEntry& list, const std::string& path) const {
    if (!list.value.IsSequence()) file_.refuse(value_location(list), path, "expected a list");
    Entries entries;
    for (const YAML::Node& node : list.value) {
      entries.push_back({fmt::format("{}[{}]", path, entries.size()), location_of(node), node});
    }
    return entries;
  }

  const YamlFile& file_;
  const Entries top_;
  LabScene scene_;
};

}  // namespace

LabScene read_lab_scene_text(const std::string& text, const std::string& file_name) {
  const YamlFile file(text, file_name);
  return LabReader(file).read();
}

LabScene read_lab_scene(const std::filesystem::path& file) {
  return read_lab_scene_text(io::read_user_file(file), file.string());
}

}  // namespace autoref::game
