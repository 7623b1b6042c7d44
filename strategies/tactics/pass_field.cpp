#include "strategies/tactics/pass_field.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"
#include "strategies/skills/openings.hpp"

namespace autoref::strategies {
namespace {

constexpr int kPerFrame = 4;  // cells valued in a frame

}  // namespace

double chance_at(const Outlook& outlook, const Vec2& point_m, int mate) {
  const TeamView& now = outlook.now();
  const ShotTerms terms{outlook.style().shot_mps, mate};
  return widest_opening(outlook.field(), point_m, now.opponents, now.own, terms).chance;
}

double worth_of(const Outlook& outlook, double chance, const Vec2& point_m, const Vec2& from_m) {
  const Field& field = outlook.field();
  const Vec2 to_goal = direction_of(field.goal_centre_m(Side::kEast) - point_m, Vec2(1, 0));
  const Vec2 back = direction_of(from_m - point_m, Vec2(-1, 0));
  const double fit = std::clamp(
      (to_goal.dot(back) - outlook.style().first_time_cosine) / outlook.style().first_time_cosine,
      0.0, 1.0);
  const double shot =
      chance * (outlook.style().stopped_share + (1 - outlook.style().stopped_share) * fit);
  const double ahead = (point_m.x() / field.half_length_m() + 1) / 2;
  return (1 - outlook.style().ahead_worth) * shot + outlook.style().ahead_worth * ahead;
}

PassField::PassField(const Outlook& outlook) : outlook_(outlook) {
  const Field& field = outlook.field();
  const double back_m = outlook.style().line_m;
  const double front_m = field.half_length_m() - outlook.style().receivers_from_edge_m;
  const double aside_m =
      (field.half_width_m() - outlook.style().receivers_from_edge_m) * outlook.style().width;
  for (int i = 0; i < kCells; ++i) {
    const int column = i % kColumns;
    const int row = i / kColumns;
    const double along = column / (kColumns - 1.0);
    const double across = row / (kRows - 1.0);
    const Vec2 wanted_m(back_m + along * (front_m - back_m), (2 * across - 1) * aside_m);
    Limits limits;
    limits.keep_from_area_m = kRobotRadius_m;
    cells_m_[static_cast<std::size_t>(i)] = permitted(field, wanted_m, Vec2(0, 0), limits);
  }
  places_m_.fill(Vec2(0, 0));
}

void PassField::update() {
  const Vec2& ball_m = outlook_.place_m();
  const double unsafe = outlook_.style().unsafe_share;
  for (int i = 0; i < kPerFrame; ++i) {
    const auto at = static_cast<std::size_t>(next_);
    const Vec2& cell_m = cells_m_[at];
    const double safety =
        pass_safety(ball_m, cell_m, outlook_.style().field_pass_mps, outlook_.now().opponents);
    const double chance = chance_at(outlook_, cell_m, -1);
    values_[at] = worth_of(outlook_, chance, cell_m, ball_m) * (unsafe + (1 - unsafe) * safety);
    next_ = (next_ + 1) % kCells;
  }
}

double PassField::value_for(
    int index, int cell, const boost::container::static_vector<Vec2, kMaxRobots>& taken_m) const {
  const Vec2& cell_m = cells_m_[static_cast<std::size_t>(cell)];
  const TrackedRobot& robot = outlook_.robot(index);
  // While play is stopped, everybody waits for who has the longest way.
  const double far_per_m = outlook_.is_waiting() ? outlook_.style().far_cost_in_stop_per_m
                                                 : outlook_.style().far_cost_per_m;
  double value =
      values_[static_cast<std::size_t>(cell)] - far_per_m * (cell_m - robot.position_m).norm();
  for (const Vec2& other_m : taken_m) {
    const double near = 1 - (cell_m - other_m).norm() / outlook_.style().receivers_apart_m;
    if (near > 0) value -= near;
  }
  const double to_ball_m = (cell_m - outlook_.place_m()).norm();
  if (to_ball_m < outlook_.style().receivers_apart_m)
    value -= 1 - to_ball_m / outlook_.style().receivers_apart_m;
  if ((cell_m - place_of(robot.number)).squaredNorm() < 1e-6)
    value += outlook_.style().receiver_loyalty;
  return value;
}

void PassField::send(const boost::container::static_vector<int, kMaxRobots>& receivers) {
  const bool was_sent = settle_frame_ >= 0;
  if (is_restart(outlook_.now().play) && was_sent) return;  // nobody runs before the ball does
  const auto held_frames = std::llround(outlook_.style().receiver_hold_frames);
  if (outlook_.now().frame - settle_frame_ < held_frames) return;
  settle_frame_ = outlook_.now().frame;
  boost::container::static_vector<Vec2, kMaxRobots> taken_m;
  for (const int index : receivers) {
    int best = 0;
    double best_value = -1e9;
    for (int cell = 0; cell < kCells; ++cell) {
      const double value = value_for(index, cell, taken_m);
      if (value <= best_value) continue;
      best_value = value;
      best = cell;
    }
    const Vec2& place_m = cells_m_[static_cast<std::size_t>(best)];
    places_m_[static_cast<std::size_t>(outlook_.robot(index).number)] = place_m;
    taken_m.push_back(place_m);
  }
}

}  // namespace autoref::strategies
