#include "runner/view/drawing.hpp"

#include <gtest/gtest.h>

namespace autoref::runner {
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

}  // namespace
}  // namespace autoref::runner
