// The flat records are laid out as docs/team-programs.md says.
#include "league/team/flat_records.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <fstream>
#include <map>
#include <regex>

#include "league/team/team_codec.hpp"
#include "tests/checkout.hpp"

namespace autoref::league {
namespace {

struct DocumentedNumber {
  std::size_t offset = 0;
  std::string type;
  std::string name;
  bool operator==(const DocumentedNumber&) const = default;
};

void PrintTo(const DocumentedNumber& number, std::ostream* stream) {
  *stream << number.offset << " " << number.type << " " << number.name;
}

using Layout = std::vector<DocumentedNumber>;

// The tables with offsets, in the order of the page.
std::vector<Layout> documented_layouts() {
  const std::regex row(R"(\| (\d+) \| (\w+) \| `(\w+)` \|.*)");
  std::vector<Layout> layouts;
  std::ifstream page(in_checkout("docs/team-programs.md"));
  for (std::string line; std::getline(page, line);) {
    std::smatch cells;
    if (line.starts_with("| offset |")) layouts.emplace_back();
    if (!layouts.empty() && std::regex_match(line, cells, row))
      layouts.back().push_back({std::stoul(cells[1]), cells[2], cells[3]});
  }
  return layouts;
}

template <typename Number>
constexpr const char* type_name() {
  if constexpr (std::is_enum_v<Number>) return type_name<std::underlying_type_t<Number>>();
  if constexpr (std::is_same_v<Number, std::array<char, 56>>) return "text";
  if constexpr (std::is_same_v<Number, double>) return "f64";
  if constexpr (std::is_same_v<Number, std::uint8_t>) return "u8";
  if constexpr (std::is_same_v<Number, std::uint16_t>) return "u16";
  if constexpr (std::is_same_v<Number, std::uint32_t>) return "u32";
  if constexpr (std::is_same_v<Number, std::uint64_t>) return "u64";
  if constexpr (std::is_same_v<Number, std::int32_t>) return "i32";
  return "i64";
}

#define AT(name) \
  DocumentedNumber { offsetof(Record, name), type_name<decltype(Record::name)>(), #name }

Layout layout_of_start() {
  using Record = FlatStart;
  return {AT(length),
          AT(kind),
          AT(side),
          AT(random_seed),
          AT(frame_rate_hz),
          AT(latency_s),
          AT(length_m),
          AT(width_m),
          AT(run_off_m),
          AT(line_width_m),
          AT(centre_circle_radius_m),
          AT(penalty_mark_m),
          AT(defence_area_depth_m),
          AT(defence_area_straight_m),
          AT(goal_width_m),
          AT(goal_depth_m),
          AT(goal_opening_height_m),
          AT(goal_bar_radius_m),
          AT(goal_wall_thickness_m),
          AT(defence_area_is_box),
          AT(robots),
          AT(rule_numbers),
          AT(params),
          AT(rules)};
}

Layout layout_of_abilities() {
  using Record = FlatAbilities;
  return {AT(speed_mps), AT(acceleration_mps2), AT(braking_mps2), AT(kick_mps), AT(chip_mps)};
}

Layout layout_of_number() {
  using Record = FlatNumber;
  return {AT(name), AT(value)};
}

Layout layout_of_frame() {
  using Record = FlatFrame;
  return {AT(length),
          AT(kind),
          AT(is_detections),
          AT(frame),
          AT(time_s),
          AT(latency_s),
          AT(stage_time_left_s),
          AT(placement_x_m),
          AT(placement_y_m),
          AT(ball_x_m),
          AT(ball_y_m),
          AT(ball_vx_mps),
          AT(ball_vy_mps),
          AT(ball_height_m),
          AT(ball_height_deviation_m),
          AT(camera_x_m),
          AT(camera_y_m),
          AT(camera_height_m),
          AT(goals_own),
          AT(goals_opponent),
          AT(play),
          AT(ours),
          AT(has_placement),
          AT(placing),
          AT(next),
          AT(next_is_ours),
          AT(has_ball),
          AT(is_height_known),
          AT(own_robots),
          AT(opponent_robots),
          AT(ball_in_dribbler_zone),
          AT(reserved)};
}

Layout layout_of_robot() {
  using Record = FlatRobot;
  return {AT(x_m),
          AT(y_m),
          AT(heading_x),
          AT(heading_y),
          AT(vx_mps),
          AT(vy_mps),
          AT(angular_velocity_radps),
          AT(number),
          AT(is_seen)};
}

Layout layout_of_end() {
  using Record = FlatEnd;
  return {AT(length), AT(kind), AT(reserved), AT(goals_own), AT(goals_opponent), AT(reason)};
}

Layout layout_of_output() {
  using Record = FlatOutput;
  return {AT(length), AT(kind),     AT(timeout),    AT(frame),   AT(keeper),
          AT(leaves), AT(commands), AT(text_bytes), AT(reserved)};
}

Layout layout_of_command() {
  using Record = FlatCommand;
  return {AT(vx_mps),  AT(vy_mps),  AT(angular_velocity_radps), AT(kick_mps), AT(robot), AT(chip),
          AT(dribble), AT(reserved)};
}

#undef AT

std::size_t size_of(const DocumentedNumber& number) {
  static const std::map<std::string, std::size_t> kSizes = {{"u8", 1},  {"u16", 2},  {"u32", 4},
                                                            {"u64", 8}, {"i32", 4},  {"i64", 8},
                                                            {"f64", 8}, {"text", 56}};
  return kSizes.at(number.type);
}

TEST(FlatRecords, AreLaidOutAsDocumented) {
  const std::vector<Layout> layouts = {
      layout_of_start(), layout_of_abilities(), layout_of_number(), layout_of_frame(),
      layout_of_robot(), layout_of_end(),       layout_of_output(), layout_of_command()};
  EXPECT_EQ(documented_layouts(), layouts);
}

TEST(FlatRecords, HaveNoGaps) {
  const std::vector<std::size_t> sizes = {
      sizeof(FlatStart), sizeof(FlatAbilities), sizeof(FlatNumber), sizeof(FlatFrame),
      sizeof(FlatRobot), sizeof(FlatEnd),       sizeof(FlatOutput), sizeof(FlatCommand)};
  const std::vector<Layout> layouts = documented_layouts();
  ASSERT_EQ(layouts.size(), sizes.size());
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    std::size_t end = 0;
    for (const DocumentedNumber& number : layouts[i]) {
      EXPECT_EQ(number.offset, end) << number.name;
      end += size_of(number);
    }
    EXPECT_EQ(end, sizes[i]);
  }
}

// The bytes of a message, read as the documentation says.
class Documented {
 public:
  Documented(std::string bytes, std::size_t table, std::size_t begin = 0)
      : bytes_(std::move(bytes)), begin_(begin), layout_(documented_layouts().at(table)) {}

  template <typename Number>
  Number value(const std::string& name) const {
    for (const DocumentedNumber& number : layout_) {
      if (number.name != name) continue;
      EXPECT_EQ(number.type, type_name<Number>()) << name;
      Number value;
      std::memcpy(&value, bytes_.data() + begin_ + number.offset, sizeof value);
      return value;
    }
    ADD_FAILURE() << name << " is not documented";
    return {};
  }
  double f64(const std::string& name) const { return value<double>(name); }
  int u8(const std::string& name) const { return value<std::uint8_t>(name); }
  int u16(const std::string& name) const { return value<std::uint16_t>(name); }
  int u32(const std::string& name) const { return static_cast<int>(value<std::uint32_t>(name)); }
  int i32(const std::string& name) const { return value<std::int32_t>(name); }

 private:
  std::string bytes_;
  std::size_t begin_;
  Layout layout_;
};

constexpr std::size_t kFrameTable = 3;
constexpr std::size_t kRobotTable = 4;

template <typename Message>
std::string flat_bytes(const Message& message) {
  std::string bytes;
  make_team_codec(TeamEncoding::kFlat)->append(message, bytes);
  return bytes;
}

TeamFrame frame_with_a_robot_each() {
  TeamFrame frame;
  TeamView& view = frame.view;
  view.frame = 1234567890123;
  view.time_s = 1.5;
  view.latency_s = 0.04;
  view.stage_time_left_s = 299.5;
  view.placement_m = Vec2(-1, 2);
  view.ball = {{0.1, 0.2}, {0.3, 0.4}, 0.5, 0.6, true};
  view.own.push_back({3, {1, 2}, {0, 1}, {3, 4}, 5, false});
  view.opponents.push_back({15, {-1, -2}, {1, 0}, {-3, -4}, -5, true});
  view.play = Play::kStop;
  view.placing_is_ours = true;
  view.next = CommandKind::kDirectFree;
  view.next_is_ours = true;
  view.goals_own = 7;
  view.goals_opponent = 9;
  frame.ball_in_dribbler_zone.set(3);
  return frame;
}

TEST(FlatFrame, HasTheRefereesNumbersWhereDocumented) {
  const Documented frame(flat_bytes(frame_with_a_robot_each()), kFrameTable);
  EXPECT_EQ(frame.u32("length"), 152 + 2 * 64);
  EXPECT_EQ(frame.u16("kind"), 2);
  EXPECT_EQ(frame.value<std::int64_t>("frame"), 1234567890123);
  EXPECT_EQ(frame.f64("time_s"), 1.5);
  EXPECT_EQ(frame.f64("latency_s"), 0.04);
  EXPECT_EQ(frame.f64("stage_time_left_s"), 299.5);
  EXPECT_EQ(frame.f64("placement_x_m"), -1);
  EXPECT_EQ(frame.f64("placement_y_m"), 2);
  EXPECT_EQ(frame.i32("goals_own"), 7);
  EXPECT_EQ(frame.i32("goals_opponent"), 9);
  EXPECT_EQ(frame.u8("play"), 1);
  EXPECT_EQ(frame.u8("ours"), 0);
  EXPECT_EQ(frame.u8("has_placement"), 1);
  EXPECT_EQ(frame.u8("placing"), 2);
  EXPECT_EQ(frame.u8("next"), 6);
  EXPECT_EQ(frame.u8("next_is_ours"), 1);
}

TEST(FlatFrame, HasTheBallWhereDocumented) {
  const Documented frame(flat_bytes(frame_with_a_robot_each()), kFrameTable);
  EXPECT_EQ(frame.u8("has_ball"), 1);
  EXPECT_EQ(frame.f64("ball_x_m"), 0.1);
  EXPECT_EQ(frame.f64("ball_y_m"), 0.2);
  EXPECT_EQ(frame.f64("ball_vx_mps"), 0.3);
  EXPECT_EQ(frame.f64("ball_vy_mps"), 0.4);
  EXPECT_EQ(frame.f64("ball_height_m"), 0.5);
  EXPECT_EQ(frame.f64("ball_height_deviation_m"), 0.6);
  EXPECT_EQ(frame.u8("is_height_known"), 1);
  EXPECT_EQ(frame.u16("ball_in_dribbler_zone"), 8);
}

TEST(FlatFrame, HasTheOwnRobotsFirst) {
  const std::string bytes = flat_bytes(frame_with_a_robot_each());
  const Documented frame(bytes, kFrameTable);
  EXPECT_EQ(frame.u8("own_robots"), 1);
  EXPECT_EQ(frame.u8("opponent_robots"), 1);
  const Documented own(bytes, kRobotTable, 152);
  EXPECT_EQ(own.i32("number"), 3);
  EXPECT_EQ(own.f64("x_m"), 1);
  EXPECT_EQ(own.f64("y_m"), 2);
  EXPECT_EQ(own.f64("heading_x"), 0);
  EXPECT_EQ(own.f64("heading_y"), 1);
  EXPECT_EQ(own.f64("vx_mps"), 3);
  EXPECT_EQ(own.f64("vy_mps"), 4);
  EXPECT_EQ(own.f64("angular_velocity_radps"), 5);
  EXPECT_EQ(own.u32("is_seen"), 0);
  EXPECT_EQ(Documented(bytes, kRobotTable, 152 + 64).i32("number"), 15);
}

TEST(FlatFrame, SaysThatNothingIsKnown) {
  TeamFrame nothing;
  nothing.detections.emplace();
  const Documented frame(flat_bytes(nothing), kFrameTable);
  EXPECT_EQ(frame.u32("length"), 152);
  EXPECT_EQ(frame.u16("is_detections"), 1);
  EXPECT_EQ(frame.u8("has_ball"), 0);
  EXPECT_EQ(frame.u8("has_placement"), 0);
  EXPECT_EQ(frame.u8("placing"), 0);
  EXPECT_EQ(frame.u8("next"), 255);
}

TEST(FlatStart, IsFollowedByRobotsRulesAndParameters) {
  TeamStart start;
  start.rules = *find_rule_book("2026-b");
  start.robots.push_back({1, 2, 3, 4, 5});
  start.params["line_m"] = 0.25;
  const std::string bytes = flat_bytes(start);
  const Documented head(bytes, 0);
  EXPECT_EQ(head.u16("kind"), 1);
  EXPECT_EQ(std::string(head.value<std::array<char, 56>>("rules").data()), "2026-b");
  const Documented robot(bytes, 1, 208);
  EXPECT_EQ(robot.f64("speed_mps"), 1);
  EXPECT_EQ(robot.f64("chip_mps"), 5);
  const Documented rule(bytes, 2, 208 + 40);
  EXPECT_EQ(std::string(rule.value<std::array<char, 56>>("name").data()), "stillness_m");
  EXPECT_EQ(rule.f64("value"), 0.015);
  const Documented param(bytes, 2, bytes.size() - 64);
  EXPECT_EQ(std::string(param.value<std::array<char, 56>>("name").data()), "line_m");
  EXPECT_EQ(param.f64("value"), 0.25);
}

}  // namespace
}  // namespace autoref::league
