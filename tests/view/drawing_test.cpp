#include "view/drawing.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace autoref::view {
namespace {

constexpr const char* kYellow = "#ffd43b";
constexpr const char* kBlue = "#4a9dff";

// The line of the drawing that begins at the north post of the goal at this end; x in mm.
std::string goal_at(const std::string& x_mm, bool blue_on_positive_half) {
  RefereeSignal signal;
  signal.blue_on_positive_half = blue_on_positive_half;
  const std::string svg = drawing_of({Field{}, {}, signal, {Frame{}}});
  const std::size_t begin = svg.find("<path d=\"M " + x_mm + " -350 L");
  return begin == std::string::npos ? "" : svg.substr(begin, svg.find('\n', begin) - begin);
}

// The goals of the paper's field are 6.05 m apart and 0.7 m wide.
TEST(Drawing, PaintsEachGoalInTheColourOfTheTeamThatDefendsIt) {
  EXPECT_NE(goal_at("-3025", true).find(kYellow), std::string::npos);
  EXPECT_NE(goal_at("3025", true).find(kBlue), std::string::npos);
  EXPECT_NE(goal_at("-3025", false).find(kBlue), std::string::npos);
  EXPECT_NE(goal_at("3025", false).find(kYellow), std::string::npos);
}

// The caption's y in mm, downwards, and its font size.
struct DrawnCaption {
  double y_mm = 0;
  double size_mm = 0;
};

DrawnCaption caption_in(const std::string& svg) {
  const std::size_t end = svg.find(" id=\"caption\"");
  const std::size_t y = svg.rfind(" y=\"", end);
  const std::size_t size = svg.find("font-size=\"", end);
  return {std::stod(svg.substr(y + 4)), std::stod(svg.substr(size + 11))};
}

// Robots are never beyond the walls, here 2.325 m from the centre.
TEST(Drawing, HasItsCaptionAboveTheCarpetWhereItCoversNoRobot) {
  const Field field;
  const std::string svg = drawing_of({field, {}, RefereeSignal{}, {Frame{}, Frame{}}});
  const DrawnCaption caption = caption_in(svg);
  EXPECT_LT(caption.y_mm + 0.3 * caption.size_mm, -1000 * field.wall_y_m());
  const std::string top = fmt::format("viewBox=\"{:.0f} ", -1000 * field.wall_x_m());
  const std::size_t view = svg.find(top);
  ASSERT_NE(view, std::string::npos);
  EXPECT_GT(caption.y_mm - caption.size_mm, std::stod(svg.substr(view + top.size())));
}

TEST(Drawing, WritesALongCaptionSmaller) {
  const PerSide<std::string> names = {{std::string(60, 'm'), std::string(60, 'm')}};
  EXPECT_LT(caption_in(drawing_of({Field{}, names, RefereeSignal{}, {Frame{}}})).size_mm,
            caption_in(drawing_of({Field{}, {}, RefereeSignal{}, {Frame{}}})).size_mm);
}

}  // namespace
}  // namespace autoref::view
