#include "view/svg.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace autoref::view {
namespace {

// Slightly less than a full turn, since the ends of arcs in the league's packets are floats.
constexpr double kFullTurn_rad = 2 * kPi - 1e-3;

long mm(double metres) { return std::lround(metres * 1000); }

// SVG's y axis points down.
std::string point(const Vec2& position_m) {
  return fmt::format("{} {}", mm(position_m.x()), mm(-position_m.y()));
}

// XML does not allow control characters, not even escaped.
std::string escaped(std::string_view text) {
  std::string escaped;
  for (const char letter : text) {
    if (letter == '<') {
      escaped += "&lt;";
    } else if (letter == '>') {
      escaped += "&gt;";
    } else if (letter == '&') {
      escaped += "&amp;";
    } else {
      escaped += static_cast<unsigned char>(letter) < 0x20 ? ' ' : letter;
    }
  }
  return escaped;
}

// The arc as an SVG path, counterclockwise.
std::string path_of(const MarkArc& arc) {
  const Vec2 from = arc.centre_m + arc.radius_m * heading_of(arc.from_rad);
  const Vec2 to = arc.centre_m + arc.radius_m * heading_of(arc.to_rad);
  return fmt::format("M {} A {} {} 0 {} 0 {}", point(from), mm(arc.radius_m), mm(arc.radius_m),
                     arc.to_rad - arc.from_rad > kPi ? 1 : 0, point(to));
}

}  // namespace

Svg::Svg(const Vec2& min_m, const Vec2& max_m) {
  const Vec2 size_m = max_m - min_m;
  body_ = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" height=\"{:.0f}\" "
      "viewBox=\"{} {} {} {}\">\n",
      kWidth_px, kWidth_px * size_m.y() / size_m.x(), mm(min_m.x()), mm(-max_m.y()), mm(size_m.x()),
      mm(size_m.y()));
}

void Svg::line(std::span<const Vec2> points_m, std::string_view look) {
  std::string path;
  for (const Vec2& position_m : points_m)
    path += fmt::format("{}{}", path.empty() ? "M " : " L ", point(position_m));
  body_ += fmt::format("<path d=\"{}\" {}/>\n", path, look);
}

void Svg::arc(const MarkArc& arc, std::string_view look) {
  if (arc.to_rad - arc.from_rad >= kFullTurn_rad) return disc(arc.centre_m, arc.radius_m, look);
  body_ += fmt::format("<path d=\"{}\" {}/>\n", path_of(arc), look);
}

void Svg::disc(const Vec2& centre_m, double radius_m, std::string_view look) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", mm(centre_m.x()),
                       mm(-centre_m.y()), mm(radius_m), look);
}

void Svg::box(const Vec2& min_m, const Vec2& max_m, std::string_view look) {
  body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>\n", mm(min_m.x()),
                       mm(-max_m.y()), mm(max_m.x() - min_m.x()), mm(max_m.y() - min_m.y()), look);
}

void Svg::cut_disc(const MarkArc& arc, std::string_view look) {
  body_ += fmt::format("<path d=\"{} Z\" {}/>\n", path_of(arc), look);
}

void Svg::text(const Vec2& position_m, std::string_view text, std::string_view look) {
  body_ += fmt::format("<text x=\"{}\" y=\"{}\" {}>{}</text>\n", mm(position_m.x()),
                       mm(-position_m.y()), look, escaped(text));
}

void Svg::begin_group(std::string_view look) { body_ += fmt::format("<g {}>\n", look); }

void Svg::begin_group_at(const Vec2& origin_m) {
  begin_group(fmt::format("transform=\"translate({})\"", point(origin_m)));
}

void Svg::outline(const Outline& outline) {
  for (const MarkLine& line : outline.lines) this->line(std::array{line.from_m, line.to_m}, "");
  for (const MarkArc& arc : outline.arcs) this->arc(arc, "");
}

}  // namespace autoref::view
