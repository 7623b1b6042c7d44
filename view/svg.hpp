// An SVG drawing in the field's millimetres.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "soccer/geometry.hpp"
#include "view/field_marks.hpp"

namespace autoref::view {

// Positions are in metres in the field's frame, y upwards. `look` adds SVG attributes to an
// element, such as `fill="red"`.
class Svg {
 public:
  // Shows everything within `half_size_m` of the field's centre, and a white band of this height
  // above it.
  Svg(const Vec2& half_size_m, double band_m);

  void line(std::span<const Vec2> points_m, std::string_view look);
  void arc(const MarkArc& arc, std::string_view look);
  void disc(const Vec2& centre_m, double radius_m, std::string_view look);
  void box(const Vec2& half_size_m, std::string_view look);
  // A disc cut off along the chord between the ends of the arc.
  void cut_disc(const MarkArc& arc, std::string_view look);
  void text(const Vec2& position_m, std::string_view text, std::string_view look);
  // Starts a group: all elements until end_group() share the look.
  void begin_group(std::string_view look);
  void end_group() { body_ += "</g>\n"; }

  // The text of the whole file.
  std::string text() const { return body_ + "</svg>\n"; }

 private:
  std::string body_;
};

}  // namespace autoref::view
