#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <google/protobuf/util/delimited_message_util.h>

#include <stdexcept>

#include "league/messages/team.pb.h"
#include "league/team/rule_numbers.hpp"
#include "tests/league/team/program_side.hpp"

namespace autoref::league {
namespace {

// Read by the library's own functions for delimited messages.
team::TeamInput parsed(std::string_view bytes) {
  google::protobuf::io::ArrayInputStream stream(bytes.data(), static_cast<int>(bytes.size()));
  team::TeamInput input;
  bool is_at_end = false;
  if (!google::protobuf::util::ParseDelimitedFromZeroCopyStream(&input, &stream, &is_at_end) ||
      stream.ByteCount() != static_cast<std::int64_t>(bytes.size())) {
    throw std::runtime_error("not one TeamInput");
  }
  return input;
}

Field field_of(const team::TeamField& f) {
  const auto shape =
      f.defence_area_is_box() ? DefenceArea::Shape::kBox : DefenceArea::Shape::kQuarterCircles;
  return {f.length_m(),
          f.width_m(),
          f.run_off_m(),
          0,  // among the numbers
          0,
          f.line_width_m(),
          f.centre_circle_radius_m(),
          f.penalty_mark_m(),
          {shape, f.defence_area_depth_m(), f.defence_area_straight_m()},
          f.goal_width_m(),
          f.goal_depth_m(),
          f.goal_opening_height_m(),
          f.goal_bar_radius_m(),
          f.goal_wall_thickness_m()};
}

TeamView referee_of(const team::TeamFrame& f) {
  TeamView view;
  view.frame = f.frame();
  view.time_s = f.time_s();
  view.latency_s = f.latency_s();
  view.play = static_cast<Play>(f.play());
  view.ours = f.ours();
  if (f.has_placement_x_m()) view.placement_m = Vec2(f.placement_x_m(), f.placement_y_m());
  if (f.has_placing_is_ours()) view.placing_is_ours = f.placing_is_ours();
  if (f.has_next()) view.next = static_cast<CommandKind>(f.next());
  view.next_is_ours = f.next_is_ours();
  view.goals_own = f.goals_own();
  view.goals_opponent = f.goals_opponent();
  view.stage_time_left_s = f.stage_time_left_s();
  return view;
}

TrackedRobots tracked_of(const google::protobuf::RepeatedPtrField<team::TeamRobot>& robots) {
  TrackedRobots read;
  for (const team::TeamRobot& r : robots) {
    read.push_back({static_cast<int>(r.number()),
                    {r.x_m(), r.y_m()},
                    {r.heading_x(), r.heading_y()},
                    {r.vx_mps(), r.vy_mps()},
                    r.angular_velocity_radps(),
                    r.is_seen()});
  }
  return read;
}

SeenRobots seen_of(const google::protobuf::RepeatedPtrField<team::TeamRobot>& robots) {
  SeenRobots read;
  for (const team::TeamRobot& r : robots) {
    read.push_back(
        {static_cast<int>(r.number()), {r.x_m(), r.y_m()}, {r.heading_x(), r.heading_y()}});
  }
  return read;
}

std::optional<BallObservation> seen_ball_of(const team::TeamFrame& f) {
  if (!f.has_ball()) return std::nullopt;
  const team::TeamBall& ball = f.ball();
  BallObservation read{{ball.x_m(), ball.y_m()},
                       std::nullopt,
                       {{ball.camera_x_m(), ball.camera_y_m()}, ball.camera_height_m()}};
  if (ball.has_height_m()) read.height_m = ball.height_m();
  return read;
}

class ProtobufSide final : public ProgramSide {
 public:
  TeamStart read_start(std::string_view bytes) const override {
    const team::TeamInput input = parsed(bytes);
    const team::TeamStart& message = input.start();
    TeamStart start;
    start.side = static_cast<Side>(message.side());
    start.random_seed = message.random_seed();
    start.frame_rate_hz = message.frame_rate_hz();
    start.latency_s = message.latency_s();
    start.field = field_of(message.field());
    start.rules.name = message.rules();
    for (const team::TeamNumber& number : message.rule_numbers()) {
      if (!set_start_number(start, number.name(), number.value()))
        throw std::runtime_error("unknown number");
    }
    for (const team::TeamNumber& number : message.params())
      start.params[number.name()] = number.value();
    for (const team::TeamAbilities& a : message.robots()) {
      start.robots.push_back(
          {a.speed_mps(), a.acceleration_mps2(), a.braking_mps2(), a.kick_mps(), a.chip_mps()});
    }
    return start;
  }

  TeamFrame read_frame(std::string_view bytes) const override {
    const team::TeamInput input = parsed(bytes);
    const team::TeamFrame& message = input.frame();
    TeamFrame frame;
    frame.view = referee_of(message);
    for (const std::uint32_t robot : message.ball_in_dribbler_zone())
      frame.ball_in_dribbler_zone.set(robot);
    if (message.ball().has_vx_mps()) {
      const team::TeamBall& ball = message.ball();
      frame.view.ball = {{ball.x_m(), ball.y_m()},
                         {ball.vx_mps(), ball.vy_mps()},
                         ball.height_m(),
                         ball.height_deviation_m(),
                         ball.is_height_known()};
      frame.view.own = tracked_of(message.own());
      frame.view.opponents = tracked_of(message.opponents());
    } else {
      Frame& seen = frame.detections.emplace();
      seen.ball = seen_ball_of(message);
      seen.robots[Side::kWest] = seen_of(message.own());
      seen.robots[Side::kEast] = seen_of(message.opponents());
    }
    return frame;
  }

  TeamEnd read_end(std::string_view bytes) const override {
    const team::TeamInput input = parsed(bytes);
    return {input.end().reason(), input.end().goals_own(), input.end().goals_opponent()};
  }

  std::string written(const TeamOutput& output) const override {
    team::TeamOutput message;
    message.set_frame(output.frame);
    message.set_keeper(output.requests.keeper);
    if (output.requests.leaves)
      message.set_leaves(static_cast<std::uint32_t>(*output.requests.leaves));
    message.set_timeout(output.requests.timeout);
    message.set_text(output.text);
    for (std::size_t robot = 0; robot < output.commands.size(); ++robot) {
      const RobotCommand& c = output.commands[robot];
      team::TeamCommand& command = *message.add_commands();
      command.set_robot(static_cast<std::uint32_t>(robot));
      command.set_vx_mps(c.velocity_mps.x());
      command.set_vy_mps(c.velocity_mps.y());
      command.set_angular_velocity_radps(c.angular_velocity_radps);
      command.set_kick_mps(c.kick_mps);
      command.set_chip(c.chip);
      command.set_dribble(c.dribble);
    }
    std::string bytes;
    google::protobuf::io::StringOutputStream stream(&bytes);
    google::protobuf::util::SerializeDelimitedToZeroCopyStream(message, &stream);
    return bytes;
  }
};

}  // namespace

std::unique_ptr<ProgramSide> make_protobuf_side() { return std::make_unique<ProtobufSide>(); }

std::unique_ptr<ProgramSide> make_program_side(TeamEncoding encoding) {
  if (encoding == TeamEncoding::kProtobuf) return make_protobuf_side();
  return encoding == TeamEncoding::kJson ? make_json_side() : make_flat_side();
}

}  // namespace autoref::league
