#include "experiments/kinds/tune/tuning_state.hpp"

#include <fmt/format.h>

#include "experiments/results/game_row.hpp"
#include "experiments/statistics/anytime_interval.hpp"
#include "experiments/statistics/sample.hpp"
#include "io/processes/workers.hpp"

namespace autoref::experiments {
namespace {

struct PlayedPair {
  bool is_played = false;            // whether both legs have been played
  std::optional<double> difference;  // mean goal difference over the legs; nullopt if one is void
};

PlayedPair pair_of(const TuningMatchup& matchup, int pair, const RowsById& rows) {
  double sum = 0;
  bool is_valid = true;
  for (const int leg : {1, 2}) {
    const auto row = rows.find(game_id(matchup.played, pair, leg));
    if (row == rows.end()) return {};
    const game::GameRecord& record = row->second.record;
    if (is_void(record) && io::was_killed(record.void_reason)) return {};
    is_valid = is_valid && !is_void(record);
    sum += record.goals_a - record.goals_b;
  }
  return {true, is_valid ? std::optional(sum / 2) : std::nullopt};
}

// The mean over all pairs of a matchup; `is_played` if all of them have been played.
PlayedPair mean_over_pairs(const TuningMatchup& matchup, int pairs, const RowsById& rows) {
  std::vector<double> differences;
  for (int pair = 1; pair <= pairs; ++pair) {
    const PlayedPair played = pair_of(matchup, pair, rows);
    if (!played.is_played) return {};
    if (played.difference) differences.push_back(*played.difference);
  }
  return {true, differences.empty() ? std::nullopt : std::optional(mean(differences))};
}

// The weighted mean over opponents.
class WeightedScore {
 public:
  void add(Score score, double weight) {
    is_known_ = is_known_ && score.has_value();
    sum_ += weight * score.value_or(0);
    weights_ += weight;
  }
  Score mean() const {
    return is_known_ && weights_ > 0 ? std::optional(sum_ / weights_) : std::nullopt;
  }

 private:
  bool is_known_ = true;
  double sum_ = 0;
  double weights_ = 0;
};

// The candidates' scores; nullopt if a game is missing.
std::optional<std::vector<Score>> scores_of(const Tuning& tuning, const TuningIteration& iteration,
                                            const RowsById& rows) {
  std::vector<WeightedScore> sums(iteration.candidates.size());
  const std::vector<TuningMatchup> matchups =
      matchups_of(tuning, iteration.number, iteration.candidates, iteration.centre);
  for (const TuningMatchup& matchup : matchups) {
    const PlayedPair played = mean_over_pairs(matchup, tuning.pairs, rows);
    if (!played.is_played) return std::nullopt;
    sums[matchup.candidate].add(played.difference, tuning.weight_of(matchup.opponent));
  }
  // If the two candidates of SPSA played each other, half of their difference is the score of one
  // candidate, and the negative of that is the score of the other.
  if (matchups.size() < sums.size()) {
    const Score difference = sums[0].mean();
    if (!difference) return std::vector<Score>(2);
    return std::vector<Score>{*difference / 2, -*difference / 2};
  }
  std::vector<Score> scores;
  scores.reserve(sums.size());
  for (const WeightedScore& sum : sums) scores.push_back(sum.mean());
  return scores;
}

// A pair number's gain: the weighted mean over opponents of the result's difference minus the
// start's, or simply the difference if the two played each other.
PlayedPair gain_in(const Tuning& tuning, const std::vector<TuningMatchup>& matchups, int pair,
                   const RowsById& rows) {
  WeightedScore result;
  WeightedScore start;
  for (const TuningMatchup& matchup : matchups) {
    const PlayedPair played = pair_of(matchup, pair, rows);
    if (!played.is_played) return {};
    (matchup.candidate == 0 ? result : start)
        .add(played.difference, tuning.weight_of(matchup.opponent));
  }
  if (tuning.is_against_itself()) return {true, result.mean()};
  const Score gain =
      result.mean() && start.mean() ? std::optional(*result.mean() - *start.mean()) : std::nullopt;
  return {true, gain};
}

// The pairs before the first one that has not been played.
struct TestPairs {
  // Gains of the pairs without a void game, and the numbers of these pairs.
  std::vector<double> gains;
  std::vector<int> numbers;
  int count = 0;  // number of pairs, including those with a void game
};

TestPairs test_pairs(const Tuning& tuning, const ParamValues& result, const RowsById& rows) {
  const std::vector<TuningMatchup> matchups = test_matchups_of(tuning, result);
  TestPairs first;
  for (int pair = 1; pair <= tuning.test.max_pairs; ++pair) {
    const PlayedPair played = gain_in(tuning, matchups, pair, rows);
    if (!played.is_played) break;
    first.count = pair;
    if (!played.difference) continue;
    first.gains.push_back(*played.difference);
    first.numbers.push_back(pair);
  }
  return first;
}

TuningTest test_of(const Tuning& tuning, const ParamValues& result, const RowsById& rows) {
  const TestPairs first = test_pairs(tuning, result, rows);
  TuningTest test;
  test.state = compared(tuning.test, first.gains);
  test.last_pair = first.count;
  if (test.state.verdict != ThreeWayVerdict::kGoOn) {
    test.last_pair = first.numbers[static_cast<std::size_t>(test.state.pairs - 1)];
  } else if (first.count == tuning.test.max_pairs) {  // void games left fewer than max_pairs
    test.state.verdict = ThreeWayVerdict::kUndecided;
  }
  test.is_decided = test.state.verdict != ThreeWayVerdict::kGoOn;
  test.void_pairs = test.last_pair - test.state.pairs;
  const std::span<const double> used(first.gains.data(),
                                     static_cast<std::size_t>(test.state.pairs));
  if (!used.empty()) test.gain = mean(used);
  test.interval = anytime_interval(used);
  return test;
}

}  // namespace

TuningState state_of(const Tuning& tuning, const RowsById& rows) {
  const auto optimiser = optimiser_of(tuning);
  TuningState state;
  for (int number = 1; number <= tuning.iterations; ++number) {
    TuningIteration iteration{
        number, optimiser->centre(), optimiser->ask(), {}, optimiser->reach(), {}, {}};
    std::optional<std::vector<Score>> scores = scores_of(tuning, iteration, rows);
    if (!scores) {
      state.current = std::move(iteration);
      break;
    }
    iteration.scores = std::move(*scores);
    optimiser->tell(iteration.scores);
    iteration.after = values_at(tuning, optimiser->centre());
    iteration.best = values_at(tuning, optimiser->best());
    state.path.push_back(std::move(iteration));
  }
  state.best = state.path.empty() ? start_values(tuning) : state.path.back().best;
  if (state.is_tuned()) state.test = test_of(tuning, state.best, rows);
  return state;
}

bool is_test_decided(const Tuning& tuning, const RowsById& rows) {
  const auto first = rows.lower_bound("test-");
  if (first == rows.end() || !first->first.starts_with("test-")) return false;
  return state_of(tuning, rows).test.is_decided;
}

std::vector<ScheduledGame> known_games(const Tuning& tuning, const TuningState& state) {
  std::vector<std::vector<TuningMatchup>> rounds;
  rounds.reserve(state.path.size() + 1);
  for (const TuningIteration& iteration : state.path) {
    rounds.push_back(matchups_of(tuning, iteration.number, iteration.candidates, iteration.centre));
  }
  if (state.current) {
    rounds.push_back(matchups_of(tuning, state.current->number, state.current->candidates,
                                 state.current->centre));
  }
  std::vector<ScheduledGame> games;
  for (const std::vector<TuningMatchup>& matchups : rounds)
    append(games, games_of(tuning, matchups, tuning.pairs));
  if (state.is_tuned()) {
    append(games, games_of(tuning, test_matchups_of(tuning, state.best), tuning.test.max_pairs));
  }
  return games;
}

}  // namespace autoref::experiments
