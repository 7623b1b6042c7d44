#include "experiments/kinds/sprt/sprt_match_state.hpp"

#include <array>
#include <optional>

#include "experiments/results/scores.hpp"
#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {
namespace {

// The rows of a pair's two legs.
using Legs = std::array<const GameRow*, 2>;

std::optional<Legs> legs_of(const std::string& matchup, int pair, const RowsById& rows) {
  Legs legs{};
  for (const int leg : {1, 2}) {
    const auto row = rows.find(game_id(matchup, pair, leg));
    if (row == rows.end()) return std::nullopt;
    legs[static_cast<std::size_t>(leg - 1)] = &row->second;
  }
  return legs;
}

// The mean goal difference of a pair; nullopt if a leg is void.
std::optional<double> difference_of(const Legs& legs) {
  double sum = 0;
  for (const GameRow* leg : legs) {
    if (is_void(leg->record)) return std::nullopt;
    sum += leg->record.goals_a - leg->record.goals_b;
  }
  return sum / 2;
}

// The pairs before the first one with a missing row.
struct FirstPairs {
  std::vector<double> differences;  // of the pairs without a void leg
  std::vector<int> numbers;         // the numbers of these pairs
  int count = 0;                    // including pairs with a void leg
};

FirstPairs first_pairs(const SprtMatch& match, const RowsById& rows) {
  const std::string matchup = matchup_name(matchup_of(match));
  FirstPairs first;
  for (int pair = 1; pair <= match.sprt.max_pairs; ++pair) {
    const std::optional<Legs> legs = legs_of(matchup, pair, rows);
    if (!legs) break;
    first.count = pair;
    const std::optional<double> difference = difference_of(*legs);
    if (!difference) continue;
    first.differences.push_back(*difference);
    first.numbers.push_back(pair);
  }
  return first;
}

}  // namespace

SprtMatchState state_of(const SprtMatch& match, const RowsById& rows) {
  const FirstPairs first = first_pairs(match, rows);
  SprtMatchState state{decided_by(match.sprt, first.differences), first.count};
  if (state.test.verdict != Verdict::kGoOn) {
    state.last_pair = first.numbers[static_cast<std::size_t>(state.test.pairs - 1)];
  } else if (first.count == match.sprt.max_pairs) {  // fewer than max_pairs without a void leg
    state.test.verdict = Verdict::kUndecided;
  }
  state.is_decided = state.test.verdict != Verdict::kGoOn;
  state.void_pairs = state.last_pair - state.test.pairs;
  return state;
}

}  // namespace autoref::experiments
