#include "experiments/kinds/sprt/sprt_match.hpp"

#include <fmt/format.h>
#include <array>
#include <cassert>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "experiments/analysis/standings.hpp"
#include "experiments/kinds/results.hpp"
#include "experiments/reading/settings_text.hpp"
#include "experiments/reading/top_reader.hpp"
#include "experiments/results/game_row.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "experiments/schedule/schedule.hpp"
#include "experiments/schedule/sequential_settings.hpp"
#include "io/csv.hpp"

namespace autoref::experiments {
namespace {

constexpr const char* kSprt = "sprt";
constexpr Range kGoals = {-50, 50};
const std::vector<std::string> kRequired = {"d0", "d1", "max_pairs"};

// Requires d0, d1 and max_pairs; the error rates and min_pairs have defaults.
void read_sprt(TopReader& top, SequentialTest& test) {
  const game::YamlEntry& entry = top.required(kSprt);
  game::SettingsReader settings(top.file(), sprt_settings_of(test), top.locations());
  settings.read(entry, kSprt);
  const std::vector<game::YamlEntry> given = top.file().entries(entry, kSprt, settings.names());
  for (const std::string& key : kRequired) {
    if (game::find_entry(given, key) != nullptr) continue;
    top.file().refuse(entry.location, kSprt,
                      fmt::format("the key '{}' is missing; expected something like {{ d0: 0, d1: "
                                  "1, max_pairs: 200 }}",
                                  key));
  }
}

Key sprt_key(SequentialTest& test) {
  Key key{kSprt, "", "the hypotheses"};
  key.below = [&test]() -> KeysBelow {
    return {"the test", "", rows_of(sprt_settings_of(test), kRequired)};
  };
  key.read = [&test](TopReader& top) { read_sprt(top, test); };
  key.text = [&test] { return text_of(sprt_settings_of(test)); };
  key.pairs = &test.max_pairs;
  return key;
}

// The rows of a pair's two legs.
using Legs = std::array<const GameRow*, 2>;

std::optional<Legs> legs_of(const std::string& matchup, int pair, const RowsById& rows) {
  Legs legs{};
  for (const int leg : {1, 2}) {
    const auto row = rows.find(game_id(matchup, pair, leg));
    if (row == rows.end()) return std::nullopt;
    legs[static_cast<std::size_t>(leg - 1)] = &row->second;
  }
  return legs;
}

// The mean goal difference of a pair; nullopt if a leg is void.
std::optional<double> difference_of(const Legs& legs) {
  double sum = 0;
  for (const GameRow* leg : legs) {
    if (is_void(leg->record)) return std::nullopt;
    sum += leg->record.goals_a - leg->record.goals_b;
  }
  return sum / 2;
}

// The pairs before the first one with a missing row.
struct FirstPairs {
  std::vector<double> differences;  // differences of the pairs without a void leg
  std::vector<int> numbers;         // the numbers of these pairs
  int count = 0;                    // number of pairs, including those with a void leg
};

FirstPairs first_pairs(const SprtMatch& match, const RowsById& rows) {
  const std::string matchup = matchup_name(matchup_of(match));
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

std::string sentence(const SprtMatch& match, const SprtMatchState& state) {
  const Matchup matchup = matchup_of(match);
  const std::string goals =
      fmt::format("the mean lead of {} over {} in goals per game", matchup.team_a, matchup.team_b);
  switch (state.test.verdict) {
    case Verdict::kAcceptD0:
      return fmt::format("decided for d0: {} is nearer to {} than to {}", goals, match.sprt.d0,
                         match.sprt.d1);
    case Verdict::kAcceptD1:
      return fmt::format("decided for d1: {} is nearer to {} than to {}", goals, match.sprt.d1,
                         match.sprt.d0);
    case Verdict::kUndecided:
      return fmt::format("undecided whether {} is nearer to d0 = {} or to d1 = {}", goals,
                         match.sprt.d0, match.sprt.d1);
    case Verdict::kGoOn:
      break;
  }
  return fmt::format("not yet decided whether {} is nearer to d0 = {} or to d1 = {}", goals,
                     match.sprt.d0, match.sprt.d1);
}

}  // namespace

constinit const Kind SprtMatch::kKind = {kSprt, "Two teams, until a sequential test decides.",
                                         make};

Matchup matchup_of(const SprtMatch& match) {
  assert(match.teams.size() == 2);
  return {match.teams.begin()->first, match.teams.rbegin()->first};
}

std::vector<game::Setting> sprt_settings_of(SequentialTest& test) {
  const char* const goals = "goals per game";
  std::vector<game::Setting> settings = {
      {"sprt.d0", &test.d0, kGoals, {}, goals, "mean goal difference under the null hypothesis"},
      {"sprt.d1", &test.d1, kGoals, {}, goals, "mean goal difference under the alternative"}};
  for (game::Setting& setting : settings_of(test, kSprt,
                                            {"probability of accepting d1 if d0 is true",
                                             "probability of accepting d0 if d1 is true"}))
    settings.push_back(std::move(setting));
  return settings;
}

std::vector<Key> SprtMatch::keys() {
  Key two_teams =
      teams_key(*this, "differences are first minus second in alphabetical order", {2, 2});
  two_teams.value = "two teams by name";
  return {base_key(*this), std::move(two_teams), sprt_key(sprt), seed_key(seed)};
}

std::vector<ScheduledGame> SprtMatch::games() const {
  check_test(sprt, kSprt);
  check(base, teams);
  return games_of(*this, {matchup_of(*this)}, {0}, sprt.max_pairs);
}

std::string SprtMatch::caveat() const { return "at most, since the match ends once it is decided"; }

Schedule SprtMatch::schedule(const RowsById& rows) const {
  const SprtMatchState state = state_of(*this, rows);
  std::vector<ScheduledGame> all = games();
  const std::size_t needed =
      state.is_decided ? 2 * static_cast<std::size_t>(state.last_pair) : all.size();
  return {std::move(all), needed};
}

bool SprtMatch::is_decided(const RowsById& rows) const { return state_of(*this, rows).is_decided; }

ExperimentResults SprtMatch::results(const RowsById& rows) const {
  const SprtMatchState state = state_of(*this, rows);
  ExperimentResults results;
  results.groups = grouped({matchup_of(*this)}, rows);
  const Group& matchup = results.groups.front();
  results.files = {
      {"summary.csv", "the SPRT match and its verdict", sprt_match_csv(*this, matchup, state)}};
  results.table = sprt_match_table(*this, matchup, state);
  results.shown = {matchups_progress_table(results.groups)};
  results.shown.front().text = verdict_text(*this, state);
  results.json = std::make_shared<io::Json>(
      io::Json{{"groups", json_of(results.groups)},
               {"sprt",
                {{"verdict", name_of(state.test.verdict)},
                 {"test_pairs", state.test.pairs},
                 {"log_likelihood_ratio", state.test.log_likelihood_ratio}}}});
  return results;
}

SprtMatchState state_of(const SprtMatch& match, const RowsById& rows) {
  const FirstPairs first = first_pairs(match, rows);
  SprtMatchState state{decided_by(match.sprt, first.differences), first.count};
  if (state.test.verdict != Verdict::kGoOn) {
    state.last_pair = first.numbers[static_cast<std::size_t>(state.test.pairs - 1)];
  } else if (first.count == match.sprt.max_pairs) {  // void legs left fewer than max_pairs
    state.test.verdict = Verdict::kUndecided;
  }
  state.is_decided = state.test.verdict != Verdict::kGoOn;
  state.void_pairs = state.last_pair - state.test.pairs;
  return state;
}

std::string name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kAcceptD0:
      return "d0";
    case Verdict::kAcceptD1:
      return "d1";
    case Verdict::kUndecided:
      return "undecided";
    case Verdict::kGoOn:
      break;
  }
  return "none";
}

std::string sprt_match_csv(const SprtMatch& match, const Group& matchup,
                           const SprtMatchState& state) {
  io::Cells columns = io::heads_of(matchup_columns());
  io::append(columns, {"verdict", "test_pairs", "void_pairs", "log_likelihood_ratio", "d0", "d1",
                       "alpha", "beta", "min_pairs", "max_pairs"});
  io::Cells cells = io::cells_of(matchup_columns(), matchup);
  io::append(cells, {name_of(state.test.verdict), std::to_string(state.test.pairs),
                     std::to_string(state.void_pairs),
                     fmt::format("{:.4f}", state.test.log_likelihood_ratio)});
  SequentialTest test = match.sprt;
  for (const game::Setting& setting : sprt_settings_of(test))
    cells.push_back(game::value_of(setting));
  return io::csv_line(columns) + "\n" + io::csv_line(cells) + "\n";
}

std::string verdict_text(const SprtMatch& match, const SprtMatchState& state) {
  const SequentialTest& test = match.sprt;
  std::string text = fmt::format(
      "{}\nafter {} pairs of legs (minimum {}, maximum {}): log-likelihood ratio {:+.2f}, "
      "bounds {:+.2f} and {:+.2f}\n",
      sentence(match, state), state.test.pairs, test.min_pairs, test.max_pairs,
      state.test.log_likelihood_ratio, bound_of_d0(test), bound_of_d1(test));
  if (state.void_pairs > 0) {
    text += fmt::format("the test leaves out {} pairs with a void leg\n", state.void_pairs);
  }
  return text;
}

io::TextBlocks sprt_match_table(const SprtMatch& match, const Group& matchup,
                                const SprtMatchState& state) {
  return {matchups_table({matchup}), "\n" + verdict_text(match, state)};
}

}  // namespace autoref::experiments
