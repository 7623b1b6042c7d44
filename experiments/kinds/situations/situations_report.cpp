#include "experiments/kinds/situations/situations_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "experiments/analysis/groups.hpp"
#include "experiments/statistics/sample.hpp"
#include "io/table_columns.hpp"
#include "io/words.hpp"
#include "soccer/named.hpp"
#include "soccer/parameters.hpp"

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

using Values = std::vector<std::pair<std::string, std::string>>;  // values by key, in order

Values values_of_robot(const DrawnRobot& robot, const Field& field) {
  Values values;
  for (const auto& number : numbers_of(robot, field))
    values.emplace_back(number.key, experiments::text_of(*number.place));
  if (robot.heading_deg)
    values.emplace_back("heading_deg", experiments::text_of(*robot.heading_deg));
  return values;
}

Values values_of_ball(const DrawnBall& ball, const Field& field) {
  Values values;
  for (const auto& number : numbers_of(ball, field))
    values.emplace_back(number.key, experiments::text_of(*number.place));
  return values;
}

std::string ends_of(const game::Scene& scene) {
  std::vector<std::string> words;
  for (const auto& [end, name] : game::names_of(game::SceneEnd{})) {
    if (end != game::SceneEnd::kTime && scene.is_ended_by(end)) words.emplace_back(name);
  }
  return fmt::format("[{}]", io::listed(words));
}

std::string flow_text(const Values& values) {
  std::string text;
  for (const auto& [key, value] : values)
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", key, value);
  return fmt::format("{{ {} }}", text);
}

std::string score_of(const game::SceneWeights& weights) {
  Values values;
  game::SceneWeights::visit(weights, [&values](double weight, const Parameter& about) {
    values.emplace_back(about.name, io::text_of(weight));
  });
  return flow_text(values);
}

// A situation's settings other than its robots and ball.
Values values_of_scene(const SituationSetup& situation) {
  return {{"lasts_s", io::text_of(situation.scene.lasts_s)},
          {"score", score_of(situation.scene.weights)},
          {"ends_on", ends_of(situation.scene)},
          {"restart", std::string(autoref::name_of(situation.restart))},
          {"taken_by", situation.is_attackers_restart ? "attackers" : "defenders"},
          {"after_stop", situation.is_after_stop ? "true" : "false"}};
}

std::string robots_text(std::string_view key, const std::vector<DrawnRobot>& robots,
                        const Field& field) {
  std::string text = fmt::format("    {}:{}\n", key, robots.empty() ? " {}" : "");
  for (const DrawnRobot& robot : robots)
    text += fmt::format("      {}: {}\n", robot.number, flow_text(values_of_robot(robot, field)));
  return text;
}

void add_below(const std::string& path, const Values& values,
               std::map<std::string, std::string>& all) {
  for (const auto& [key, value] : values) all[fmt::format("{}.{}", path, key)] = value;
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

std::string situations_text(const Situations& situations) {
  const Field& field = situations.base.field;
  std::string text =
      "situations:  # in the attackers' frame: the attackers defend the goal at -x\n";
  for (const auto& [name, situation] : situations.situations) {
    text += fmt::format("  {}:\n", name);
    for (const auto& [key, value] : values_of_scene(situation))
      text += fmt::format("    {}: {}\n", key, value);
    text += fmt::format("    ball: {}\n", flow_text(values_of_ball(situation.ball, field)));
    text += robots_text("attackers", situation.attackers, field);
    text += robots_text("defenders", situation.defenders, field);
  }
  return text;
}

std::map<std::string, std::string> situation_values(const Situations& situations) {
  const Field& field = situations.base.field;
  std::map<std::string, std::string> all;
  for (const auto& [name, situation] : situations.situations) {
    const std::string path = fmt::format("situations.{}", name);
    add_below(path, values_of_scene(situation), all);
    add_below(path + ".ball", values_of_ball(situation.ball, field), all);
    for (const DrawnRobot& robot : situation.attackers) {
      add_below(fmt::format("{}.attackers.{}", path, robot.number), values_of_robot(robot, field),
                all);
    }
    for (const DrawnRobot& robot : situation.defenders) {
      add_below(fmt::format("{}.defenders.{}", path, robot.number), values_of_robot(robot, field),
                all);
    }
  }
  return all;
}

}  // namespace autoref::experiments
