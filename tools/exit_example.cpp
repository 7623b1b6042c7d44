// Computes the two cases of the paper's Fig. 4 with the referee's own functions, for
// scripts/paper-figures:
//
//     exit_example     prints a line per case: the ball's x and y in the previous frame and in this
//     one,
//                      l_x, l_y, c_x, c_y, the exit's x and y, and which line it crossed; lengths
//                      in m
#include <fmt/format.h>

#include <array>

#include "referee/geometry/ball_out.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

struct BallPath {
  Vec2 before_m;
  Vec2 ball_m;
};

// Both paths are near the corner, and about as long as the distance that a ball at 8 m/s moves in
// one frame.
const std::array<BallPath, 2> kPaths = {{{{2.965, 2.000}, {3.070, 2.080}},    // (a)
                                         {{2.995, 1.965}, {3.085, 2.062}}}};  // (b)

void print_case(const Field& field, const BallPath& path) {
  const auto& [before_m, ball_m] = path;
  const Vec2 l_m(field.half_length_m() + kBallRadius_m, field.half_width_m() + kBallRadius_m);
  const double c_x =
      intersection(before_m.y(), before_m.x(), ball_m.y(), ball_m.x(), l_m.y()).value();
  const double c_y =
      intersection(before_m.x(), before_m.y(), ball_m.x(), ball_m.y(), l_m.x()).value();
  const Exit exit = find_exit(field, before_m, ball_m);
  for (const Vec2& point_m : {before_m, ball_m, l_m, Vec2(c_x, c_y), exit.point_m})
    fmt::print("{:.4f} {:.4f} ", point_m.x(), point_m.y());
  fmt::print("{}\n", exit.line == ExitLine::kTouch ? "touch" : "goal");
}

}  // namespace
}  // namespace autoref::referee

int main() {
  for (const auto& path : autoref::referee::kPaths) autoref::referee::print_case({}, path);
}
