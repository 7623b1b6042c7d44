#include "view/svg.hpp"

#include <fmt/format.h>

#include <cmath>

namespace autoref::view {
namespace {

constexpr double kSvgWidth_px = 960;
constexpr double kFullTurn_rad =
    2 * kPi - 1e-3;  // slightly less than a full turn, since arc ends in league packets are floats

long mm(double metres) { return std::lround(metres * 1000); }

std::string point(const Vec2& position_m) {
  // SVG's y axis points down. With whole millimetres, the text is short and the same with every
  // compiler.
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

Svg::Svg(const Vec2& half_size_m, double band_m)
    : body_(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" "
                        "height=\"{:.0f}\" viewBox=\"{} {} {} {}\">\n",
                        kSvgWidth_px,
                        kSvgWidth_px * (2 * half_size_m.y() + band_m) / (2 * half_size_m.x()),
                        mm(-half_size_m.x()), mm(-half_size_m.y() - band_m),
                        mm(2 * half_size_m.x()), mm(2 * half_size_m.y() + band_m))) {
  body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#ffffff\"/>\n",
                       mm(-half_size_m.x()), mm(-half_size_m.y() - band_m), mm(2 * half_size_m.x()),
                       mm(band_m));
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

void Svg::box(const Vec2& half_size_m, std::string_view look) {
  body_ +=
      fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>\n", mm(-half_size_m.x()),
                  mm(-half_size_m.y()), mm(2 * half_size_m.x()), mm(2 * half_size_m.y()), look);
}

void Svg::cut_disc(const MarkArc& arc, std::string_view look) {
  body_ += fmt::format("<path d=\"{} Z\" {}/>\n", path_of(arc), look);
}

void Svg::text(const Vec2& position_m, std::string_view text, std::string_view look) {
  body_ += fmt::format("<text x=\"{}\" y=\"{}\" {}>{}</text>\n", mm(position_m.x()),
                       mm(-position_m.y()), look, escaped(text));
}

void Svg::begin_group(std::string_view look) { body_ += fmt::format("<g {}>\n", look); }

}  // namespace autoref::view
