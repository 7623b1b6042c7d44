#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/league/team/program_side.hpp"
#include "tests/league/team/start_numbers.hpp"

namespace autoref::league {
namespace {

using nlohmann::json;

json parsed(std::string_view bytes, const char* kind) {
  if (std::count(bytes.begin(), bytes.end(), '\n') != 1 || bytes.back() != '\n')
    throw std::runtime_error("not one line");
  return json::parse(bytes).at(kind);
}

double number(const json& object, const char* name) { return object.at(name).get<double>(); }

Vec2 vector(const json& object, const char* x, const char* y) {
  return {number(object, x), number(object, y)};
}

Field field_of(const json& field) {
  Field described;
  const auto read = [&field](const char* name, double& value) { value = number(field, name); };
  read("length_m", described.length_m);
  read("width_m", described.width_m);
  read("run_off_m", described.run_off_m);
  read("line_width_m", described.line_width_m);
  read("centre_circle_radius_m", described.centre_circle_radius_m);
  read("penalty_mark_m", described.penalty_mark_m);
  read("defence_area_depth_m", described.defence_area.depth_m);
  read("defence_area_straight_m", described.defence_area.straight_m);
  read("goal_width_m", described.goal_width_m);
  read("goal_depth_m", described.goal_depth_m);
  read("goal_opening_height_m", described.goal_opening_height_m);
  read("goal_bar_radius_m", described.goal_bar_radius_m);
  read("goal_wall_thickness_m", described.goal_wall_thickness_m);
  if (field.at("defence_area_is_box")) described.defence_area.shape = DefenceArea::Shape::kBox;
  return described;
}

Play play_of(const json& name) {
  for (int play = 0; play <= static_cast<int>(Play::kRunning); ++play) {
    if (name_of(static_cast<Play>(play)) == name) return static_cast<Play>(play);
  }
  throw std::runtime_error("unknown play");
}

CommandKind command_of(const json& name) {
  for (int kind = 0; kind <= static_cast<int>(CommandKind::kBallPlacement); ++kind) {
    if (name_of(static_cast<CommandKind>(kind)) == name) return static_cast<CommandKind>(kind);
  }
  throw std::runtime_error("unknown command");
}

TeamView referee_of(const json& f) {
  TeamView view;
  view.frame = f.at("frame");
  view.time_s = f.at("time_s");
  view.latency_s = f.at("latency_s");
  view.play = play_of(f.at("play"));
  view.ours = f.at("ours");
  if (!f.at("placement_x_m").is_null())
    view.placement_m = vector(f, "placement_x_m", "placement_y_m");
  if (!f.at("placing_is_ours").is_null()) view.placing_is_ours = f["placing_is_ours"].get<bool>();
  if (!f.at("next").is_null()) view.next = command_of(f["next"]);
  view.next_is_ours = f.at("next_is_ours");
  view.goals_own = f.at("goals_own");
  view.goals_opponent = f.at("goals_opponent");
  view.stage_time_left_s = f.at("stage_time_left_s");
  return view;
}

TrackedRobots tracked_of(const json& robots) {
  TrackedRobots read;
  for (const json& r : robots) {
    read.push_back({r.at("number"), vector(r, "x_m", "y_m"), vector(r, "heading_x", "heading_y"),
                    vector(r, "vx_mps", "vy_mps"), r.at("angular_velocity_radps"),
                    r.at("is_seen")});
  }
  return read;
}

SeenRobots seen_of(const json& robots) {
  SeenRobots read;
  for (const json& r : robots)
    read.push_back({r.at("number"), vector(r, "x_m", "y_m"), vector(r, "heading_x", "heading_y")});
  return read;
}

std::optional<BallObservation> seen_ball_of(const json& ball) {
  if (ball.is_null()) return std::nullopt;
  BallObservation read{vector(ball, "x_m", "y_m"),
                       std::nullopt,
                       {vector(ball, "camera_x_m", "camera_y_m"), ball.at("camera_height_m")}};
  if (!ball.at("height_m").is_null()) read.height_m = ball["height_m"].get<double>();
  return read;
}

TrackedBall tracked_ball_of(const json& ball) {
  return {vector(ball, "x_m", "y_m"), vector(ball, "vx_mps", "vy_mps"), ball.at("height_m"),
          ball.at("height_deviation_m"), ball.at("is_height_known")};
}

bool is_tracked(const json& frame) { return frame.at("ball").contains("vx_mps"); }

class JsonSide final : public ProgramSide {
 public:
  TeamStart read_start(std::string_view bytes) const override {
    const json message = parsed(bytes, "start");
    TeamStart start;
    start.side = message.at("side") == "east" ? Side::kEast : Side::kWest;
    start.random_seed = std::stoull(message.at("random_seed").get<std::string>());
    start.frame_rate_hz = message.at("frame_rate_hz");
    start.latency_s = message.at("latency_s");
    start.field = field_of(message.at("field"));
    start.rules.name = message.at("rules");
    for (const auto& [name, value] : message.at("rule_numbers").items()) {
      if (!set_start_number(start, name, value)) throw std::runtime_error("unknown number");
    }
    for (const auto& [name, value] : message.at("params").items()) start.params[name] = value;
    for (const json& a : message.at("robots")) {
      start.robots.push_back({a.at("speed_mps"), a.at("acceleration_mps2"), a.at("braking_mps2"),
                              a.at("kick_mps"), a.at("chip_mps")});
    }
    return start;
  }

  TeamFrame read_frame(std::string_view bytes) const override {
    const json message = parsed(bytes, "frame");
    TeamFrame frame;
    frame.view = referee_of(message);
    for (const json& robot : message.at("ball_in_dribbler_zone"))
      frame.ball_in_dribbler_zone.set(robot.get<std::size_t>());
    if (is_tracked(message)) {
      frame.view.ball = tracked_ball_of(message.at("ball"));
      frame.view.own = tracked_of(message.at("own"));
      frame.view.opponents = tracked_of(message.at("opponents"));
    } else {
      Frame& seen = frame.detections.emplace();
      seen.ball = seen_ball_of(message.at("ball"));
      seen.robots[Side::kWest] = seen_of(message.at("own"));
      seen.robots[Side::kEast] = seen_of(message.at("opponents"));
    }
    return frame;
  }

  TeamEnd read_end(std::string_view bytes) const override {
    const json message = parsed(bytes, "end");
    return {message.at("reason"), message.at("goals_own"), message.at("goals_opponent")};
  }

  std::string written(const TeamOutput& output) const override {
    json message = {{"frame", output.frame},
                    {"keeper", output.requests.keeper},
                    {"timeout", output.requests.timeout},
                    {"text", output.text}};
    if (output.requests.leaves) message["leaves"] = *output.requests.leaves;
    for (std::size_t robot = 0; robot < output.commands.size(); ++robot) {
      const RobotCommand& c = output.commands[robot];
      message["commands"].push_back({{"robot", robot},
                                     {"vx_mps", c.velocity_mps.x()},
                                     {"vy_mps", c.velocity_mps.y()},
                                     {"angular_velocity_radps", c.angular_velocity_radps},
                                     {"kick_mps", c.kick_mps},
                                     {"chip", c.chip},
                                     {"dribble", c.dribble}});
    }
    return message.dump() + "\n";
  }
};

}  // namespace

std::unique_ptr<ProgramSide> make_json_side() { return std::make_unique<JsonSide>(); }

}  // namespace autoref::league
