#include "view/drawing.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "io/table.hpp"
#include "soccer/geometry.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/robot_shape.hpp"
#include "view/field_marks.hpp"
#include "view/svg.hpp"

namespace autoref::view {
namespace {

constexpr double kCaption_m = 0.12;  // largest font size
// Height of the band above the carpet, where no robot is.
constexpr double kCaptionBand_m = 0.22;
constexpr double kShownBallRadius_m = 0.035;  // larger than in reality, to be visible
constexpr double kFarthestStep_m = 0.4;       // a larger step is a placement, not motion
constexpr double kShortestStep_m = 0.015;
constexpr int kStrengths = 12;  // opacity levels along a path

constexpr std::string_view kBallColor = "#ff7b1c";

std::string_view color_of(Side side) { return side == Side::kWest ? "#ffd43b" : "#4a9dff"; }

// Positions of an object in the frames; nullopt if it was not seen.
using Track = std::vector<std::optional<Vec2>>;

Track ball_track(const std::vector<Frame>& frames) {
  Track track;
  for (const Frame& frame : frames)
    track.push_back(frame.ball ? std::optional(frame.ball->position_m) : std::nullopt);
  return track;
}

Track robot_track(const std::vector<Frame>& frames, RobotId robot) {
  Track track;
  for (const Frame& frame : frames) {
    const SeenRobots& seen = frame.robots[robot.side];
    const auto found = std::find_if(seen.begin(), seen.end(),
                                    [&](const auto& one) { return one.number == robot.number; });
    track.push_back(found != seen.end() ? std::optional(found->position_m) : std::nullopt);
  }
  return track;
}

// Draws a part of a path with uniform opacity, leaving out some of its points.
void draw_piece(const Track& track, std::size_t begin, std::size_t end, Svg& svg,
                std::string_view look) {
  std::vector<Vec2> points;
  const auto finish = [&] {
    if (points.size() > 1) svg.line(points, look);
    points.clear();
  };
  for (std::size_t i = begin; i < end; ++i) {
    const bool is_jump =
        track[i] && !points.empty() && (*track[i] - points.back()).norm() > kFarthestStep_m;
    if (!track[i] || is_jump) finish();
    if (!track[i]) continue;
    const bool is_last = i + 1 == end;
    if (points.empty() || is_last || (*track[i] - points.back()).norm() > kShortestStep_m)
      points.push_back(*track[i]);
  }
  finish();
}

void draw_path(const Track& track, std::string_view color, double width_m, Svg& svg) {
  const std::size_t steps = track.size() - 1;
  for (std::size_t piece = 0; piece < kStrengths; ++piece) {
    // A path has one opacity in SVG, so a fading path is drawn in pieces; neighbours share a point.
    const std::size_t begin = steps * piece / kStrengths;
    const std::size_t end = steps * (piece + 1) / kStrengths;
    draw_piece(track, begin, end + 1, svg,
               fmt::format(R"(stroke="{}" stroke-width="{:.0f}" stroke-opacity="{:.2f}")", color,
                           width_m * 1000, static_cast<double>(piece + 1) / kStrengths));
  }
  const auto first = std::find_if(track.begin(), track.end(), [](const auto& at) { return at; });
  if (first == track.end()) return;
  svg.disc(**first, 0.05, fmt::format(R"(class="begin" stroke="{}" stroke-width="14")", color));
}

void draw_paths(const DrawnGame& game, Svg& svg) {
  svg.begin_group(R"(id="ways" fill="none" stroke-linecap="round" stroke-linejoin="round")");
  for (const Side side : kSides) {
    for (int number = 0; number < kMaxRobots; ++number)
      draw_path(robot_track(game.frames, {side, number}), color_of(side), 0.02, svg);
  }
  draw_path(ball_track(game.frames), kBallColor, 0.028, svg);
  svg.end_group();
}

void draw_field(const Field& field, bool blue_on_positive_half, Svg& svg) {
  const Vec2 wall_m(field.wall_x_m(), field.wall_y_m());
  const Vec2 corner_m(field.half_length_m(), field.half_width_m());
  svg.box(-wall_m, wall_m, R"(fill="#174c36")");
  svg.box(-corner_m, corner_m, R"(fill="#1c5b40")");
  svg.begin_group(fmt::format(R"(id="field" fill="none" stroke="#f2f7f4" stroke-width="{:.0f}")",
                              std::max(field.line_width_m, 0.012) * 1000));
  svg.outline(field_lines(field));
  for (const Side end : kSides) {
    svg.disc(field.penalty_mark_at(end), 0.01, R"(fill="#f2f7f4")");
    svg.line(goal_walls_m(field, end), fmt::format(R"(stroke="{}" stroke-width="24")",
                                                   color_of(side_at(end, blue_on_positive_half))));
  }
  svg.end_group();
}

void draw_robot(Side side, const RobotObservation& robot, Svg& svg) {
  // The front plate is a chord at this distance from the centre; the arc is the rest of the circle.
  const double half_rad = std::acos(kFrontDistance_m / kRobotRadius_m);
  const double heading_rad = angle_of(robot.heading);
  const MarkArc round{robot.position_m, kRobotRadius_m, heading_rad + half_rad,
                      heading_rad - half_rad + 2 * kPi};
  svg.begin_group(R"(class="robot")");
  svg.cut_disc(round,
               fmt::format(R"(fill="{}" stroke="#0b1a12" stroke-width="8")", color_of(side)));
  svg.line(std::array<Vec2, 2>{robot.position_m + kRobotRadius_m * heading_of(round.from_rad),
                               robot.position_m + kRobotRadius_m * heading_of(round.to_rad)},
           R"(stroke="#ffffff" stroke-width="16" stroke-linecap="round")");
  // Shift the text down by a third of its size to centre it.
  svg.text(robot.position_m - Vec2(0, 0.04), std::to_string(robot.number),
           R"(fill="#0b1a12" font-size="115" font-weight="bold" text-anchor="middle")");
  svg.end_group();
}

void draw_ball(const BallObservation& ball, Svg& svg) {
  svg.begin_group(R"(class="ball")");
  svg.disc(ball.position_m, kShownBallRadius_m,
           fmt::format(R"(fill="{}" stroke="#ffffff" stroke-width="10")", kBallColor));
  if (ball.height_m.value_or(0) > 0.03) {
    svg.text(ball.position_m + Vec2(0, 0.07), fmt::format("{:.2f} m high", *ball.height_m),
             R"(fill="#ffffff" font-size="90" text-anchor="middle")");
  }
  svg.end_group();
}

std::string name_of_team(const DrawnGame& game, Side side) {
  const std::string& name = game.names[side];
  return !name.empty() ? name : side == Side::kWest ? "yellow" : "blue";
}

std::string time_text(const DrawnGame& game) {
  const double from_s = game.frames.front().time_s;
  const double to_s = game.frames.back().time_s;
  return game.frames.size() == 1 ? fmt::format("{:.2f} s", to_s)
                                 : fmt::format("{:.2f} s to {:.2f} s", from_s, to_s);
}

std::string caption(const DrawnGame& game) {
  if (!game.signal) return time_text(game);
  const RefereeSignal& signal = *game.signal;
  return fmt::format("{} | {} {} : {} {} | {}, {}", time_text(game),
                     name_of_team(game, Side::kWest), signal.goals[Side::kWest],
                     signal.goals[Side::kEast], name_of_team(game, Side::kEast),
                     name_of(signal.stage), name_of(signal.command));
}

// Writes the caption into the band above the carpet, smaller if it is too long for one line.
void draw_caption(const std::string& text, const Vec2& half_size_m, Svg& svg) {
  constexpr double kMargin_m = 0.08;
  const double length_m = 2 * (half_size_m.x() - kMargin_m);
  const double letters = static_cast<double>(io::width_of(text));
  const double size_m = std::min(kCaption_m, length_m / (kLetterWidth * std::max(1.0, letters)));
  svg.text({-half_size_m.x() + kMargin_m, half_size_m.y() + kMargin_m}, text,
           fmt::format(R"(id="caption" fill="#17302a" font-size="{:.0f}")", size_m * 1000));
}

}  // namespace

std::string drawing_of(const DrawnGame& game) {
  const Field& field = game.field;
  const Vec2 half_size_m(field.wall_x_m(), field.wall_y_m());
  const Vec2 top_m = half_size_m + Vec2(0, kCaptionBand_m);
  Svg svg(-half_size_m, top_m);
  svg.box({-half_size_m.x(), half_size_m.y()}, top_m, R"(fill="#ffffff")");
  draw_field(field, !game.signal || game.signal->blue_on_positive_half, svg);
  if (game.frames.size() > 1) draw_paths(game, svg);
  const Frame& last = game.frames.back();
  svg.begin_group(kSvgFont);
  for (const Side side : kSides)
    for (const RobotObservation& robot : last.robots[side]) draw_robot(side, robot, svg);
  if (last.ball) draw_ball(*last.ball, svg);
  draw_caption(caption(game), half_size_m, svg);
  svg.end_group();
  return svg.text();
}

}  // namespace autoref::view
