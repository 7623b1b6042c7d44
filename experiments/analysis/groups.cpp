#include "experiments/analysis/groups.hpp"

#include <fmt/format.h>
#include <cmath>
#include <nlohmann/json.hpp>

#include "experiments/results/game_row.hpp"
#include "experiments/statistics/interval.hpp"
#include "experiments/statistics/sample.hpp"

namespace autoref::experiments {
namespace {

void count_result(Group& group, double lead) {
  ++(lead > 0 ? group.wins_a : lead < 0 ? group.wins_b : group.draws);
}

void add_game(Group& group, const GameRow& row) {
  if (is_void(row.record)) {
    ++group.void_games;
    return;
  }
  group.goals_a.push_back(row.record.goals_a);
  group.goals_b.push_back(row.record.goals_b);
  group.differences.push_back(group.goals_a.back() - group.goals_b.back());
  const double lead = lead_of_a(row.record);
  if (row.record.end_reason == game::EndReason::kGoals)
    ++(lead > 0 ? group.lead_ends_a : group.lead_ends_b);
  count_result(group, lead);
  const double win = lead > 0 ? 1 : lead < 0 ? 0 : 0.5;
  group.games_by_pair[row.pair].push_back({group.differences.back(), win});
}

// Pairs with a missing leg are left out.
DifferenceByPair pair_differences_of(const Group& group) {
  DifferenceByPair differences;
  for (const auto& [number, legs] : group.games_by_pair) {
    // All tests use one value per pair, since the teams change sides between the legs of a pair.
    if (legs.size() == 2) differences[number] = (legs[0].difference + legs[1].difference) / 2;
  }
  return differences;
}

// "1.50 ± 1.00": mean and standard deviation of the goals; "-" without games.
std::string mean_goals_text(const std::vector<double>& goals) {
  if (goals.empty()) return "-";
  const std::optional<double> deviation = standard_deviation(goals);
  return deviation ? fmt::format("{:.2f} ± {:.2f}", mean(goals), *deviation)
                   : fmt::format("{:.2f}", mean(goals));
}

// The columns mean_NAME and sd_NAME.
io::TableColumns<Group> sample_columns(const std::string& name,
                                       std::vector<double> Group::*sample) {
  return {{"mean_" + name, [=](const Group& group) { return mean_of(group.*sample); }, io::kInJson},
          {"sd_" + name, [=](const Group& group) { return standard_deviation(group.*sample); }}};
}

}  // namespace

std::string share_text(int part, int whole) {
  const std::optional<Interval> interval = proportion_interval(part, whole);
  if (!interval) return "-";
  return fmt::format("{:.0f} % [{:.0f}, {:.0f}]", 100.0 * part / whole, 100 * interval->low,
                     100 * interval->high);
}

std::vector<Group> grouped(const std::vector<std::vector<std::string>>& values,
                           const std::function<std::vector<std::string>(const GameRow&)>& values_of,
                           const RowsById& rows) {
  std::vector<Group> groups(values.size());
  std::map<std::vector<std::string>, Group*> by_values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    groups[i].values = values[i];
    by_values[values[i]] = &groups[i];
  }
  for (const auto& [id, row] : rows) {
    const auto group = by_values.find(values_of(row));
    if (group != by_values.end()) add_game(*group->second, row);
  }
  for (Group& group : groups) group.pair_differences = pair_differences_of(group);
  return groups;
}

std::vector<double> values_of(const DifferenceByPair& differences) {
  std::vector<double> values;
  values.reserve(differences.size());
  for (const auto& [pair, value] : differences) values.push_back(value);
  return values;
}

std::optional<double> mean_of(const std::vector<double>& sample) {
  return sample.empty() ? std::nullopt : std::optional(mean(sample));
}

io::TableColumns<Group> summary_columns() {
  const auto interval = [](const Group& group) {
    return mean_interval(values_of(group.pair_differences));
  };
  return io::joined(io::TableColumns<Group>{{"games", &Group::games, io::kInJson},
                                            {"void_games", &Group::void_games, io::kInJson}},
                    sample_columns("a", &Group::goals_a), sample_columns("b", &Group::goals_b),
                    sample_columns("diff", &Group::differences),
                    io::TableColumns<Group>{{"pairs", &Group::pairs}},
                    interval_columns<Group>("diff_", interval));
}

io::TableColumns<Group> result_columns() {
  const io::TableColumns<Group> counts = {{"wins_a", &Group::wins_a, io::kInJson},
                                          {"draws", &Group::draws, io::kInJson},
                                          {"wins_b", &Group::wins_b, io::kInJson}};
  return io::joined(counts, share_columns(counts));
}

io::Json json_of(const std::vector<Group>& groups) {
  const io::TableColumns<Group> columns = io::joined(summary_columns(), result_columns());
  io::Json all = io::Json::array();
  for (const Group& group : groups) {
    all.push_back({{"values", group.values}});
    io::add_members(all.back(), columns, group);
  }
  return all;
}

io::TableColumns<Group> text_columns() {
  return {{kGamesHead, &Group::games},
          {kGoalsAHead, [](const Group& group) { return mean_goals_text(group.goals_a); }},
          {kGoalsBHead, [](const Group& group) { return mean_goals_text(group.goals_b); }},
          {kDifferenceHead,
           [](const Group& group) {
             return difference_text(group.differences, values_of(group.pair_differences));
           }},
          {kVoidHead, &Group::void_games}};
}

io::TextTable without_void_games(io::TextTable table) {
  const std::size_t column = io::column_named(table.rows.front(), kVoidHead);
  return io::without_zeros(std::move(table), column);
}

io::TableColumns<PairedDifference> difference_columns(const std::string& mean,
                                                      const std::string& prefix) {
  using Columns = io::TableColumns<PairedDifference>;
  return io::joined(
      Columns{{mean, &PairedDifference::mean, io::kInJson}},
      interval_columns<PairedDifference>(prefix, &PairedDifference::interval, io::kInJson),
      Columns{
          {"p", [](const PairedDifference& difference) { return p_cell(difference.p); }},
          {"p_holm", [](const PairedDifference& difference) { return p_cell(difference.p_holm); }},
          {"effect_size", &PairedDifference::effect_size}});
}

std::string difference_text(const std::vector<double>& differences,
                            const std::vector<double>& pair_differences) {
  if (differences.empty()) return "-";
  return mean_text(mean(differences), mean_interval(pair_differences), pair_differences.size());
}

std::string mean_text(double mean, const std::optional<Interval>& interval, std::size_t pairs) {
  if (!interval)
    return fmt::format("{:+.2f} ({})", mean, pairs < 2 ? "too few games" : "all pairs equal");
  if (std::isinf(interval->high)) {
    return fmt::format("{:+.2f} [at least {:+.2f}]", mean, interval->low);
  }
  if (std::isinf(interval->low)) {
    return fmt::format("{:+.2f} [at most {:+.2f}]", mean, interval->high);
  }
  return fmt::format("{:+.2f} [{:+.2f}, {:+.2f}]", mean, interval->low, interval->high);
}

std::string p_text(double p) { return p < 0.001 ? "<0.001" : fmt::format("{:.3f}", p); }

std::string p_cell(std::optional<double> p) { return p ? fmt::format("{:.6g}", *p) : ""; }

}  // namespace autoref::experiments
