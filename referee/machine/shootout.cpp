#include "referee/machine/shootout.hpp"

#include <algorithm>

namespace autoref::referee {

Side next_kicker(const ShootoutBook& book, const Configuration& configuration) {
  const Side first = configuration.first_kickoff;
  const bool is_level = book.kicks[first] == book.kicks[opponent_of(first)];
  return is_level ? first : opponent_of(first);
}

bool is_decided(const ShootoutBook& book, int kicks) {
  // Decided once a side leads by more than the other can still score. After the regular kicks
  // (sudden death), the only remaining kick is the one that gives both sides equally many.
  const int most = std::max({kicks, book.kicks[Side::kWest], book.kicks[Side::kEast]});
  return std::any_of(kSides.begin(), kSides.end(), [&](Side side) {
    const Side other = opponent_of(side);
    return book.goals[side] > book.goals[other] + most - book.kicks[other];
  });
}

bool is_over(const ShootoutBook& book, int kicks) {
  const int least = std::min(book.kicks[Side::kWest], book.kicks[Side::kEast]);
  return is_decided(book, kicks) || least >= kMostShootoutKicks;
}

}  // namespace autoref::referee
