#include "experiments/kinds/situations/situations_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "experiments/analysis/groups.hpp"
#include "experiments/statistics/sample.hpp"
#include "io/table_columns.hpp"
#include "soccer/named.hpp"

namespace autoref::experiments {
namespace {

std::optional<double> scene_share(int part, std::size_t whole) {
  return whole == 0 ? std::nullopt : std::optional(part / static_cast<double>(whole));
}

std::optional<Interval> goals_interval(const SceneGroup& group) {
  return scene_share_interval(group.goals, group.scores.size(), group.pair_goals);
}

io::Cells scene_columns() {
  io::Cells columns = {"situation", "attackers",    "defenders",   "scenes",       "void_scenes",
                       "goals",     "goal_share",   "goal_low95",  "goal_high95",  "mean_score",
                       "sd_score",  "pairs",        "score_low95", "score_high95", "conceded",
                       "ball_kept", "mean_gained_m"};
  for (const std::string& end : all_names<game::SceneEnd>()) columns.push_back("ended_" + end);
  return columns;
}

io::Cells scene_cells(const SceneGroup& group) {
  const auto& [goal_low, goal_high] = bounds_of(goals_interval(group));
  const auto& [score_low, score_high] = bounds_of(score_interval(group));
  io::Cells cells = {group.matchup.situation,
                     group.matchup.attackers,
                     group.matchup.defenders,
                     std::to_string(group.scores.size()),
                     std::to_string(group.void_scenes),
                     std::to_string(group.goals),
                     io::number_cell(scene_share(group.goals, group.scores.size())),
                     io::number_cell(goal_low),
                     io::number_cell(goal_high),
                     io::number_cell(mean_of(group.scores)),
                     io::number_cell(standard_deviation(group.scores)),
                     std::to_string(group.pair_scores.size()),
                     io::number_cell(score_low),
                     io::number_cell(score_high),
                     std::to_string(group.conceded),
                     std::to_string(group.kept),
                     io::number_cell(mean_of(group.gained_m))};
  for (const int count : group.ends) cells.push_back(std::to_string(count));
  return cells;
}

// "19 % [15, 24]"; "-" if there are no scenes.
std::string percent_text(const std::optional<double>& share,
                         const std::optional<Interval>& interval) {
  if (!share) return "-";
  std::string text = fmt::format("{:.0f} %", 100 * *share);
  if (interval) text += fmt::format(" [{:.0f}, {:.0f}]", 100 * interval->low, 100 * interval->high);
  return text;
}

std::string score_cell(const SceneGroup& group) {
  if (group.scores.empty()) return "-";
  const std::optional<Interval> interval = score_interval(group);
  std::string text = fmt::format("{:.2f}", mean(group.scores));
  if (interval) text += fmt::format(" [{:.2f}, {:.2f}]", interval->low, interval->high);
  return text;
}

io::Cells table_row(const SceneGroup& group) {
  const std::size_t scenes = group.scores.size();
  return {group.matchup.situation,
          group.matchup.attackers,
          group.matchup.defenders,
          std::to_string(scenes),
          percent_text(scene_share(group.goals, scenes), goals_interval(group)),
          score_cell(group),
          percent_text(scene_share(group.kept, scenes), std::nullopt),
          scenes == 0 ? "-" : fmt::format("{:+.2f}", mean(group.gained_m)),
          std::to_string(group.void_scenes)};
}

std::vector<io::Cells> differences_rows(const std::vector<SceneDifference>& differences) {
  std::vector<io::Cells> rows = {{"situation", "defenders", "attackers", "minus", "pairs",
                                  "difference of scores [95 %]", "p (Holm)"}};
  for (const SceneDifference& one : differences) {
    const PairedDifference& difference = one.difference;
    rows.push_back(
        {one.matchup.situation, one.matchup.defenders, one.matchup.attackers, one.other,
         std::to_string(difference.pairs),
         difference.mean ? mean_text(*difference.mean, difference.interval, difference.pairs) : "-",
         difference.p_holm ? p_text(*difference.p_holm) : "-"});
  }
  return rows;
}

}  // namespace

std::string scenes_csv(const std::vector<SceneGroup>& groups) {
  std::string csv = io::csv_line(scene_columns()) + "\n";
  for (const SceneGroup& group : groups) csv += io::csv_line(scene_cells(group)) + "\n";
  return csv;
}

std::string scene_differences_csv(const std::vector<SceneDifference>& differences) {
  std::vector<io::Cells> rows = {{"situation", "defenders", "attackers", "other", "pairs"}};
  std::vector<PairedDifference> paired;
  for (const SceneDifference& one : differences) {
    rows.push_back({one.matchup.situation, one.matchup.defenders, one.matchup.attackers, one.other,
                    std::to_string(one.difference.pairs)});
    paired.push_back(one.difference);
  }
  io::append_columns(rows, difference_columns("mean_diff", "diff_"), paired);
  return io::csv_text(rows);
}

std::vector<io::Cells> scenes_rows(const std::vector<SceneGroup>& groups) {
  std::vector<io::Cells> rows = {{"situation", "attackers", "defenders", "scenes", "scored [95 %]",
                                  "score [95 %]", "ball kept", "gained m", kVoidHead}};
  for (const SceneGroup& group : groups) rows.push_back(table_row(group));
  return rows;
}

io::TextBlocks scenes_table(const std::vector<SceneGroup>& groups,
                            const std::vector<SceneDifference>& differences) {
  io::TextBlocks blocks = {without_void_games({scenes_rows(groups), kScenesColumns, 3})};
  if (differences.empty()) return blocks;
  blocks.emplace_back("\n");
  blocks.emplace_back(
      io::TextTable{differences_rows(differences),
                    {io::Align::kLeft, io::Align::kLeft, io::Align::kLeft, io::Align::kLeft},
                    4});
  return blocks;
}

io::Json json_of(const std::vector<SceneGroup>& groups) {
  io::Json all = io::Json::array();
  for (const SceneGroup& group : groups) {
    all.push_back({{"situation", group.matchup.situation},
                   {"attackers", group.matchup.attackers},
                   {"defenders", group.matchup.defenders},
                   {"scenes", group.scores.size()},
                   {"void_scenes", group.void_scenes},
                   {"goals", group.goals},
                   {"mean_score", io::json_number(mean_of(group.scores))}});
  }
  return all;
}

}  // namespace autoref::experiments
