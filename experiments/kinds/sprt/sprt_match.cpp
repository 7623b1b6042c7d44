#include "experiments/kinds/sprt/sprt_match.hpp"

#include <fmt/format.h>

#include <cassert>
#include <nlohmann/json.hpp>
#include <utility>

#include "experiments/analysis/standings_report.hpp"
#include "experiments/kinds/group_results.hpp"
#include "experiments/kinds/sprt/sprt_match_report.hpp"
#include "experiments/kinds/sprt/sprt_match_state.hpp"
#include "experiments/reading/settings_text.hpp"
#include "experiments/reading/top_reader.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "experiments/schedule/sequential_settings.hpp"

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

}  // namespace autoref::experiments
