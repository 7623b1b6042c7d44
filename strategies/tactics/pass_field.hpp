// A grid of pass values: the value of having the ball at each position, and whether a pass to it
// arrives.
#pragma once

#include <array>

#include "strategies/tactics/predicted_state.hpp"

namespace autoref::strategies {

// The chance, 0 to 1, that a shot from `point_m` scores. `mate` is the number of the team's robot
// that would take it, or -1.
double chance_at(const PredictedState& predicted, const Vec2& point_m, int mate);

// The value, 0 to 1, of a ball passed from `from_m` to `point_m`, given the `chance` that a shot
// from `point_m` scores. The value is largest if a first-time shot is possible, with a small bonus
// for being far upfield.
double worth_of(const PredictedState& predicted, double chance, const Vec2& point_m,
                const Vec2& from_m);

class PassField {
 public:
  static constexpr int kColumns = 8;  // cells along the field's length
  static constexpr int kRows = 6;
  static constexpr int kCells = kColumns * kRows;

  explicit PassField(const PredictedState& predicted);

  // Updates the next few cells, so that every cell has been updated once in the few frames before
  // positions are chosen.
  void update();

  // Chooses a position for each receiver (given by index), one after the other: the best cell that
  // is near the robot and far from the positions already chosen. Robots keep their positions for a
  // while.
  void send(const boost::container::static_vector<int, kMaxRobots>& receivers);

  // The position last assigned to the robot with that number.
  const Vec2& position_of(int number) const {
    return positions_m_[static_cast<std::size_t>(number)];
  }

 private:
  double value_for(int index, int cell,
                   const boost::container::static_vector<Vec2, kMaxRobots>& taken_m) const;

  const PredictedState& predicted_;
  std::int64_t held_frames_;
  std::array<Vec2, kCells> cells_m_;
  std::array<double, kCells> values_{};
  int next_ = 0;
  std::array<Vec2, kMaxRobots> positions_m_;
  std::int64_t settle_frame_ = -1000;
};

}  // namespace autoref::strategies
