#include "runner/analysis/sprt_match_state.hpp"

#include <array>
#include <optional>

#include "runner/experiments/schedule.hpp"
#include "runner/io/words.hpp"

namespace autoref::runner {
namespace {

// The rows of a pair's two legs; none where one is missing.
using Legs = std::array<const Cells*, 2>;

std::optional<Legs> legs_of(const std::string& matchup, int pair, const RowsById& rows) {
  Legs legs{};
  for (const int leg : {1, 2}) {
    const auto row = rows.find(game_id(matchup, pair, leg));
    if (row == rows.end()) return std::nullopt;
    legs[static_cast<std::size_t>(leg - 1)] = &row->second;
  }
  return legs;
}

// The mean goal difference of a pair; none where a leg is void.
class PairDifference {
 public:
  explicit PairDifference(const RowFormat& format)
      : status_(format.column("status")), difference_(format.column("goal_diff")) {}

  std::optional<double> operator()(const Legs& legs) const {
    double sum = 0;
    for (const Cells* leg : legs) {
      if ((*leg)[status_] == name_of(Status::kVoid)) return std::nullopt;
      sum += number_in((*leg)[difference_]).value();
    }
    return sum / 2;
  }

 private:
  std::size_t status_;
  std::size_t difference_;
};

// What the first pairs say that have both rows, as far as they are there.
struct FirstPairs {
  std::vector<double> differences;
  std::vector<int> numbers;  // of the pairs with a difference
  int count = 0;             // with void ones
};

FirstPairs first_pairs(const SprtMatch& match, const RowFormat& format, const RowsById& rows) {
  const std::string matchup = matchup_name(matchup_of(match));
  const PairDifference difference_of(format);
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

SprtMatchState state_of(const SprtMatch& match, const RowFormat& format, const RowsById& rows) {
  const FirstPairs first = first_pairs(match, format, rows);
  SprtMatchState state{decided_by(match.sprt, first.differences), first.count};
  if (state.test.verdict != Verdict::kGoOn) {
    state.last_pair = first.numbers[static_cast<std::size_t>(state.test.pairs - 1)];
  } else if (first.count == match.sprt.max_pairs) {  // some of them void
    state.test.verdict = Verdict::kUndecided;
  }
  state.is_decided = state.test.verdict != Verdict::kGoOn;
  state.void_pairs = state.last_pair - state.test.pairs;
  return state;
}

}  // namespace autoref::runner
