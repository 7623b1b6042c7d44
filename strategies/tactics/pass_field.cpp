#include "strategies/tactics/pass_field.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"
#include "strategies/skills/openings.hpp"

namespace autoref::strategies {
namespace {

constexpr int kPerFrame = 4;  // cells updated per frame
constexpr int kSweep_frames = PassField::kCells / kPerFrame;

}  // namespace

double chance_at(const PredictedState& predicted, const Vec2& point_m, int mate) {
  const TeamView& now = predicted.now();
  const ShotTerms terms{predicted.style().shot_mps, mate, predicted.context().kicks.direction_rad};
  return widest_opening(predicted.field(), point_m, now.opponents, now.own, terms).chance;
}

double worth_of(const PredictedState& predicted, double chance, const Vec2& point_m,
                const Vec2& from_m) {
  const Field& field = predicted.field();
  const Vec2 to_goal = direction_of(field.goal_centre_m(Side::kEast) - point_m, Vec2(1, 0));
  const Vec2 back = direction_of(from_m - point_m, Vec2(-1, 0));
  const double fit = std::clamp((to_goal.dot(back) - predicted.style().first_time_cosine) /
                                    predicted.style().first_time_cosine,
                                0.0, 1.0);
  const double shot =
      chance * (predicted.style().stopped_share + (1 - predicted.style().stopped_share) * fit);
  const double ahead = (point_m.x() / field.half_length_m() + 1) / 2;
  return (1 - predicted.style().ahead_worth) * shot + predicted.style().ahead_worth * ahead;
}

PassField::PassField(const PredictedState& predicted)
    : predicted_(predicted), held_frames_(std::llround(predicted.style().receiver_hold_frames)) {
  const Field& field = predicted.field();
  const double back_m = predicted.style().line_m;
  const double front_m = field.half_length_m() - predicted.style().receivers_from_edge_m;
  const double aside_m =
      (field.half_width_m() - predicted.style().receivers_from_edge_m) * predicted.style().width;
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
  positions_m_.fill(Vec2(0, 0));
}

// Values are read when positions are chosen. Values computed earlier than one sweep before the next
// choice would be replaced before they are read, so they are not computed.
void PassField::update() {
  if (predicted_.now().frame + kSweep_frames <= settle_frame_ + held_frames_) {
    next_ = (next_ + kPerFrame) % kCells;
    return;
  }
  const Vec2& ball_m = predicted_.position_m();
  const double unsafe = predicted_.style().unsafe_share;
  for (int i = 0; i < kPerFrame; ++i) {
    const auto at = static_cast<std::size_t>(next_);
    const Vec2& cell_m = cells_m_[at];
    const double safety =
        pass_safety(ball_m, cell_m, predicted_.style().field_pass_mps, predicted_.now().opponents);
    const double chance = chance_at(predicted_, cell_m, -1);
    values_[at] = worth_of(predicted_, chance, cell_m, ball_m) * (unsafe + (1 - unsafe) * safety);
    next_ = (next_ + 1) % kCells;
  }
}

double PassField::value_for(
    int index, int cell, const boost::container::static_vector<Vec2, kMaxRobots>& taken_m) const {
  const Vec2& cell_m = cells_m_[static_cast<std::size_t>(cell)];
  const TrackedRobot& robot = predicted_.robot(index);
  // While play is stopped, everyone waits for the robot with the longest path.
  const double far_per_m = predicted_.is_waiting() ? predicted_.style().far_cost_in_stop_per_m
                                                   : predicted_.style().far_cost_per_m;
  double value =
      values_[static_cast<std::size_t>(cell)] - far_per_m * (cell_m - robot.position_m).norm();
  // Soft constraints: the penalty grows linearly as another receiver or the ball gets nearer.
  for (const Vec2& other_m : taken_m) {
    const double near = 1 - (cell_m - other_m).norm() / predicted_.style().receivers_apart_m;
    if (near > 0) value -= near;
  }
  const double to_ball_m = (cell_m - predicted_.position_m()).norm();
  if (to_ball_m < predicted_.style().receivers_apart_m)
    value -= 1 - to_ball_m / predicted_.style().receivers_apart_m;
  if ((cell_m - position_of(robot.number)).squaredNorm() < 1e-6)
    value += predicted_.style().receiver_loyalty;
  return value;
}

void PassField::send(const boost::container::static_vector<int, kMaxRobots>& receivers) {
  const bool was_sent = settle_frame_ >= 0;
  if (is_restart(predicted_.now().play) && was_sent)
    return;  // receivers do not run before the ball is in play
  if (predicted_.now().frame - settle_frame_ < held_frames_) return;
  settle_frame_ = predicted_.now().frame;
  boost::container::static_vector<Vec2, kMaxRobots> taken_m;
  const double most_bonus = std::max(0.0, predicted_.style().receiver_loyalty);
  for (const int index : receivers) {
    int best = 0;
    double best_value = -1e9;
    for (int cell = 0; cell < kCells; ++cell) {
      // All other terms of value_for are costs.
      if (values_[static_cast<std::size_t>(cell)] + most_bonus <= best_value) continue;
      const double value = value_for(index, cell, taken_m);
      if (value <= best_value) continue;
      best_value = value;
      best = cell;
    }
    const Vec2& position_m = cells_m_[static_cast<std::size_t>(best)];
    positions_m_[static_cast<std::size_t>(predicted_.robot(index).number)] = position_m;
    taken_m.push_back(position_m);
  }
}

}  // namespace autoref::strategies
