#include "experiments/analysis/play_differences.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/statistics/anytime_interval.hpp"
#include "experiments/statistics/paired_difference.hpp"

namespace autoref::experiments {
namespace {

using game::PlayCounts;
using Field = game::CountField<PlayCounts>;

struct CountedPlay {
  std::string name;
  TeamNumber number;
};

// The actions that are compared. Shots are not: what they are worth is a part of the goal
// difference.
struct ShownActions {
  const char* name;
  game::ActionKind kind;
  bool is_new_count;  // whether their number is not among the play counts
};
constexpr ShownActions kShownActions[] = {{"passes", game::ActionKind::kPass, false},
                                          {"dribbles", game::ActionKind::kDribble, true},
                                          {"losses", game::ActionKind::kLoss, true},
                                          {"fouls", game::ActionKind::kFoul, false}};

// Counts that are parts of the goal difference.
bool is_part_of_goals(const Field& field) {
  return field.count == &PlayCounts::own_goals || field.number == &PlayCounts::xg ||
         field.number == &PlayCounts::xgot;
}

// "shots on goal".
std::string shown_name(const Field& field) {
  if (field.number == &PlayCounts::possession_s) return "seconds of possession";
  std::string name(field.name);
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::vector<CountedPlay> counted_play() {
  std::vector<CountedPlay> counted;
  for (const game::ChainGroup& group : game::chain_groups()) {
    if (!group.start) continue;
    counted.push_back({fmt::format("chains from {}", plural_of(*group.start)),
                       [&group](const TeamGame& game) { return group.of(*game.own).chains; }});
  }
  for (const Field& field : game::count_fields()) {
    if (is_part_of_goals(field)) continue;
    counted.push_back({shown_name(field), [&field](const TeamGame& game) {
                         return field.count != nullptr ? game.own->*field.count
                                                       : game.own->*field.number;
                       }});
  }
  for (const ShownActions& shown : kShownActions) {
    if (shown.is_new_count) {
      counted.push_back({shown.name, [&shown](const TeamGame& game) {
                           return game::counts_of(*game.own, shown.kind).actions;
                         }});
    }
    counted.push_back({fmt::format("worth of {}", shown.name), [&shown](const TeamGame& game) {
                         return game::counts_of(*game.own, shown.kind).worth;
                       }});
  }
  return counted;
}

PlayDifference difference_in(const CountedPlay& counted,
                             const std::vector<PairedOpponent>& opponents,
                             const std::vector<int>& pairs, const RowsById& rows) {
  const auto opponent_count = static_cast<double>(opponents.size());
  PlayDifference result;
  result.name = counted.name;
  std::vector<double> differences;
  for (const int pair : pairs) {
    TeamNumbers sum;  // of new and old
    for (const PairedOpponent& opponent : opponents) {
      const TeamNumbers of_new = mean_over_legs(counted.number, opponent.of_new, pair, rows);
      sum.of_a += of_new.of_a;
      sum.of_b += opponent.of_old
                      ? mean_over_legs(counted.number, *opponent.of_old, pair, rows).of_a
                      : of_new.of_b;
    }
    result.of_new += sum.of_a / opponent_count / static_cast<double>(pairs.size());
    result.of_old += sum.of_b / opponent_count / static_cast<double>(pairs.size());
    differences.push_back((sum.of_a - sum.of_b) / opponent_count);
  }
  result.mean = result.of_new - result.of_old;
  result.interval = anytime_interval(differences);
  result.p = anytime_p(differences);
  return result;
}

}  // namespace

std::vector<PlayDifference> play_differences(const std::vector<PairedOpponent>& opponents,
                                             const std::vector<int>& pairs, const RowsById& rows) {
  std::vector<PlayDifference> differences;
  std::vector<double> p;
  for (const CountedPlay& counted : counted_play()) {
    differences.push_back(difference_in(counted, opponents, pairs, rows));
    p.push_back(differences.back().p);
  }
  const std::vector<double> corrected = holm(p);
  for (std::size_t i = 0; i < differences.size(); ++i) differences[i].p_holm = corrected[i];
  return differences;
}

std::vector<PlayDifference> certain_differences(const std::vector<PlayDifference>& differences) {
  std::vector<PlayDifference> certain;
  std::copy_if(differences.begin(), differences.end(), std::back_inserter(certain),
               [](const PlayDifference& one) { return one.p_holm <= kSignificant; });
  std::stable_sort(
      certain.begin(), certain.end(),
      [](const PlayDifference& one, const PlayDifference& other) { return one.p < other.p; });
  return certain;
}

}  // namespace autoref::experiments
