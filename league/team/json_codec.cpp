#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "league/team/json_output.hpp"
#include "league/team/team_codec.hpp"
#include "league/team/team_fault.hpp"
#include "league/team/team_messages.hpp"

namespace autoref::league {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson json_of(const Field& field) {
  const bool is_box = field.defence_area.shape == DefenceArea::Shape::kBox;
  return {{"length_m", field.length_m},
          {"width_m", field.width_m},
          {"run_off_m", field.run_off_m},
          {"line_width_m", field.line_width_m},
          {"centre_circle_radius_m", field.centre_circle_radius_m},
          {"penalty_mark_m", field.penalty_mark_m},
          {"defence_area_depth_m", field.defence_area.depth_m},
          {"defence_area_straight_m", field.defence_area.straight_m},
          {"goal_width_m", field.goal_width_m},
          {"goal_depth_m", field.goal_depth_m},
          {"goal_opening_height_m", field.goal_opening_height_m},
          {"goal_bar_radius_m", field.goal_bar_radius_m},
          {"goal_wall_thickness_m", field.goal_wall_thickness_m},
          {"defence_area_is_box", is_box}};
}

OrderedJson json_of(const Abilities& robot) {
  return {{"speed_mps", robot.speed_mps},
          {"acceleration_mps2", robot.acceleration_mps2},
          {"braking_mps2", robot.braking_mps2},
          {"kick_mps", robot.kick_mps},
          {"chip_mps", robot.chip_mps}};
}

// The random seed is a text, since JavaScript's numbers have 53 bits.
OrderedJson json_of(const TeamStart& start) {
  OrderedJson members = {{"side", name_of(start.side)},
                         {"random_seed", fmt::format("{}", start.random_seed)},
                         {"frame_rate_hz", start.frame_rate_hz},
                         {"latency_s", start.latency_s}};
  members["field"] = json_of(start.field);
  members["robots"] = OrderedJson::array();
  for (const Abilities& robot : start.robots) members["robots"].push_back(json_of(robot));
  members["rules"] = start.rules.name;
  members["rule_numbers"] = OrderedJson::object();
  visit_start_numbers(start, [&members](std::string_view name, double value) {
    members["rule_numbers"][std::string(name)] = value;
  });
  members["params"] = OrderedJson::object();
  for (const auto& [name, value] : start.params) members["params"][name] = value;
  return members;
}

void append_line(std::string_view kind, OrderedJson members, std::string& bytes) {
  const OrderedJson line = {{std::string(kind), std::move(members)}};
  bytes += line.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
  bytes += '\n';
}

void write_vector(std::string_view x_name, std::string_view y_name, const std::optional<Vec2>& v,
                  JsonText& text) {
  if (v) {
    text.member(x_name, v->x()).member(y_name, v->y());
  } else {
    text.null(x_name).null(y_name);
  }
}

void write_referee(const TeamView& view, JsonText& text) {
  text.member("play", name_of(view.play)).member("ours", view.ours);
  write_vector("placement_x_m", "placement_y_m", view.placement_m, text);
  if (view.placing_is_ours) {
    text.member("placing_is_ours", *view.placing_is_ours);
  } else {
    text.null("placing_is_ours");
  }
  if (view.next) {
    text.member("next", name_of(*view.next));
  } else {
    text.null("next");
  }
  text.member("next_is_ours", view.next_is_ours)
      .member("goals_own", view.goals_own)
      .member("goals_opponent", view.goals_opponent)
      .member("stage_time_left_s", view.stage_time_left_s);
}

void write(const TrackedBall& ball, JsonText& text) {
  text.open('{', "ball");
  write_vector("x_m", "y_m", ball.position_m, text);
  write_vector("vx_mps", "vy_mps", ball.velocity_mps, text);
  text.member("height_m", ball.height_m)
      .member("height_deviation_m", ball.height_deviation_m)
      .member("is_height_known", ball.is_height_known)
      .close('}');
}

void write(const std::optional<BallObservation>& ball, JsonText& text) {
  if (!ball) {
    text.null("ball");
    return;
  }
  text.open('{', "ball");
  write_vector("x_m", "y_m", ball->position_m, text);
  if (ball->height_m) {
    text.member("height_m", *ball->height_m);
  } else {
    text.null("height_m");
  }
  write_vector("camera_x_m", "camera_y_m", ball->seen_from.position_m, text);
  text.member("camera_height_m", ball->seen_from.height_m).close('}');
}

template <typename Robot>
void write_position(const Robot& robot, JsonText& text) {
  text.member("number", robot.number);
  write_vector("x_m", "y_m", robot.position_m, text);
  write_vector("heading_x", "heading_y", robot.heading, text);
}

void write(const TrackedRobot& robot, JsonText& text) {
  text.open('{');
  write_position(robot, text);
  write_vector("vx_mps", "vy_mps", robot.velocity_mps, text);
  text.member("angular_velocity_radps", robot.angular_velocity_radps)
      .member("is_seen", robot.is_seen)
      .close('}');
}

void write(const RobotObservation& robot, JsonText& text) {
  text.open('{');
  write_position(robot, text);
  text.close('}');
}

template <typename Robots>
void write(std::string_view name, const Robots& robots, JsonText& text) {
  text.open('[', name);
  for (const auto& robot : robots) write(robot, text);
  text.close(']');
}

template <typename Ball, typename Robots>
void write_motion(const Ball& ball, const Robots& own, const Robots& opponents, JsonText& text) {
  write(ball, text);
  write("own", own, text);
  write("opponents", opponents, text);
}

class JsonCodec final : public TeamCodec {
 public:
  void append(const TeamStart& start, std::string& bytes) override {
    check_names(start);
    append_line("start", json_of(start), bytes);
  }

  void append(const TeamFrame& frame, std::string& bytes) override {
    const TeamView& view = frame.view;
    JsonText text(bytes);
    text.open('{').open('{', "frame").member("frame", view.frame).member("time_s", view.time_s);
    text.member("latency_s", view.latency_s);
    write_referee(view, text);
    if (frame.detections) {
      const Frame& seen = *frame.detections;
      write_motion(seen.ball, seen.robots[Side::kWest], seen.robots[Side::kEast], text);
    } else {
      write_motion(view.ball, view.own, view.opponents, text);
    }
    text.open('[', "ball_in_dribbler_zone");
    for (int number = 0; number < kMaxRobots; ++number) {
      if (frame.ball_in_dribbler_zone[static_cast<std::size_t>(number)]) text.member({}, number);
    }
    text.close(']').close('}').close('}');
    bytes += '\n';
  }

  void append(const TeamEnd& end, std::string& bytes) override {
    append_line("end",
                {{"reason", end.reason.substr(0, kLongestName)},
                 {"goals_own", end.goals_own},
                 {"goals_opponent", end.goals_opponent}},
                bytes);
  }

  std::optional<MessageExtent> find_message(std::string_view bytes) const override {
    const std::size_t end = bytes.substr(0, kLongestOutput + 1).find('\n');
    if (end != std::string_view::npos) return MessageExtent{0, end, end + 1};
    if (bytes.size() > kLongestOutput)
      throw TeamFault(fmt::format("an output line is longer than {} bytes", kLongestOutput));
    return std::nullopt;
  }

  void read(std::string_view content, TeamOutput& output) override {
    read_json_output(content, output);
  }
};

}  // namespace

std::unique_ptr<TeamCodec> make_json_codec() { return std::make_unique<JsonCodec>(); }

}  // namespace autoref::league
