#include <cstring>
#include <stdexcept>

#include "league/team/flat_records.hpp"
#include "tests/league/team/program_side.hpp"
#include "tests/league/team/start_numbers.hpp"

namespace autoref::league {
namespace {

// Takes records from the beginning of a message.
class Records {
 public:
  explicit Records(std::string_view bytes) : left_(bytes), size_(bytes.size()) {}

  template <typename Record>
  Record take() {
    if (left_.size() < sizeof(Record)) throw std::runtime_error("too short");
    Record record;
    std::memcpy(&record, left_.data(), sizeof record);
    left_.remove_prefix(sizeof record);
    return record;
  }
  template <typename Record>
  Record take_head(FlatKind kind) {
    const auto record = take<Record>();
    if (record.kind != kind || record.length != size_) throw std::runtime_error("wrong record");
    return record;
  }
  void finish() const {
    if (!left_.empty()) throw std::runtime_error("too long");
  }

 private:
  std::string_view left_;
  std::size_t size_;
};

Field field_of(const FlatStart& s) {
  const auto shape =
      s.defence_area_is_box != 0 ? DefenceArea::Shape::kBox : DefenceArea::Shape::kQuarterCircles;
  return {s.length_m,
          s.width_m,
          s.run_off_m,
          0,  // among the numbers
          0,
          s.line_width_m,
          s.centre_circle_radius_m,
          s.penalty_mark_m,
          {shape, s.defence_area_depth_m, s.defence_area_straight_m},
          s.goal_width_m,
          s.goal_depth_m,
          s.goal_opening_height_m,
          s.goal_bar_radius_m,
          s.goal_wall_thickness_m};
}

TeamView referee_of(const FlatFrame& f) {
  TeamView view;
  view.frame = f.frame;
  view.time_s = f.time_s;
  view.latency_s = f.latency_s;
  view.play = static_cast<Play>(f.play);
  view.ours = f.ours != 0;
  if (f.has_placement != 0) view.placement_m = Vec2(f.placement_x_m, f.placement_y_m);
  if (f.placing != 0) view.placing_is_ours = f.placing == kFlatPlacedByOwn;
  if (f.next != kFlatNoCommand) view.next = static_cast<CommandKind>(f.next);
  view.next_is_ours = f.next_is_ours != 0;
  view.goals_own = f.goals_own;
  view.goals_opponent = f.goals_opponent;
  view.stage_time_left_s = f.stage_time_left_s;
  return view;
}

TrackedRobot tracked_of(const FlatRobot& r) {
  return {r.number,
          {r.x_m, r.y_m},
          {r.heading_x, r.heading_y},
          {r.vx_mps, r.vy_mps},
          r.angular_velocity_radps,
          r.is_seen != 0};
}

RobotObservation seen_of(const FlatRobot& r) {
  return {r.number, {r.x_m, r.y_m}, {r.heading_x, r.heading_y}};
}

void take_tracked(const FlatFrame& f, Records& records, TeamView& view) {
  view.ball = {{f.ball_x_m, f.ball_y_m},
               {f.ball_vx_mps, f.ball_vy_mps},
               f.ball_height_m,
               f.ball_height_deviation_m,
               f.is_height_known != 0};
  for (int i = 0; i < f.own_robots; ++i) view.own.push_back(tracked_of(records.take<FlatRobot>()));
  for (int i = 0; i < f.opponent_robots; ++i)
    view.opponents.push_back(tracked_of(records.take<FlatRobot>()));
}

Frame take_detections(const FlatFrame& f, Records& records) {
  Frame frame;
  if (f.has_ball != 0) {
    frame.ball = BallObservation{
        {f.ball_x_m, f.ball_y_m}, std::nullopt, {{f.camera_x_m, f.camera_y_m}, f.camera_height_m}};
    if (f.is_height_known != 0) frame.ball->height_m = f.ball_height_m;
  }
  for (int i = 0; i < f.own_robots; ++i)
    frame.robots[Side::kWest].push_back(seen_of(records.take<FlatRobot>()));
  for (int i = 0; i < f.opponent_robots; ++i)
    frame.robots[Side::kEast].push_back(seen_of(records.take<FlatRobot>()));
  return frame;
}

class FlatSide final : public ProgramSide {
 public:
  TeamStart read_start(std::string_view bytes) const override {
    Records records(bytes);
    const auto head = records.take_head<FlatStart>(FlatKind::kStart);
    TeamStart start;
    start.side = static_cast<Side>(head.side);
    start.random_seed = head.random_seed;
    start.frame_rate_hz = head.frame_rate_hz;
    start.latency_s = head.latency_s;
    start.field = field_of(head);
    start.rules.name = head.rules.data();
    for (std::uint32_t i = 0; i < head.robots; ++i) {
      const auto a = records.take<FlatAbilities>();
      start.robots.push_back(
          {a.speed_mps, a.acceleration_mps2, a.braking_mps2, a.kick_mps, a.chip_mps});
    }
    for (std::uint32_t i = 0; i < head.rule_numbers; ++i) {
      const auto number = records.take<FlatNumber>();
      if (!set_start_number(start, number.name.data(), number.value))
        throw std::runtime_error("unknown rule number");
    }
    for (std::uint32_t i = 0; i < head.params; ++i) {
      const auto number = records.take<FlatNumber>();
      start.params[number.name.data()] = number.value;
    }
    records.finish();
    return start;
  }

  TeamFrame read_frame(std::string_view bytes) const override {
    Records records(bytes);
    const auto head = records.take_head<FlatFrame>(FlatKind::kFrame);
    TeamFrame frame;
    frame.view = referee_of(head);
    frame.ball_in_dribbler_zone = head.ball_in_dribbler_zone;
    if (head.is_detections != 0) {
      frame.detections = take_detections(head, records);
    } else {
      take_tracked(head, records, frame.view);
    }
    records.finish();
    return frame;
  }

  TeamEnd read_end(std::string_view bytes) const override {
    Records records(bytes);
    const auto end = records.take_head<FlatEnd>(FlatKind::kEnd);
    records.finish();
    return {end.reason.data(), end.goals_own, end.goals_opponent};
  }

  std::string written(const TeamOutput& output) const override {
    FlatOutput head{};
    head.kind = FlatKind::kOutput;
    head.timeout = output.requests.timeout ? 1 : 0;
    head.frame = output.frame;
    head.keeper = output.requests.keeper;
    head.leaves = output.requests.leaves.value_or(-1);
    head.commands = kMaxRobots;
    head.text_bytes = static_cast<std::uint16_t>(output.text.size());
    head.length = static_cast<std::uint32_t>(sizeof head + kMaxRobots * sizeof(FlatCommand) +
                                             output.text.size());
    std::string bytes(reinterpret_cast<const char*>(&head), sizeof head);
    for (int robot = 0; robot < kMaxRobots; ++robot) {
      const RobotCommand& c = output.commands[static_cast<std::size_t>(robot)];
      const FlatCommand command{c.velocity_mps.x(),
                                c.velocity_mps.y(),
                                c.angular_velocity_radps,
                                c.kick_mps,
                                robot,
                                static_cast<std::uint8_t>(c.chip),
                                static_cast<std::uint8_t>(c.dribble),
                                0};
      bytes.append(reinterpret_cast<const char*>(&command), sizeof command);
    }
    return bytes + output.text;
  }
};

}  // namespace

std::unique_ptr<ProgramSide> make_flat_side() { return std::make_unique<FlatSide>(); }

}  // namespace autoref::league
