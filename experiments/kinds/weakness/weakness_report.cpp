#include "experiments/kinds/weakness/weakness_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

#include "experiments/analysis/groups.hpp"
#include "experiments/scenes/situations_key.hpp"
#include "experiments/scenes/start_drawing.hpp"
#include "experiments/statistics/sample.hpp"
#include "io/table_columns.hpp"
#include "io/words.hpp"

namespace autoref::experiments {
namespace {

using TestOfFind = std::optional<ComparedScenes> Find::*;

std::optional<double> score_in(const SceneGroup& scenes) { return mean_of(scenes.scores); }

// Columns of one of a find's tests; their cells are empty without it.
io::TableColumns<Find> test_columns(const std::string& prefix, TestOfFind test) {
  using Value = std::function<std::optional<double>(const ComparedScenes&)>;
  using Bounds = std::function<std::optional<Interval>(const ComparedScenes&)>;
  const auto column = [&prefix, test](const std::string& name, const Value& value,
                                      bool is_in_json = false) -> io::TableColumn<Find> {
    return {prefix + name,
            [test, value](const Find& find) {
              return find.*test ? value(*(find.*test)) : std::nullopt;
            },
            is_in_json};
  };
  const auto bounds = [&prefix, test](const std::string& name, const Bounds& interval) {
    return interval_columns<Find>(prefix + name + "_",
                                  [test, interval](const Find& find) -> std::optional<Interval> {
                                    return find.*test ? interval(*(find.*test)) : std::nullopt;
                                  });
  };
  using Columns = io::TableColumns<Find>;
  return io::joined(
      Columns{{prefix + "scenes",
               [test](const Find& find) {
                 return find.*test ? std::to_string((find.*test)->scenes.scores.size())
                                   : std::string();
               }},
              column(
                  "score", [](const ComparedScenes& its) { return score_in(its.scenes); },
                  io::kInJson)},
      bounds("score", [](const ComparedScenes& its) { return score_interval(its.scenes); }),
      Columns{column(
          "usual", [](const ComparedScenes& its) { return score_in(its.usual); }, io::kInJson)},
      bounds("usual", [](const ComparedScenes& its) { return score_interval(its.usual); }),
      Columns{column(
          "excess", [](const ComparedScenes& its) { return its.excess.mean; }, io::kInJson)},
      bounds("excess", [](const ComparedScenes& its) { return its.excess.interval; }),
      Columns{{prefix + "p", [test](const Find& find) {
                 return p_cell(find.*test ? (find.*test)->excess.p : std::nullopt);
               }}});
}

std::vector<std::string> paths_of(const std::vector<RobotOfSituation>& robots) {
  std::vector<std::string> paths;
  paths.reserve(robots.size());
  for (const RobotOfSituation& robot : robots) paths.push_back(path_of(robot));
  return paths;
}

io::TableColumns<Find> find_columns() {
  using Columns = io::TableColumns<Find>;
  return io::joined(
      Columns{{"search", [](const Find& find) { return find.search.text(); }, io::kInJson},
              {"situation", [](const Find& find) { return find.search.family; }},
              {"searched", [](const Find& find) { return find.searched; }, io::kInJson}},
      test_columns("", &Find::test),
      Columns{
          {"p_holm",
           [](const Find& find) {
             return p_cell(find.test ? find.test->excess.p_holm : std::nullopt);
           }},
          {"confirmed", [](const Find& find) { return find.is_confirmed ? 1 : 0; }, io::kInJson},
          {"left_out",
           [](const Find& find) { return fmt::to_string(fmt::join(paths_of(find.left_out), " ")); },
           io::kInJson}},
      test_columns("reduced_", &Find::reduced));
}

std::string number_text(const std::optional<double>& value) {
  return value ? fmt::format("{:.2f}", *value) : "-";
}

std::string scored_text(const SceneGroup& scenes) {
  const std::optional<Interval> interval = score_interval(scenes);
  std::string text = number_text(score_in(scenes));
  if (interval) text += fmt::format(" [{:.2f}, {:.2f}]", interval->low, interval->high);
  return text;
}

std::string excess_text(const PairedDifference& excess) {
  return excess.mean ? mean_text(*excess.mean, excess.interval, excess.pairs) : "-";
}

// "attackers 1, 2; defenders 4".
std::string robots_text(const SituationSetup& situation) {
  const auto numbers = [](const std::vector<DrawnRobot>& robots) {
    std::vector<int> all;
    all.reserve(robots.size());
    for (const DrawnRobot& robot : robots) all.push_back(robot.number);
    return all.empty() ? std::string("none") : fmt::to_string(fmt::join(all, ", "));
  };
  return fmt::format("attackers {}; defenders {}", numbers(situation.attackers),
                     numbers(situation.defenders));
}

io::Cells row_of(const Find& find) {
  io::Cells cells = {find.search.text(), number_text(find.searched)};
  if (!find.test) {
    io::append(cells, {"robots overlap", "-", "-", "-", "-"});
    return cells;
  }
  const ComparedScenes& test = *find.test;
  io::append(cells, {scored_text(test.scenes), scored_text(test.usual), excess_text(test.excess),
                     test.excess.p_holm ? p_text(*test.excess.p_holm) : "-",
                     find.is_confirmed ? "yes" : "no"});
  return cells;
}

// The name of a find in a scenario, where names have no dots.
std::string name_in_scenario(const SearchName& search) {
  return fmt::format("{}-{}", search.family, search.number);
}

SituationsByName confirmed_situations(const WeaknessState& state) {
  SituationsByName situations;
  for (const Find& find : state.finds) {
    if (!find.is_confirmed) continue;
    const std::string name = name_in_scenario(find.search);
    situations[name] = find.test->trial.situation;
    if (find.is_reduction_confirmed) situations[name + "-reduced"] = find.reduced->trial.situation;
  }
  return situations;
}

// A sentence on a confirmed weakness with the fewest robots.
std::string sentence_on(const Find& find) {
  const ComparedScenes& last = *find.last_test();
  if (!find.left_out.empty() && !find.is_reduction_confirmed)
    return fmt::format("{}: fewer robots do not show it.", find.search.text());
  const std::size_t all = robots_of(find.test->trial.situation).size();
  return fmt::format("{}: {} of {} robots show it ({}): {}, usually {} with these robots.",
                     find.search.text(), robots_of(last.trial.situation).size(), all,
                     robots_text(last.trial.situation), scored_text(last.scenes),
                     scored_text(last.usual));
}

std::string verdict_on(const WeaknessState& state) {
  std::string text;
  for (const Find& find : state.finds)
    if (find.is_confirmed) text += "\n" + sentence_on(find) + "\n";
  if (!text.empty()) return text;
  return "\nNo weakness was confirmed: on new scenes, the attackers do not score more than usual "
         "in any of these situations.\n";
}

}  // namespace

std::string weaknesses_csv(const WeaknessState& state) {
  return io::csv_text(io::table_rows(find_columns(), state.finds));
}

std::string search_csv(const WeaknessState& state) {
  const io::TableColumns<SearchStep> columns = {
      {"search", [](const SearchStep& step) { return step.search.text(); }},
      {"iteration", &SearchStep::iteration},
      {"mean_score", &SearchStep::mean_score},
      {"best_score", &SearchStep::best_score}};
  return io::csv_text(io::table_rows(columns, state.steps));
}

std::string weaknesses_yaml(const Weakness& weakness, const WeaknessState& state) {
  const SituationsByName situations = confirmed_situations(state);
  if (situations.empty()) return "# No weakness was confirmed.\n";
  Weakness copy = weakness;
  std::string text = fmt::format(
      "# Situations in which '{}' concedes more than usual, and the same with the fewest robots.\n"
      "schema: 1\nkind: situations\n",
      weakness.defenders.begin()->first);
  for (const Key& key : copy.keys()) {
    if (key.name == "base" || key.name == "attackers" || key.name == "defenders")
      text += key.text();
  }
  return text + situations_text(situations, weakness.base.field) +
         fmt::format("pairs: {}\nseed: {}\n", weakness.test_pairs, weakness.seed);
}

std::vector<ResultDrawing> weakness_drawings(const Weakness& weakness, const WeaknessState& state) {
  std::vector<ResultDrawing> drawings;
  for (const Find& find : state.finds) {
    if (!find.is_confirmed) continue;
    const ComparedScenes& last = *find.last_test();
    const std::string name = name_in_scenario(find.search);
    const game::StartState start = start_of_scene(last.trial, weakness.base.field, 1);
    drawings.push_back(
        {name + ".svg", sentence_on(find),
         drawing_of(start, weakness.base.field,
                    {weakness.attackers.begin()->first, weakness.defenders.begin()->first})});
  }
  return drawings;
}

std::vector<io::Cells> weakness_rows(const WeaknessState& state) {
  std::vector<io::Cells> rows = {{"search", "in the search", "on new scenes [95 %]", "usual [95 %]",
                                  "more than usual [95 %]", "p (Holm)", "confirmed"}};
  for (const Find& find : state.finds) rows.push_back(row_of(find));
  return rows;
}

std::string progress_text(const Weakness& weakness, const WeaknessState& state) {
  if (state.is_complete) return verdict_on(state);
  if (state.finds.empty()) {
    const int iterations = state.steps.empty() ? 0 : state.steps.back().iteration;
    if (iterations == weakness.iterations) return "testing on new scenes\n";
    return fmt::format("search: {} of {} iterations\n", iterations, weakness.iterations);
  }
  return "leaving out robots\n";
}

io::TextBlocks weaknesses_table(const Weakness& weakness, const WeaknessState& state) {
  return {io::TextTable{weakness_rows(state), kWeaknessColumns}, progress_text(weakness, state)};
}

io::Json json_of(const WeaknessState& state) {
  io::Json all = io::Json::array();
  for (const Find& find : state.finds) {
    io::Json one = io::Json::object();
    io::add_members(one, find_columns(), find);
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace autoref::experiments
