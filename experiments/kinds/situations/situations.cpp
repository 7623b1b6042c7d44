#include "experiments/kinds/situations/situations.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "experiments/kinds/situations/situations_report.hpp"
#include "experiments/scenes/scene_reader.hpp"
#include "experiments/scenes/situations_key.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {
namespace {

// The settings of a matchup's scenes.
SharedSettings settings_of(const Situations& situations, const SituationMatchup& matchup) {
  game::GameSettings game = situations.base;
  game.a = situations.attackers.at(matchup.attackers);
  game.b = situations.defenders.at(matchup.defenders);
  game.scene = situations.situations.at(matchup.situation).scene;
  return SharedSettings(std::move(game));
}

ScheduledGame scheduled(const SituationMatchup& matchup, const SharedSettings& settings,
                        const LegSettings& its_leg, int pair, int leg) {
  const std::string played =
      fmt::format("{}+{}~{}", matchup.situation, matchup.attackers, matchup.defenders);
  return {game_id(played, pair, leg), {matchup.situation}, pair, leg, settings.with(its_leg),
          matchup.attackers,          matchup.defenders};
}

// Indices into matchups_of().
std::vector<std::size_t> playing_order(const Situations& situations) {
  return combinations_order(
      {situations.situations.size(), situations.defenders.size(), situations.attackers.size()});
}

}  // namespace

constinit const Kind Situations::kKind = {
    "situations",
    "Attacking teams against defending teams in short scenes; see [situations](../situations.md).",
    make};

std::vector<SituationMatchup> matchups_of(const Situations& situations) {
  std::vector<SituationMatchup> matchups;
  for (const auto& [situation, its] : situations.situations) {
    for (const auto& [defenders, its_team] : situations.defenders) {
      for (const auto& [attackers, team] : situations.attackers)
        matchups.push_back({situation, attackers, defenders});
    }
  }
  return matchups;
}

std::vector<Key> Situations::keys() {
  const auto scene = std::make_shared<game::Scene>();
  std::vector<Key> all = {
      base_of_scenes_key(base),
      teams_key("attackers", "the teams that are compared", attackers, base, {1}),
      teams_key("defenders", "their opponents", defenders, base, {1})};
  for (Key& key : scene_keys(scene)) all.push_back(std::move(key));
  all.push_back(situations_key({&situations, &base, &attackers, &defenders}, scene));
  all.push_back(pairs_key(pairs, "scenes per situation and teams, each played in both directions"));
  all.push_back(seed_key(seed));
  return all;
}

std::vector<ScheduledGame> Situations::games() const {
  const std::vector<SituationMatchup> matchups = matchups_of(*this);
  refuse_too_many(2.0 * pairs * static_cast<double>(matchups.size()));
  check_scenes(base, attackers, defenders, situations);
  std::vector<SharedSettings> settings;
  settings.reserve(matchups.size());
  for (const SituationMatchup& matchup : matchups) settings.push_back(settings_of(*this, matchup));
  const std::vector<std::size_t> order = playing_order(*this);
  std::vector<ScheduledGame> games;
  for (int pair = 1; pair <= pairs; ++pair) {
    std::map<std::string, std::shared_ptr<const game::StartState>> starts;
    for (const auto& [name, situation] : situations)
      starts[name] = std::make_shared<const game::StartState>(
          drawn_state(situation, name, base.field, seed, pair));
    for (const std::size_t i : order) {
      const SharedSettings scene = settings[i].starting_from(starts.at(matchups[i].situation));
      for (const int leg : {1, 2}) {
        games.push_back(scheduled(matchups[i], scene, leg_of(seed, pair, leg), pair, leg));
        games.back().unit = (games.size() - 1) / 2;
        games.back().variant = i;
        games.back().variants = matchups.size();
      }
    }
  }
  return games;
}

ExperimentResults Situations::results(const RowsById& rows) const {
  const std::vector<SceneGroup> groups = scene_groups(*this, rows);
  const std::vector<SceneDifference> differences = scene_differences(groups);
  ExperimentResults results;
  results.files = {
      {"summary.csv", "a row per situation and teams", scenes_csv(groups)},
      {"differences.csv", "a row per two attacking teams", scene_differences_csv(differences)}};
  results.table = scenes_table(groups, differences);
  results.shown = {{scenes_rows(groups), kScenesColumns, "situations"}};
  results.json = std::make_shared<io::Json>(io::Json{{"situations", json_of(groups)}});
  return results;
}

}  // namespace autoref::experiments
