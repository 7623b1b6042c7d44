#include "experiments/kinds/weakness/weakness.hpp"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "experiments/kinds/weakness/weakness_report.hpp"
#include "experiments/kinds/weakness/weakness_state.hpp"
#include "experiments/scenes/scene_reader.hpp"
#include "experiments/scenes/situations_key.hpp"

namespace autoref::experiments {
namespace {

constexpr Range kSearchCount = {1, 99};
constexpr Range kSearchIterations = {1, 999};
constexpr Range kSceneCount = {1, kMostPairs};
constexpr Range kTestedPairs = {2, kMostPairs};  // fewer have no p value
constexpr Range kShare = {0, 1};
constexpr Range kKeptShare = {0, 1, true};

std::vector<game::Setting> settings_of(Weakness& weakness) {
  return {{"searches", &weakness.searches, kSearchCount, {}, "", "searches of each situation"},
          {"iterations", &weakness.iterations, kSearchIterations, {}, "", "steps of a search"},
          {"pairs",
           &weakness.pairs,
           kSceneCount,
           {},
           "",
           "scenes per candidate of a search, each played in both directions"},
          {"spread",
           &weakness.spread,
           kShare,
           {},
           "",
           "width of a candidate's ranges, as a fraction of the situation's ranges"},
          {"test.pairs", &weakness.test_pairs, kTestedPairs, {}, "", "scenes per test"},
          {"reduction.pairs",
           &weakness.reduction_pairs,
           kTestedPairs,
           {},
           "",
           "scenes per attempt to leave out a robot"},
          {"reduction.kept",
           &weakness.kept_share,
           kKeptShare,
           {},
           "",
           "fraction of a weakness that must remain when a robot is left out"}};
}

void check_weakness(const Weakness& weakness) {
  check_scenes(weakness.base, weakness.attackers, weakness.defenders, weakness.situations);
  for (const auto& [family, situation] : weakness.situations) {
    if (!searched_paths(situation, weakness.base.field).empty()) continue;
    throw game::SettingError(fmt::format("situations.{}", family),
                             ": give at least one value as a range such as [0.5, 2]; the search "
                             "varies the values that are ranges");
  }
}

// The scenes of the search and the tests, without the reduction.
double expected_scenes(const Weakness& weakness) {
  const auto families = static_cast<double>(weakness.situations.size());
  const double tests = families * (1 + weakness.searches) * 2 * weakness.test_pairs;
  return tests + static_cast<double>(*weakness.games_of_a_round()) * weakness.iterations;
}

}  // namespace

constinit const Kind Weakness::kKind = {
    "weakness",
    "A search for situations in which a team concedes far more than usual; see "
    "[weaknesses](../weaknesses.md).",
    make};

std::vector<Key> Weakness::keys() {
  const auto scene = std::make_shared<game::Scene>();
  std::vector<Key> all = {
      base_of_scenes_key(base),
      teams_key("attackers", "the attacking team; exactly one", attackers, base, {1, 1}),
      teams_key("defenders", "the team whose weaknesses are sought; exactly one", defenders, base,
                {1, 1})};
  for (Key& key : scene_keys(scene)) all.push_back(std::move(key));
  all.push_back(situations_key({&situations, &base, &attackers, &defenders}, scene));
  const ListSettings settings = [this] { return settings_of(*this); };
  for (const char* name : {"searches", "iterations"}) all.push_back(settings_key(name, settings));
  all.push_back(settings_key("pairs", settings));
  all.back().pairs = &pairs;
  all.push_back(settings_key("spread", settings));
  all.push_back(settings_branch_key("test", "the tests", "the tests on new scenes", settings));
  all.push_back(settings_branch_key("reduction", "the reduction",
                                    "the search for the fewest robots", settings));
  all.push_back(seed_key(seed));
  return all;
}

std::vector<ScheduledGame> Weakness::games() const {
  check_weakness(*this);
  refuse_too_many(expected_scenes(*this), "iterations");
  return games_of(*this, state_without_finds(*this).trials);
}

std::string Weakness::caveat() const {
  return "more, since confirmed weaknesses are played again with fewer robots";
}

std::vector<ScheduledGame> Weakness::trial_games(std::vector<ScheduledGame> all) const {
  for (ScheduledGame& game : all) {
    if (!game.id.starts_with("k")) continue;
    const std::size_t search = game.id.find('-');
    const std::size_t candidate = game.id.rfind("-x");
    game.id = "search" + game.id.substr(search, candidate - search) +
              game.id.substr(game.id.find("-p", candidate));
  }
  return all;
}

Schedule Weakness::schedule(const RowsById& rows) const {
  const WeaknessState state = state_of(*this, rows);
  Schedule schedule{games_of(*this, state.trials), 0};
  schedule.needed = schedule.games.size() + state.scenes_to_come;
  return schedule;
}

std::optional<std::size_t> Weakness::games_of_a_round() const {
  std::size_t games = 0;
  for (const auto& [family, situation] : situations) {
    const auto candidates = optimiser_of(situation, base.field, iterations, 0)->ask().size();
    games += 2 * candidates * static_cast<std::size_t>(searches * pairs);
  }
  return games;
}

ExperimentResults Weakness::results(const RowsById& rows) const {
  const WeaknessState state = state_of(*this, rows);
  ExperimentResults results;
  results.files = {{"weaknesses.csv", "a row per search", weaknesses_csv(state)},
                   {"search.csv", "a row per search and iteration", search_csv(state)},
                   {kWeaknessesFile, "the weaknesses as a scenario of kind situations",
                    weaknesses_yaml(*this, state)}};
  results.drawings = weakness_drawings(*this, state);
  results.table = weaknesses_table(*this, state);
  results.shown = {{weakness_rows(state), kWeaknessColumns, "searches"}};
  results.shown.front().text = progress_text(*this, state);
  results.json = std::make_shared<io::Json>(io::Json{{"weaknesses", json_of(state)}});
  return results;
}

}  // namespace autoref::experiments
