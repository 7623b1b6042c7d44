#include <fmt/format.h>

#include "league/messages/team.pb.h"
#include "league/team/codecs.hpp"
#include "league/team/delimited.hpp"
#include "league/team/output_builder.hpp"
#include "league/team/rule_numbers.hpp"
#include "league/team/team_fault.hpp"

namespace autoref::league {
namespace {

void fill_field(const Field& field, team::TeamField& message) {
  message.set_length_m(field.length_m);
  message.set_width_m(field.width_m);
  message.set_run_off_m(field.run_off_m);
  message.set_line_width_m(field.line_width_m);
  message.set_centre_circle_radius_m(field.centre_circle_radius_m);
  message.set_penalty_mark_m(field.penalty_mark_m);
  message.set_defence_area_depth_m(field.defence_area.depth_m);
  message.set_defence_area_straight_m(field.defence_area.straight_m);
  message.set_goal_width_m(field.goal_width_m);
  message.set_goal_depth_m(field.goal_depth_m);
  message.set_goal_opening_height_m(field.goal_opening_height_m);
  message.set_goal_bar_radius_m(field.goal_bar_radius_m);
  message.set_goal_wall_thickness_m(field.goal_wall_thickness_m);
  message.set_defence_area_is_box(field.defence_area.shape == DefenceArea::Shape::kBox);
}

void fill_abilities(const Abilities& robot, team::TeamAbilities& message) {
  message.set_speed_mps(robot.speed_mps);
  message.set_acceleration_mps2(robot.acceleration_mps2);
  message.set_braking_mps2(robot.braking_mps2);
  message.set_kick_mps(robot.kick_mps);
  message.set_chip_mps(robot.chip_mps);
}

void fill_named(std::string_view name, double value, team::TeamNumber& message) {
  message.set_name(std::string(name));
  message.set_value(value);
}

void fill_start(const TeamStart& start, team::TeamStart& message) {
  message.set_side(static_cast<std::uint32_t>(start.side));
  message.set_random_seed(start.random_seed);
  message.set_frame_rate_hz(start.frame_rate_hz);
  message.set_latency_s(start.latency_s);
  fill_field(start.field, *message.mutable_field());
  for (const Abilities& robot : start.robots) fill_abilities(robot, *message.add_robots());
  message.set_rules(start.rules.name);
  visit_start_numbers(start, [&message](std::string_view name, double value) {
    fill_named(name, value, *message.add_rule_numbers());
  });
  for (const auto& [name, value] : start.params) fill_named(name, value, *message.add_params());
}

void fill_referee(const TeamView& view, team::TeamFrame& message) {
  message.set_play(static_cast<team::TeamPlay>(view.play));
  message.set_ours(view.ours);
  if (view.placement_m) {
    message.set_placement_x_m(view.placement_m->x());
    message.set_placement_y_m(view.placement_m->y());
  }
  if (view.placing_is_ours) message.set_placing_is_ours(*view.placing_is_ours);
  if (view.next) message.set_next(static_cast<team::TeamCommandKind>(*view.next));
  message.set_next_is_ours(view.next_is_ours);
  message.set_goals_own(view.goals_own);
  message.set_goals_opponent(view.goals_opponent);
  message.set_stage_time_left_s(view.stage_time_left_s);
}

template <typename Object, typename Message>
void fill_position(const Object& object, Message& message) {
  message.set_x_m(object.position_m.x());
  message.set_y_m(object.position_m.y());
}

template <typename Object, typename Message>
void fill_velocity(const Object& object, Message& message) {
  message.set_vx_mps(object.velocity_mps.x());
  message.set_vy_mps(object.velocity_mps.y());
}

template <typename Robot>
void fill_pose(const Robot& robot, team::TeamRobot& message) {
  message.set_number(static_cast<std::uint32_t>(robot.number));
  fill_position(robot, message);
  message.set_heading_x(robot.heading.x());
  message.set_heading_y(robot.heading.y());
}

void fill_motion(const TrackedRobot& robot, team::TeamRobot& message) {
  fill_pose(robot, message);
  fill_velocity(robot, message);
  message.set_angular_velocity_radps(robot.angular_velocity_radps);
  message.set_is_seen(robot.is_seen);
}

void fill_motion(const RobotObservation& robot, team::TeamRobot& message) {
  fill_pose(robot, message);
}

void fill_ball_of(const TrackedBall& ball, team::TeamFrame& frame) {
  team::TeamBall& message = *frame.mutable_ball();
  fill_position(ball, message);
  fill_velocity(ball, message);
  message.set_height_m(ball.height_m);
  message.set_height_deviation_m(ball.height_deviation_m);
  message.set_is_height_known(ball.is_height_known);
}

void fill_ball_of(const std::optional<BallObservation>& ball, team::TeamFrame& frame) {
  if (!ball) return;
  team::TeamBall& message = *frame.mutable_ball();
  fill_position(*ball, message);
  if (ball->height_m) message.set_height_m(*ball->height_m);
  message.set_camera_x_m(ball->seen_from.position_m.x());
  message.set_camera_y_m(ball->seen_from.position_m.y());
  message.set_camera_height_m(ball->seen_from.height_m);
}

template <typename Ball, typename Robots>
void fill_objects(const Ball& ball, const Robots& own, const Robots& opponents,
                  team::TeamFrame& message) {
  fill_ball_of(ball, message);
  for (const auto& robot : own) fill_motion(robot, *message.add_own());
  for (const auto& robot : opponents) fill_motion(robot, *message.add_opponents());
}

void fill_frame(const TeamFrame& frame, team::TeamFrame& message) {
  const TeamView& view = frame.view;
  message.set_frame(view.frame);
  message.set_time_s(view.time_s);
  message.set_latency_s(view.latency_s);
  fill_referee(view, message);
  if (frame.detections) {
    const Frame& seen = *frame.detections;
    fill_objects(seen.ball, seen.robots[Side::kWest], seen.robots[Side::kEast], message);
  } else {
    fill_objects(view.ball, view.own, view.opponents, message);
  }
  for (std::uint32_t number = 0; number < kMaxRobots; ++number) {
    if (frame.ball_in_dribbler_zone[number]) message.add_ball_in_dribbler_zone(number);
  }
}

RobotCommand command_of(const team::TeamCommand& message) {
  RobotCommand command;
  command.velocity_mps = {message.vx_mps(), message.vy_mps()};
  command.angular_velocity_radps = message.angular_velocity_radps();
  command.kick_mps = message.kick_mps();
  command.chip = message.chip();
  command.dribble = message.dribble();
  return command;
}

class ProtobufCodec final : public TeamCodec {
 public:
  void append(const TeamStart& start, std::string& bytes) override {
    check_names(start);
    input_.Clear();
    fill_start(start, *input_.mutable_start());
    append_delimited(input_, bytes);
  }

  // Keeps the messages of the previous frame's robots, so that nothing is allocated.
  void append(const TeamFrame& frame, std::string& bytes) override {
    if (!input_.has_frame()) input_.Clear();
    input_.mutable_frame()->Clear();
    fill_frame(frame, *input_.mutable_frame());
    append_delimited(input_, bytes);
  }

  void append(const TeamEnd& end, std::string& bytes) override {
    input_.Clear();
    input_.mutable_end()->set_reason(end.reason.substr(0, kLongestName));
    input_.mutable_end()->set_goals_own(end.goals_own);
    input_.mutable_end()->set_goals_opponent(end.goals_opponent);
    append_delimited(input_, bytes);
  }

  std::optional<MessageExtent> find_message(std::string_view bytes) const override {
    return find_delimited(bytes);
  }

  void read(std::string_view content, TeamOutput& output) override {
    if (!output_.ParseFromArray(content.data(), static_cast<int>(content.size())))
      throw TeamFault(fmt::format("an output of {} bytes is not a TeamOutput", content.size()));
    if (!output_.has_frame()) throw TeamFault("an output names no frame");
    OutputBuilder builder(output);
    builder.set_frame(output_.frame());
    if (output_.has_keeper()) builder.set_keeper(output_.keeper());
    if (output_.has_leaves()) builder.set_leaves(output_.leaves());
    builder.set_timeout(output_.timeout());
    builder.set_text(output_.text());
    for (const team::TeamCommand& command : output_.commands()) {
      if (!command.has_robot()) throw TeamFault("a command names no robot");
      builder.add_command(command.robot(), command_of(command));
    }
  }

 private:
  team::TeamInput input_;
  team::TeamOutput output_;
};

}  // namespace

std::unique_ptr<TeamCodec> make_protobuf_codec() { return std::make_unique<ProtobufCodec>(); }

}  // namespace autoref::league
