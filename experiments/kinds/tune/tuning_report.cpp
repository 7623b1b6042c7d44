#include "experiments/kinds/tune/tuning_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "experiments/analysis/groups.hpp"
#include "experiments/statistics/sample.hpp"
#include "game/settings/fields.hpp"
#include "io/words.hpp"

namespace autoref::experiments {
namespace {

constexpr const char* kNotShown = "not shown";

// Mean of the known scores. nullopt if there is none, and in self-play, where the mean would always
// be 0.
std::optional<double> mean_score(const Tuning& tuning, const TuningIteration& iteration) {
  std::vector<double> known;
  for (const Score& score : iteration.scores) {
    if (score) known.push_back(*score);
  }
  if (known.empty() || (tuning.is_against_itself() && tuning.method == kSpsaName))
    return std::nullopt;
  return mean(known);
}

// The first candidate's score minus the second's, for SPSA; otherwise the best minus the worst.
std::optional<double> score_difference(const Tuning& tuning, const TuningIteration& iteration) {
  if (tuning.method == kSpsaName) {
    const Score& plus = iteration.scores[0];
    const Score& minus = iteration.scores[1];
    return plus && minus ? std::optional(*plus - *minus) : std::nullopt;
  }
  std::vector<double> known;
  for (const Score& score : iteration.scores) {
    if (score) known.push_back(*score);
  }
  if (known.empty()) return std::nullopt;
  const auto [least, most] = std::minmax_element(known.begin(), known.end());
  return *most - *least;
}

io::Cells csv_cells_of(const ParamValues& after, const ParamValues& best) {
  io::Cells cells = spelt(after);
  const io::Cells more = spelt(best);
  io::append(cells, more);
  return cells;
}

std::string interval_text(const TuningTest& test) {
  return test.interval ? fmt::format("[{:+.2f}, {:+.2f}]", test.interval->low, test.interval->high)
                       : std::string("unknown");
}

std::string opponents_text(const Tuning& tuning) {
  if (tuning.is_against_itself()) return "against the start";
  std::vector<std::string> names;
  names.reserve(tuning.opponents.size());
  for (const auto& [name, team] : tuning.opponents) names.push_back(name);
  return fmt::format("against {}", io::listed(names));
}

std::string verdict_of(const Tuning& tuning, const TuningTest& test) {
  switch (test.state.verdict) {
    case ThreeWayVerdict::kBetter:
      return fmt::format(
          "The result is better than the start: its gain is nearer to {} goals per "
          "game than to 0.",
          tuning.test.d1);
    case ThreeWayVerdict::kWorse:
      return fmt::format(
          "The result is worse than the start: its loss is nearer to {} goals per "
          "game than to 0.",
          tuning.test.d1);
    case ThreeWayVerdict::kNotShown:
      return fmt::format(
          "The result is not shown to be better than the start: its gain is nearer "
          "to 0 than to {} goals per game.",
          tuning.test.d1);
    case ThreeWayVerdict::kUndecided:
      return fmt::format(
          "The result is not shown to be better than the start: {} pairs did not "
          "decide whether its gain is nearer to 0 or to {} goals per game.",
          tuning.test.max_pairs, tuning.test.d1);
    case ThreeWayVerdict::kGoOn:
      break;
  }
  return "The test that compares the result with the start is not decided yet.";
}

std::string gain_text(const Tuning& tuning, const TuningTest& test) {
  std::string text = fmt::format(
      "Gain over the start {}: {} goals per game, 95 % interval {}, from {} pairs of new games.",
      opponents_text(tuning), test.gain ? fmt::format("{:+.2f}", *test.gain) : "unknown",
      interval_text(test), test.state.pairs);
  if (test.void_pairs > 0) {
    text += fmt::format(" {} pairs with a void game are left out.", test.void_pairs);
  }
  return text;
}

// Those settings of the tuned team that differ from the defaults of a team.
std::string team_text(const Tuning& tuning, const ParamValues& values) {
  game::TeamSettings team = team_with(tuning, values);
  game::TeamSettings usual = tuning.base.a;
  const std::vector<game::Setting> defaults = game::settings_of(usual, tuning.base.types, "");
  std::string text;
  for (const game::Setting& setting : game::settings_of(team, tuning.base.types, "")) {
    if (game::is_alias(setting) || setting.path.starts_with("players")) continue;
    const game::Setting* its_default = game::find_setting(defaults, setting.path);
    const bool is_default =
        its_default != nullptr && game::value_of(*its_default) == game::value_of(setting);
    if (is_default && setting.path != "strategy") continue;
    text += fmt::format("  {}: {}\n", setting.path, game::value_of(setting));
  }
  if (!team.players.empty()) text += "  # and its players, as in the scenario of the tuning\n";
  return text;
}

}  // namespace

std::string tuning_csv(const Tuning& tuning, const TuningState& state) {
  io::Cells heads = {"iteration", "games"};
  for (const TunedParameter& parameter : tuning.parameters) heads.push_back(parameter.name);
  for (const TunedParameter& parameter : tuning.parameters) {
    heads.push_back("best." + parameter.name);
  }
  io::append(heads, {"score", "difference", "reach"});
  std::string csv = io::csv_line(heads) + "\n";
  io::Cells start = {"0", "0"};
  io::append(start, csv_cells_of(start_values(tuning), start_values(tuning)));
  io::append(start, {"", "", ""});
  csv += io::csv_line(start) + "\n";
  const int games = static_cast<int>(*tuning.games_of_a_round());
  for (const TuningIteration& iteration : state.path) {
    io::Cells cells = {std::to_string(iteration.number), std::to_string(iteration.number * games)};
    io::append(cells, csv_cells_of(iteration.after, iteration.best));
    io::append(cells, {io::number_cell(mean_score(tuning, iteration)),
                       io::number_cell(score_difference(tuning, iteration)),
                       io::number_cell(iteration.reach)});
    csv += io::csv_line(cells) + "\n";
  }
  return csv;
}

std::string tuning_test_csv(const Tuning& tuning, const TuningState& state) {
  const TuningTest& test = state.test;
  const auto& [low, high] = bounds_of(test.interval);
  return io::csv_line({"verdict", "gain", "low95", "high95", "pairs", "void_pairs", "delta",
                       "alpha", "beta", "min_pairs", "max_pairs"}) +
         "\n" +
         io::csv_line({name_of(test.state.verdict, kNotShown), io::number_cell(test.gain),
                       io::number_cell(low), io::number_cell(high),
                       std::to_string(test.state.pairs), std::to_string(test.void_pairs),
                       io::number_cell(tuning.test.d1), io::number_cell(tuning.test.alpha),
                       io::number_cell(tuning.test.beta), std::to_string(tuning.test.min_pairs),
                       std::to_string(tuning.test.max_pairs)}) +
         "\n";
}

std::string result_yaml(const Tuning& tuning, const TuningState& state) {
  std::string text = "# The tuned team, for `teams:` of a scenario.\n";
  if (state.is_tuned()) {
    text += "# " + verdict_of(tuning, state.test) + "\n# " + gain_text(tuning, state.test) + "\n";
  } else {
    text += fmt::format("# After {} of {} iterations, not tested.\n", state.path.size(),
                        tuning.iterations);
  }
  return text + "tuned:\n" + team_text(tuning, state.best);
}

std::vector<io::Cells> parameter_rows(const Tuning& tuning, const TuningState& state) {
  std::vector<io::Cells> rows = {{"parameter", "start", "now", "from", "to"}};
  const ParamValues start = start_values(tuning);
  for (std::size_t i = 0; i < tuning.parameters.size(); ++i) {
    const TunedParameter& parameter = tuning.parameters[i];
    rows.push_back({parameter.name, io::text_of(start[i]), io::text_of(state.best[i]),
                    io::text_of(parameter.from), io::text_of(parameter.to)});
  }
  return rows;
}

std::string comparison_text(const Tuning& tuning, const TuningState& state) {
  if (!state.is_tuned()) {
    return fmt::format("{} of {} iterations\n", state.path.size(), tuning.iterations);
  }
  return verdict_of(tuning, state.test) + "\n" + gain_text(tuning, state.test) + "\n";
}

io::TextBlocks tuning_table(const Tuning& tuning, const TuningState& state) {
  return {io::TextTable{parameter_rows(tuning, state), kParameterColumns},
          "\n" + comparison_text(tuning, state)};
}

io::Json json_of(const Tuning& tuning, const TuningState& state) {
  io::Json parameters = io::Json::array();
  for (std::size_t i = 0; i < tuning.parameters.size(); ++i) {
    const TunedParameter& parameter = tuning.parameters[i];
    parameters.push_back(
        {{"name", parameter.name}, {"start", parameter.start}, {"best", state.best[i]}});
  }
  const auto& [low, high] = bounds_of(state.test.interval);
  return {{"iteration", state.path.size()},
          {"iterations", tuning.iterations},
          {"parameters", parameters},
          {"verdict", name_of(state.test.state.verdict, kNotShown)},
          {"gain", io::json_number(state.test.gain)},
          {"low95", io::json_number(low)},
          {"high95", io::json_number(high)},
          {"pairs", state.test.state.pairs}};
}

SearchPath search_path(const Tuning& tuning, const TuningState& state) {
  SearchPath path{tuning.iterations, {}};
  for (std::size_t i = 0; i < tuning.parameters.size(); ++i) {
    const TunedParameter& parameter = tuning.parameters[i];
    SearchedParameter its{parameter.name, parameter.from, parameter.to, parameter.start, {}, {}};
    for (const TuningIteration& iteration : state.path) {
      its.values.push_back(iteration.after[i]);
      its.best.push_back(iteration.best[i]);
    }
    path.parameters.push_back(std::move(its));
  }
  return path;
}

}  // namespace autoref::experiments
