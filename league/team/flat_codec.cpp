#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "league/team/flat_records.hpp"
#include "league/team/output_builder.hpp"
#include "league/team/team_codec.hpp"
#include "league/team/team_fault.hpp"
#include "league/team/team_messages.hpp"

namespace autoref::league {
namespace {

template <typename Record>
void append_record(const Record& record, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(&record), sizeof record);
}

template <std::size_t kSize>
void copy_name(std::string_view name, std::array<char, kSize>& to) {
  name = name.substr(0, kSize - 1);
  std::copy(name.begin(), name.end(), to.begin());
}

void append_number(std::string_view name, double value, std::string& bytes) {
  FlatNumber number{};
  copy_name(name, number.name);
  number.value = value;
  append_record(number, bytes);
}

// Sets the length of the record that starts at `begin` and ends at the end of `bytes`.
void close_record(std::size_t begin, std::string& bytes) {
  const auto length = static_cast<std::uint32_t>(bytes.size() - begin);
  std::memcpy(bytes.data() + begin, &length, sizeof length);
}

void set_field(const Field& field, FlatStart& record) {
  record.length_m = field.length_m;
  record.width_m = field.width_m;
  record.run_off_m = field.run_off_m;
  record.line_width_m = field.line_width_m;
  record.centre_circle_radius_m = field.centre_circle_radius_m;
  record.penalty_mark_m = field.penalty_mark_m;
  record.defence_area_depth_m = field.defence_area.depth_m;
  record.defence_area_straight_m = field.defence_area.straight_m;
  record.goal_width_m = field.goal_width_m;
  record.goal_depth_m = field.goal_depth_m;
  record.goal_opening_height_m = field.goal_opening_height_m;
  record.goal_bar_radius_m = field.goal_bar_radius_m;
  record.goal_wall_thickness_m = field.goal_wall_thickness_m;
  record.defence_area_is_box = field.defence_area.shape == DefenceArea::Shape::kBox ? 1 : 0;
}

FlatStart record_of(const TeamStart& start) {
  FlatStart record{};
  record.kind = FlatKind::kStart;
  record.side = static_cast<std::uint16_t>(start.side);
  record.random_seed = start.random_seed;
  record.frame_rate_hz = start.frame_rate_hz;
  record.latency_s = start.latency_s;
  set_field(start.field, record);
  record.robots = static_cast<std::uint32_t>(start.robots.size());
  visit_start_numbers(start, [&record](std::string_view, double) { ++record.rule_numbers; });
  record.params = static_cast<std::uint32_t>(start.params.size());
  copy_name(start.rules.name, record.rules);
  return record;
}

void set_referee(const TeamView& view, FlatFrame& record) {
  record.stage_time_left_s = view.stage_time_left_s;
  record.has_placement = view.placement_m ? 1 : 0;
  if (view.placement_m) {
    record.placement_x_m = view.placement_m->x();
    record.placement_y_m = view.placement_m->y();
  }
  record.goals_own = view.goals_own;
  record.goals_opponent = view.goals_opponent;
  record.play = static_cast<std::uint8_t>(view.play);
  record.ours = view.ours ? 1 : 0;
  if (view.placing_is_ours)
    record.placing = *view.placing_is_ours ? kFlatPlacedByOwn : kFlatPlacedByOpponents;
  record.next = view.next ? static_cast<std::uint8_t>(*view.next) : kFlatNoCommand;
  record.next_is_ours = view.next_is_ours ? 1 : 0;
}

void set_ball(const TrackedBall& ball, FlatFrame& record) {
  record.has_ball = 1;
  record.ball_x_m = ball.position_m.x();
  record.ball_y_m = ball.position_m.y();
  record.ball_vx_mps = ball.velocity_mps.x();
  record.ball_vy_mps = ball.velocity_mps.y();
  record.ball_height_m = ball.height_m;
  record.ball_height_deviation_m = ball.height_deviation_m;
  record.is_height_known = ball.is_height_known ? 1 : 0;
}

void set_ball(const std::optional<BallObservation>& ball, FlatFrame& record) {
  if (!ball) return;
  record.has_ball = 1;
  record.ball_x_m = ball->position_m.x();
  record.ball_y_m = ball->position_m.y();
  record.ball_height_m = ball->height_m.value_or(0);
  record.is_height_known = ball->height_m ? 1 : 0;
  record.camera_x_m = ball->seen_from.position_m.x();
  record.camera_y_m = ball->seen_from.position_m.y();
  record.camera_height_m = ball->seen_from.height_m;
}

FlatRobot record_of(const TrackedRobot& robot) {
  return {robot.position_m.x(),
          robot.position_m.y(),
          robot.heading.x(),
          robot.heading.y(),
          robot.velocity_mps.x(),
          robot.velocity_mps.y(),
          robot.angular_velocity_radps,
          robot.number,
          robot.is_seen ? 1U : 0U};
}

FlatRobot record_of(const RobotObservation& robot) {
  return {robot.position_m.x(),
          robot.position_m.y(),
          robot.heading.x(),
          robot.heading.y(),
          0,
          0,
          0,
          robot.number,
          1};
}

template <typename Ball, typename Robots>
void append_frame(FlatFrame& record, const Ball& ball, const Robots& own, const Robots& opponents,
                  std::string& bytes) {
  set_ball(ball, record);
  record.own_robots = static_cast<std::uint8_t>(own.size());
  record.opponent_robots = static_cast<std::uint8_t>(opponents.size());
  record.length = static_cast<std::uint32_t>(sizeof(FlatFrame) +
                                             (own.size() + opponents.size()) * sizeof(FlatRobot));
  append_record(record, bytes);
  for (const auto& robot : own) append_record(record_of(robot), bytes);
  for (const auto& robot : opponents) append_record(record_of(robot), bytes);
}

template <typename Record>
Record record_at(std::string_view bytes, std::size_t offset) {
  Record record;
  std::memcpy(&record, bytes.data() + offset, sizeof record);
  return record;
}

bool yes_or_no(unsigned value, std::string_view name) {
  if (value > 1) throw TeamFault(fmt::format("{} is {}; it must be 0 or 1", name, value));
  return value == 1;
}

void check_reserved(std::uint32_t value) {
  if (value != 0) throw TeamFault("a reserved value is not 0");
}

void add_flat_command(const FlatCommand& record, OutputBuilder& output) {
  check_reserved(record.reserved);
  RobotCommand command;
  command.velocity_mps = {record.vx_mps, record.vy_mps};
  command.angular_velocity_radps = record.angular_velocity_radps;
  command.kick_mps = record.kick_mps;
  command.chip = yes_or_no(record.chip, "chip");
  command.dribble = yes_or_no(record.dribble, "dribble");
  output.add_command(record.robot, command);
}

class FlatCodec final : public TeamCodec {
 public:
  void append(const TeamStart& start, std::string& bytes) override {
    check_names(start);
    const std::size_t begin = bytes.size();
    append_record(record_of(start), bytes);
    for (const Abilities& a : start.robots) {
      append_record(
          FlatAbilities{a.speed_mps, a.acceleration_mps2, a.braking_mps2, a.kick_mps, a.chip_mps},
          bytes);
    }
    visit_start_numbers(start, [&bytes](std::string_view name, double value) {
      append_number(name, value, bytes);
    });
    for (const auto& [name, value] : start.params) append_number(name, value, bytes);
    close_record(begin, bytes);
  }

  void append(const TeamFrame& frame, std::string& bytes) override {
    const TeamView& view = frame.view;
    FlatFrame record{};
    record.kind = FlatKind::kFrame;
    record.is_detections = frame.detections ? 1 : 0;
    record.frame = view.frame;
    record.time_s = view.time_s;
    record.latency_s = view.latency_s;
    record.ball_in_dribbler_zone =
        static_cast<std::uint16_t>(frame.ball_in_dribbler_zone.to_ulong());
    set_referee(view, record);
    if (frame.detections) {
      const Frame& seen = *frame.detections;
      append_frame(record, seen.ball, seen.robots[Side::kWest], seen.robots[Side::kEast], bytes);
    } else {
      append_frame(record, view.ball, view.own, view.opponents, bytes);
    }
  }

  void append(const TeamEnd& end, std::string& bytes) override {
    FlatEnd record{};
    record.length = sizeof record;
    record.kind = FlatKind::kEnd;
    record.goals_own = end.goals_own;
    record.goals_opponent = end.goals_opponent;
    copy_name(end.reason, record.reason);
    append_record(record, bytes);
  }

  std::optional<MessageExtent> find_message(std::string_view bytes) const override {
    constexpr std::size_t kHead = 6;  // length and kind
    if (bytes.size() < kHead) return std::nullopt;
    const auto length = record_at<std::uint32_t>(bytes, 0);
    const auto kind = record_at<std::uint16_t>(bytes, 4);
    if (kind != static_cast<std::uint16_t>(FlatKind::kOutput))
      throw TeamFault(fmt::format("a record has kind {}; outputs have kind 4", kind));
    if (length < sizeof(FlatOutput) || length > kLongestOutput) {
      throw TeamFault(fmt::format("an output record has the length {}; it must be from {} to {}",
                                  length, sizeof(FlatOutput), kLongestOutput));
    }
    if (bytes.size() < length) return std::nullopt;
    return MessageExtent{0, length, length};
  }

  void read(std::string_view content, TeamOutput& output) override {
    const auto record = record_at<FlatOutput>(content, 0);
    const std::size_t commands_size = record.commands * sizeof(FlatCommand);
    if (content.size() != sizeof record + commands_size + record.text_bytes) {
      throw TeamFault(fmt::format(
          "an output record has the length {}; with {} commands and {} bytes of text it must be {}",
          content.size(), record.commands, record.text_bytes,
          sizeof record + commands_size + record.text_bytes));
    }
    check_reserved(record.reserved);
    OutputBuilder builder(output);
    builder.set_frame(record.frame);
    builder.set_keeper(record.keeper);
    if (record.leaves != -1) builder.set_leaves(record.leaves);
    builder.set_timeout(yes_or_no(record.timeout, "timeout"));
    for (std::size_t i = 0; i < record.commands; ++i) {
      const std::size_t offset = sizeof record + i * sizeof(FlatCommand);
      add_flat_command(record_at<FlatCommand>(content, offset), builder);
    }
    builder.set_text(content.substr(sizeof record + commands_size));
  }
};

}  // namespace

std::unique_ptr<TeamCodec> make_flat_codec() { return std::make_unique<FlatCodec>(); }

}  // namespace autoref::league
