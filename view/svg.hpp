// Writes drawings as SVG.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "soccer/geometry.hpp"
#include "view/field_marks.hpp"

namespace autoref::view {

inline constexpr std::string_view kSvgFont = R"(font-family="DejaVu Sans, Helvetica, sans-serif")";

// Average width of a letter as a fraction of the font size.
inline constexpr double kLetterWidth = 0.62;

// Positions are in metres, y upwards. `look` adds SVG attributes to an element, such as
// `fill="red"`. Coordinates are written in whole millimetres, which keeps the text short and the
// same with every compiler.
class Svg {
 public:
  // The drawing shows the rectangle between two corners, and is `kWidth_px` wide.
  Svg(const Vec2& min_m, const Vec2& max_m);

  static constexpr double kWidth_px = 960;

  void line(std::span<const Vec2> points_m, std::string_view look);
  void arc(const MarkArc& arc, std::string_view look);
  void disc(const Vec2& centre_m, double radius_m, std::string_view look);
  // The rectangle between two corners.
  void box(const Vec2& min_m, const Vec2& max_m, std::string_view look);
  // A disc cut off along the chord between the ends of the arc.
  void cut_disc(const MarkArc& arc, std::string_view look);
  // The position is that of the start of the baseline, unless `look` changes the anchor.
  void text(const Vec2& position_m, std::string_view text, std::string_view look);
  // Starts a group: all elements until end_group() share the look.
  void begin_group(std::string_view look);
  // Starts a group whose positions are relative to `origin_m`.
  void begin_group_at(const Vec2& origin_m);
  void end_group() { body_ += "</g>\n"; }

  // Draws an outline, with the group's look.
  void outline(const Outline& outline);

  // The text of the whole file.
  std::string text() const { return body_ + "</svg>\n"; }

 private:
  std::string body_;
};

}  // namespace autoref::view
