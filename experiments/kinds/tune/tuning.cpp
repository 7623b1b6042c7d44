#include "experiments/kinds/tune/tuning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "experiments/kinds/tune/tuning_report.hpp"
#include "experiments/kinds/tune/tuning_state.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "experiments/schedule/schedule.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/setting_value.hpp"
#include "io/words.hpp"
#include "soccer/random.hpp"

namespace autoref::experiments {
namespace {

constexpr std::uint64_t kSearchStream = 1;  // the schedule uses other streams (tuning_schedule.cpp)
constexpr int kDigits = 5;
// SPSA's least perturbation of a whole-number parameter, so that the two candidates' values always
// differ after rounding.
constexpr double kHalf = 0.5;

Axis axis_of(const TunedParameter& parameter) {
  const double step = parameter.step;
  return {parameter.from / step, parameter.to / step, parameter.start / step,
          parameter.whole ? kHalf / step : 0};
}

// Rounds `value` to kDigits digits of the range. The last step divides by a power of ten, so that
// the result is the double nearest to its decimal text.
double to_few_digits(double value, double range) {
  double scale = 1;
  for (int i = 0; i < kDigits; ++i) scale *= 10;
  while (range >= 10 && scale > 1) {
    range /= 10;
    scale /= 10;
  }
  while (range < 1 && scale < 1e15) {
    range *= 10;
    scale *= 10;
  }
  return std::round(value * scale) / scale;
}

double value_at(const TunedParameter& parameter, double coordinate) {
  const double value = coordinate * parameter.step;
  const double played =
      parameter.whole ? std::round(value) : to_few_digits(value, parameter.to - parameter.from);
  return std::clamp(played, parameter.from, parameter.to);
}

std::string path_of(const TunedParameter& parameter, const char* key) {
  return fmt::format("tune.{}.{}", parameter.name, key);
}

void check_whole(const TunedParameter& parameter) {
  if (!parameter.whole) return;
  for (const auto& [key, value] : {std::pair{"from", parameter.from}, std::pair{"to", parameter.to},
                                   std::pair{"start", parameter.start}}) {
    if (value == std::round(value)) continue;
    throw game::SettingError(path_of(parameter, key),
                             fmt::format(" is {}; this parameter needs a whole number", value));
  }
}

void check_range(const TunedParameter& parameter) {
  if (!(parameter.from < parameter.to)) {
    throw game::SettingError(
        path_of(parameter, "to"),
        fmt::format(" is {}; it must be above from, {}", parameter.to, parameter.from));
  }
  if (parameter.start < parameter.from || parameter.start > parameter.to) {
    throw game::SettingError(path_of(parameter, "start"),
                             fmt::format(" is {}; it must be from {} to {}", parameter.start,
                                         parameter.from, parameter.to));
  }
  if (!(parameter.step > 0) || parameter.step > parameter.to - parameter.from) {
    throw game::SettingError(path_of(parameter, "step"),
                             fmt::format(" is {}; it must be above 0 and at most the range, {}",
                                         parameter.step, parameter.to - parameter.from));
  }
  check_whole(parameter);
}

// Checks that the team's parameter can have this value.
void check_value(const Tuning& tuning, const TunedParameter& parameter, const char* key,
                 double value) {
  game::TeamSettings team = tuning.team;
  team.params[parameter.name] = value;
  try {
    game::check_team(tuning.base, team, "team");
  } catch (const game::SettingError& error) {
    if (error.path() != "team.params." + parameter.name) throw;
    throw game::SettingError(path_of(parameter, key),
                             std::string(error.what()).substr(error.path().size()));
  }
}

void check_opponents(const Tuning& tuning) {
  for (const char* name : {"plus", "minus", "centre", "result", "start"}) {
    if (!tuning.opponents.contains(name)) continue;
    throw game::SettingError(fmt::format("opponents.{}", name),
                             ": this name is reserved for games of the tuned team; choose another");
  }
  check(tuning.base, tuning.opponents, "opponents");
}

}  // namespace

double Tuning::weight_of(const std::string& opponent) const {
  const auto weight = weights.find(opponent);
  return weight == weights.end() ? 1 : weight->second;
}

std::unique_ptr<Optimiser> optimiser_of(const Tuning& tuning) {
  std::vector<Axis> axes;
  axes.reserve(tuning.parameters.size());
  for (const TunedParameter& parameter : tuning.parameters) axes.push_back(axis_of(parameter));
  Search search;
  search.method = tuning.method == kSpsaName ? Method::kSpsa : Method::kCmaEs;
  search.iterations = tuning.iterations;
  search.gain = tuning.gain;
  search.seed = mix_bits(mix_bits(tuning.seed) + kSearchStream);
  return make_optimiser(search, axes);
}

ParamValues values_at(const Tuning& tuning, const Point& point) {
  ParamValues values;
  values.reserve(tuning.parameters.size());
  for (const TunedParameter& parameter : tuning.parameters) {
    values.push_back(value_at(parameter, point[static_cast<Eigen::Index>(values.size())]));
  }
  return values;
}

ParamValues start_values(const Tuning& tuning) {
  ParamValues values;
  values.reserve(tuning.parameters.size());
  for (const TunedParameter& parameter : tuning.parameters) values.push_back(parameter.start);
  return values;
}

game::TeamSettings team_with(const Tuning& tuning, const ParamValues& values) {
  game::TeamSettings team = tuning.team;
  for (std::size_t i = 0; i < values.size(); ++i)
    team.params[tuning.parameters[i].name] = values[i];
  return team;
}

std::vector<std::string> spelt(const ParamValues& values) {
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const double value : values) texts.push_back(io::text_of(value));
  return texts;
}

constinit const Kind Tuning::kKind = {
    "tune", "A team's parameters, improved by playing; see [tuning](../tuning.md).", make};

void check(const Tuning& tuning) {
  game::check_game(tuning.base);
  refuse_game_controller(tuning.base);
  refuse_network(tuning.team, "team");
  game::check_team(tuning.base, tuning.team, "team");
  for (const TunedParameter& parameter : tuning.parameters) {
    check_range(parameter);
    check_value(tuning, parameter, "from", parameter.from);
    check_value(tuning, parameter, "to", parameter.to);
  }
  check_opponents(tuning);
}

std::vector<ScheduledGame> Tuning::games() const { return games_if_drawn(*this); }

std::string Tuning::caveat() const {
  return "at most, since the test of the result ends once it is decided";
}

std::vector<ScheduledGame> Tuning::trial_games(std::vector<ScheduledGame> all) const {
  for (ScheduledGame& game : all) {
    if (game.id.starts_with("k")) game.id = "search" + game.id.substr(game.id.find('-'));
  }
  return all;
}

Schedule Tuning::schedule(const RowsById& rows) const {
  const TuningState state = state_of(*this, rows);
  const int test_pairs = state.test.is_decided ? state.test.last_pair : test.max_pairs;
  const int needed = games_of_search(*this) + test_pairs * games_of_test_pair(*this);
  return {known_games(*this, state), static_cast<std::size_t>(needed)};
}

bool Tuning::is_decided(const RowsById& rows) const { return is_test_decided(*this, rows); }

std::optional<std::size_t> Tuning::games_of_a_round() const {
  return static_cast<std::size_t>(games_of_search(*this) / iterations);
}

std::vector<std::string> Tuning::value_columns() const {
  std::vector<std::string> paths;
  paths.reserve(parameters.size());
  for (const TunedParameter& parameter : parameters) paths.push_back("a.params." + parameter.name);
  return paths;
}

ExperimentResults Tuning::results(const RowsById& rows) const {
  const TuningState state = state_of(*this, rows);
  ExperimentResults results;
  results.search = search_path(*this, state);
  results.files = {{"tune.csv", "a row per iteration", tuning_csv(*this, state)},
                   {"summary.csv", "the test of the result", tuning_test_csv(*this, state)},
                   {"result.yaml", "the tuned team", result_yaml(*this, state)}};
  results.table = tuning_table(*this, state);
  results.shown = {{parameter_rows(*this, state), kParameterColumns, "parameters"}};
  results.shown.front().text = comparison_text(*this, state);
  results.json = std::make_shared<io::Json>(io::Json{{"tuning", json_of(*this, state)}});
  return results;
}

}  // namespace autoref::experiments
