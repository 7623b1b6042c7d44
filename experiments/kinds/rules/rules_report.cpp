#include "experiments/kinds/rules/rules_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "experiments/analysis/groups.hpp"
#include "experiments/kinds/rules/rules_experiment.hpp"
#include "io/table_columns.hpp"
#include "io/words.hpp"

namespace autoref::experiments {
namespace {

constexpr double kRareCalls = 0.05;  // per game; the table leaves out kinds with fewer calls
constexpr std::size_t kVariantsInTable = 2;  // besides the first; more would not fit side by side
constexpr const char* kCallsOf = "calls_";

using GamesOfPair = std::vector<const GameRow*>;

// A measure of several games: the sum of `amount`, divided by the sum of `per`.
struct RuleMeasure {
  std::string name;
  std::string head;
  std::function<double(const GameRow&)> amount;
  std::function<double(const GameRow&)> per = [](const GameRow&) { return 1.0; };
};

double calls_in(const GameRow& row) {
  double calls = 0;
  for (const referee::EventEntry& entry : referee::event_table())
    if (is_call(entry.event)) calls += row.record.count(entry.event);
  return calls;
}

bool is_in_any_game(referee::Event event, const RowsById& rows) {
  return std::any_of(rows.begin(), rows.end(),
                     [event](const auto& row) { return row.second.record.count(event) > 0; });
}

// The matchups with the stronger team first.
std::vector<Matchup> stronger_first(std::vector<Matchup> matchups, const RowsById& rows) {
  std::map<std::pair<std::string_view, std::string_view>, int> leads;
  for (const auto& [id, row] : rows) {
    if (is_void(row.record)) continue;
    leads[{row.team_a, row.team_b}] += row.record.goals_a - row.record.goals_b;
  }
  for (Matchup& matchup : matchups) {
    if (leads[{matchup.team_a, matchup.team_b}] < 0) std::swap(matchup.team_a, matchup.team_b);
  }
  return matchups;
}

std::vector<RuleMeasure> rule_measures(const std::vector<Matchup>& matchups, const RowsById& rows) {
  std::set<std::pair<std::string, std::string>> with_stronger_a;
  for (const Matchup& matchup : matchups) with_stronger_a.emplace(matchup.team_a, matchup.team_b);
  const auto lead = [with_stronger_a](const GameRow& row) {
    const int lead_of_a = row.record.goals_a - row.record.goals_b;
    return with_stronger_a.contains({row.team_a, row.team_b}) ? lead_of_a : -lead_of_a;
  };
  std::vector<RuleMeasure> measures = {
      {"stops_per_min", "stops per minute in play",
       [](const GameRow& row) { return row.record.stops; },
       [](const GameRow& row) { return row.record.ball_in_play_s / 60; }},
      {"in_play_min", "time in play [min]",
       [](const GameRow& row) { return row.record.ball_in_play_s / 60; }},
      {"in_play_percent", "time in play [%]",
       [](const GameRow& row) { return 100 * row.record.ball_in_play_s; },
       [](const GameRow& row) { return row.record.sim_s; }},
      {"goals", "goals",
       [](const GameRow& row) { return row.record.goals_a + row.record.goals_b; }},
      {"shots", "shots",
       [](const GameRow& row) { return row.record.counts[0].shots + row.record.counts[1].shots; }},
      {"lead_of_stronger", "lead of the stronger team", lead},
      {"calls", "calls", calls_in},
      {"doubtful_percent", "doubtful calls [%]",
       [](const GameRow& row) { return 100.0 * row.record.doubtful_calls; }, calls_in}};
  for (const referee::EventEntry& entry : referee::event_table()) {
    if (!is_call(entry.event) || !is_in_any_game(entry.event, rows)) continue;
    measures.push_back(
        {fmt::format("{}{}", kCallsOf, entry.name), std::string(entry.name),
         [event = entry.event](const GameRow& row) { return row.record.count(event); }});
  }
  return measures;
}

using GamesByPair = std::map<int, GamesOfPair>;

// The games of each variant and pair number, without the pair numbers that lack a game.
std::map<std::string, GamesByPair> games_of_variants(std::size_t games_per_pair,
                                                     const RowsById& rows) {
  std::map<std::string, GamesByPair> all;
  for (const auto& [id, row] : rows)
    if (!is_void(row.record)) all[row.values.front()][row.pair].push_back(&row);
  for (auto& [variant, by_pair] : all)
    std::erase_if(by_pair, [=](const auto& pair) { return pair.second.size() != games_per_pair; });
  return all;
}

// Leaves out pair numbers in which there is nothing to divide by.
DifferenceByPair values_by_pair(const RuleMeasure& measure, const GamesByPair& games) {
  DifferenceByPair values;
  for (const auto& [pair, its_games] : games) {
    double amount = 0;
    double per = 0;
    for (const GameRow* game : its_games) {
      amount += measure.amount(*game);
      per += measure.per(*game);
    }
    if (per > 0) values[pair] = amount / per;
  }
  return values;
}

void add_effects(const RuleMeasure& measure, std::map<std::string, GamesByPair>& games,
                 RuleEffects& all) {
  DifferenceByPair first;
  for (std::size_t i = 0; i < all.variants.size(); ++i) {
    const DifferenceByPair by_pair = values_by_pair(measure, games[all.variants[i]]);
    const std::vector<double> sample = values_of(by_pair);
    RuleEffect effect{measure.name,    all.variants[i],       sample.size(),
                      mean_of(sample), mean_interval(sample), {}};
    if (i == 0) {
      first = by_pair;
    } else {
      effect.from_first = paired_difference(by_pair, first);
    }
    all.effects.push_back(std::move(effect));
  }
}

io::TableColumns<RuleEffect> rule_effect_columns() {
  return io::joined(
      io::TableColumns<RuleEffect>{
          {"measure", &RuleEffect::measure, io::kInJson},
          {"variant", &RuleEffect::variant, io::kInJson},
          {"pairs", [](const RuleEffect& effect) { return static_cast<int>(effect.pairs); },
           io::kInJson},
          {"mean", &RuleEffect::mean, io::kInJson}},
      interval_columns<RuleEffect>("", &RuleEffect::interval, io::kInJson));
}

std::vector<PairedDifference> differences_in(const RuleEffects& all) {
  std::vector<PairedDifference> differences;
  differences.reserve(all.effects.size());
  for (const RuleEffect& effect : all.effects) differences.push_back(effect.from_first);
  return differences;
}

std::string value_text(const RuleEffect& effect) {
  return effect.mean ? fmt::format("{:.2f}", *effect.mean) : "-";
}

// "-1.33 ± 0.29*".
std::string change_text(const PairedDifference& difference) {
  if (!difference.mean) return "-";
  std::string text = fmt::format("{:+.2f}", *difference.mean);
  if (difference.interval)
    text += fmt::format(" ± {:.2f}", (difference.interval->high - difference.interval->low) / 2);
  return text + (difference.p_holm.value_or(1) < kSignificant ? "*" : "");
}

// Rare calls are left out, since the table would otherwise be much longer.
bool is_shown(std::span<const RuleEffect> measure) {
  return !measure.front().measure.starts_with(kCallsOf) ||
         std::any_of(measure.begin(), measure.end(), [](const RuleEffect& effect) {
           return effect.mean.value_or(0) >= kRareCalls;
         });
}

// The table of the first variant and of those from `begin` to `end`, with their differences from
// it.
std::vector<io::Cells> rule_effects_rows(const RuleEffects& all, std::size_t begin,
                                         std::size_t end) {
  std::vector<io::Cells> rows = {{"measure", all.variants.front()}};
  for (std::size_t i = begin; i < end; ++i)
    io::append(rows.front(),
               {all.variants[i], fmt::format("from {} ± 95 %", all.variants.front())});
  for (std::size_t i = 0; i < all.heads.size(); ++i) {
    const std::size_t variants = all.variants.size();
    const auto measure = std::span(all.effects).subspan(i * variants, variants);
    if (!is_shown(measure)) continue;
    rows.push_back({all.heads[i], value_text(measure.front())});
    for (const RuleEffect& effect : measure.subspan(begin, end - begin))
      io::append(rows.back(), {value_text(effect), change_text(effect.from_first)});
  }
  return rows;
}

std::string settings_text(const RuleVariant& variant) {
  std::vector<std::string> settings;
  for (const auto& [path, value] : variant.settings)
    settings.push_back(fmt::format("{}={}", path, game::spelt(value)));
  return io::listed(settings);
}

std::string explanation_of(const RuleEffects& all) {
  std::string text = fmt::format(
      "Means per game, unless a row says otherwise; kinds of calls with fewer than {} per game "
      "under every variant are only in summary.csv. Differences from {} have the half width of "
      "their 95 % interval; * marks those with p below {} (paired t test, Holm's correction over "
      "all rows of summary.csv).\n",
      kRareCalls, all.variants.front(), kSignificant);
  io::Cells stronger;
  for (const Matchup& matchup : all.matchups)
    stronger.push_back(fmt::format("{} against {}", matchup.team_a, matchup.team_b));
  text += fmt::format("Matchups, with the stronger team first: {}.\n", io::listed(stronger));
  for (std::size_t i = 0; i < all.variants.size(); ++i) {
    text += fmt::format("{} ({} pairs){}{}\n", all.variants[i], all.pairs[i],
                        all.settings[i].empty() ? "" : ": ", all.settings[i]);
  }
  if (all.void_games > 0)
    text +=
        fmt::format("Void games: {}. All games of the same variant and pair number are left out.\n",
                    all.void_games);
  return text;
}

}  // namespace

RuleEffects rule_effects_of(const RulesExperiment& rules, const RowsById& rows) {
  const std::vector<Matchup> matchups = matchups_among(rules.teams);
  RuleEffects all;
  all.matchups = stronger_first(matchups, rows);
  for (const auto& [id, row] : rows) all.void_games += is_void(row.record) ? 1 : 0;
  std::map<std::string, GamesByPair> games = games_of_variants(2 * matchups.size(), rows);
  for (const RuleVariant& variant : rules.variants) {
    all.variants.push_back(variant.name);
    all.settings.push_back(settings_text(variant));
    all.pairs.push_back(games[variant.name].size());
  }
  for (const RuleMeasure& measure : rule_measures(all.matchups, rows)) {
    all.heads.push_back(measure.head);
    add_effects(measure, games, all);
  }
  correct_by_holm(all.effects, &RuleEffect::from_first);
  return all;
}

std::string csv_of(const RuleEffects& effects) {
  std::vector<io::Cells> rows = io::table_rows(rule_effect_columns(), effects.effects);
  io::append_columns(rows, difference_columns("from_first", "from_first_"),
                     differences_in(effects));
  return io::csv_text(rows);
}

io::Json json_of(const RuleEffects& effects) {
  io::Json all = io::Json::array();
  for (const RuleEffect& effect : effects.effects) {
    all.push_back(io::Json::object());
    io::add_members(all.back(), rule_effect_columns(), effect);
    io::add_members(all.back(), difference_columns("from_first", "from_first_"), effect.from_first);
  }
  return all;
}

io::TextBlocks table_of(const RuleEffects& effects) {
  io::TextBlocks blocks;
  const std::size_t variants = effects.variants.size();
  for (std::size_t begin = 1; begin < variants; begin += kVariantsInTable) {
    const std::size_t end = std::min(begin + kVariantsInTable, variants);
    blocks.emplace_back(
        io::TextTable{rule_effects_rows(effects, begin, end), {io::Align::kLeft}, 2});
    blocks.emplace_back("\n");
  }
  blocks.emplace_back(explanation_of(effects));
  return blocks;
}

io::ProgressTable progress_table_of(const RuleEffects& effects) {
  io::ProgressTable table{
      rule_effects_rows(effects, 1, effects.variants.size()), {io::Align::kLeft}, "measures"};
  table.text = explanation_of(effects);
  return table;
}

}  // namespace autoref::experiments
