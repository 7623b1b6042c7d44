// The flat encoding: records of fixed layout, little-endian, without padding. A record's first
// member is its length in bytes, including that of the parts that follow it. docs/team-programs.md
// lists these records; a test compares that list with this file.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "soccer/side.hpp"

namespace autoref::league {

static_assert(std::endian::native == std::endian::little);

enum class FlatKind : std::uint16_t { kStart = 1, kFrame = 2, kEnd = 3, kOutput = 4 };

// The record is followed by `robots` FlatAbilities, then by `rule_numbers` and `params` FlatNumber.
struct FlatStart {
  std::uint32_t length;
  FlatKind kind;
  std::uint16_t side;
  std::uint64_t random_seed;
  double frame_rate_hz;
  double latency_s;
  double length_m;
  double width_m;
  double run_off_m;
  double line_width_m;
  double centre_circle_radius_m;
  double penalty_mark_m;
  double defence_area_depth_m;
  double defence_area_straight_m;
  double goal_width_m;
  double goal_depth_m;
  double goal_opening_height_m;
  double goal_bar_radius_m;
  double goal_wall_thickness_m;
  std::uint32_t defence_area_is_box;
  std::uint32_t robots;
  std::uint32_t rule_numbers;
  std::uint32_t params;
  std::array<char, 56> rules;  // the rule book's name; names end with at least one zero byte
};

struct FlatAbilities {
  double speed_mps;
  double acceleration_mps2;
  double braking_mps2;
  double kick_mps;
  double chip_mps;
};

struct FlatNumber {
  std::array<char, 56> name;
  double value;
};

// The record is followed by `own_robots` and then `opponent_robots` FlatRobot. Members that do not
// apply are 0.
struct FlatFrame {
  std::uint32_t length;
  FlatKind kind;
  std::uint16_t is_detections;
  std::int64_t frame;
  double time_s;
  double latency_s;
  double stage_time_left_s;
  double placement_x_m;
  double placement_y_m;
  double ball_x_m;
  double ball_y_m;
  double ball_vx_mps;
  double ball_vy_mps;
  double ball_height_m;
  double ball_height_deviation_m;
  double camera_x_m;
  double camera_y_m;
  double camera_height_m;
  std::int32_t goals_own;
  std::int32_t goals_opponent;
  std::uint8_t play;
  std::uint8_t ours;
  std::uint8_t has_placement;
  std::uint8_t placing;
  std::uint8_t next;
  std::uint8_t next_is_ours;
  std::uint8_t has_ball;
  std::uint8_t is_height_known;
  std::uint8_t own_robots;
  std::uint8_t opponent_robots;
  std::uint16_t ball_in_dribbler_zone;
  std::uint32_t reserved;
};

inline constexpr std::uint8_t kFlatNoCommand = 255;  // FlatFrame::next
inline constexpr std::uint8_t kFlatPlacedByOpponents = 1;
inline constexpr std::uint8_t kFlatPlacedByOwn = 2;

struct FlatRobot {
  double x_m;
  double y_m;
  double heading_x;
  double heading_y;
  double vx_mps;
  double vy_mps;
  double angular_velocity_radps;
  std::int32_t number;
  std::uint32_t is_seen;
};

struct FlatEnd {
  std::uint32_t length;
  FlatKind kind;
  std::uint16_t reserved;
  std::int32_t goals_own;
  std::int32_t goals_opponent;
  std::array<char, 56> reason;
};

// The record is followed by `commands` FlatCommand and `text_bytes` bytes of text.
struct FlatOutput {
  std::uint32_t length;
  FlatKind kind;
  std::uint16_t timeout;
  std::int64_t frame;
  std::int32_t keeper;
  std::int32_t leaves;
  std::uint16_t commands;
  std::uint16_t text_bytes;
  std::uint32_t reserved;
};

struct FlatCommand {
  double vx_mps;
  double vy_mps;
  double angular_velocity_radps;
  double kick_mps;
  std::int32_t robot;
  std::uint8_t chip;
  std::uint8_t dribble;
  std::uint16_t reserved;
};

static_assert(sizeof(FlatStart) == 208 && sizeof(FlatAbilities) == 40 && sizeof(FlatNumber) == 64);
static_assert(sizeof(FlatFrame) == 152 && sizeof(FlatRobot) == 64 && sizeof(FlatEnd) == 72);
static_assert(sizeof(FlatOutput) == 32 && sizeof(FlatCommand) == 40);

}  // namespace autoref::league
