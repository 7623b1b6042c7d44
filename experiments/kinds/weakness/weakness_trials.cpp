#include "experiments/kinds/weakness/weakness_trials.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "game/settings/setting_value.hpp"
#include "io/processes/workers.hpp"
#include "soccer/random.hpp"

namespace autoref::experiments {
namespace {

// Seed streams derived from the master seed.
enum class SeedStream : std::uint8_t { kSearch = 1, kCandidates, kTest, kReduction, kFinal };

std::uint64_t seed_in(const Weakness& weakness, SeedStream stream, std::uint64_t number) {
  return mix_bits(mix_bits(mix_bits(weakness.seed) + static_cast<std::uint64_t>(stream)) + number);
}

// The settings that the scenes of a family share.
SharedSettings settings_of(const Weakness& weakness, const std::string& family) {
  game::GameSettings game = weakness.base;
  game.a = weakness.attackers.begin()->second;
  game.b = weakness.defenders.begin()->second;
  game.scene = weakness.situations.at(family).scene;
  return SharedSettings(std::move(game));
}

}  // namespace

std::string SearchName::text() const { return fmt::format("{}.{}", family, number); }

std::vector<SearchName> searches_of(const Weakness& weakness) {
  std::vector<SearchName> searches;
  for (const auto& [family, situation] : weakness.situations)
    for (int number = 1; number <= weakness.searches; ++number)
      searches.push_back({family, number});
  return searches;
}

std::uint64_t seed_of_search(const Weakness& weakness, const SearchName& search) {
  return seed_in(weakness, SeedStream::kSearch, static_cast<std::uint64_t>(search.number));
}

SceneTrial candidate_trial(const Weakness& weakness, const SearchName& search, int iteration,
                           const std::string& candidate, SituationSetup situation) {
  return {fmt::format("k{:04}-{}-{}", iteration, search.text(), candidate), search.family,
          std::move(situation),
          seed_in(weakness, SeedStream::kCandidates, static_cast<std::uint64_t>(iteration)),
          weakness.pairs};
}

SceneTrial usual_trial(const Weakness& weakness, const std::string& family) {
  return {"usual-" + family, family, weakness.situations.at(family),
          seed_in(weakness, SeedStream::kTest, 0), weakness.test_pairs};
}

SceneTrial test_trial(const Weakness& weakness, const SearchName& search,
                      SituationSetup situation) {
  return {"test-" + search.text(), search.family, std::move(situation),
          seed_in(weakness, SeedStream::kTest, 0), weakness.test_pairs};
}

ReducedTrials reduced_trials(const Weakness& weakness, const SearchName& search,
                             const SituationSetup& situation,
                             const std::vector<RobotOfSituation>& left_out, int round,
                             const std::string& attempt) {
  const bool is_final = attempt == kFinalAttempt;
  const std::uint64_t seed =
      is_final ? seed_in(weakness, SeedStream::kFinal, 0)
               : seed_in(weakness, SeedStream::kReduction, static_cast<std::uint64_t>(round));
  const int pairs = is_final ? weakness.test_pairs : weakness.reduction_pairs;
  const std::string name = is_final
                               ? fmt::format("{}-{}", kFinalAttempt, search.text())
                               : fmt::format("r{:02}-{}-without.{}", round, search.text(), attempt);
  return {{name, search.family, situation_without(situation, left_out), seed, pairs},
          {name + "-usual", search.family,
           situation_without(weakness.situations.at(search.family), left_out), seed, pairs}};
}

game::StartState start_of_scene(const SceneTrial& trial, const Field& field, int scene) {
  return drawn_state(trial.situation, trial.family, field, trial.seed, scene);
}

bool can_be_drawn(const SceneTrial& trial, const Field& field) {
  try {
    for (int scene = 1; scene <= trial.pairs; ++scene) start_of_scene(trial, field, scene);
  } catch (const game::SettingError&) {
    return false;
  }
  return true;
}

std::optional<SceneGroup> played_scenes(const Weakness& weakness, const SceneTrial& trial,
                                        const RowsById& rows) {
  std::vector<const GameRow*> scenes;
  for (int pair = 1; pair <= trial.pairs; ++pair) {
    for (const int leg : {1, 2}) {
      const auto row = rows.find(game_id(trial.name, pair, leg));
      if (row == rows.end()) return std::nullopt;
      const game::GameRecord& record = row->second.record;
      if (is_void(record) && io::was_killed(record.void_reason)) return std::nullopt;
      scenes.push_back(&row->second);
    }
  }
  const game::SceneWeights& weights = weakness.situations.at(trial.family).scene.weights;
  return scene_group(
      {trial.name, weakness.attackers.begin()->first, weakness.defenders.begin()->first},
      weights.is_proportion(), scenes);
}

std::vector<ScheduledGame> games_of(const Weakness& weakness,
                                    const std::vector<SceneTrial>& trials) {
  std::map<std::string, SharedSettings> settings;
  for (const auto& [family, situation] : weakness.situations)
    settings.emplace(family, settings_of(weakness, family));
  std::vector<ScheduledGame> games;
  std::size_t unit = 0;
  for (const SceneTrial& trial : trials) {
    for (int pair = 1; pair <= trial.pairs; ++pair, ++unit) {
      const SharedSettings scene = settings.at(trial.family)
                                       .starting_from(std::make_shared<const game::StartState>(
                                           start_of_scene(trial, weakness.base.field, pair)));
      for (const int leg : {1, 2}) {
        games.push_back({game_id(trial.name, pair, leg),
                         {trial.name},
                         pair,
                         leg,
                         scene.with(leg_of(trial.seed, pair, leg)),
                         weakness.attackers.begin()->first,
                         weakness.defenders.begin()->first});
        games.back().unit = unit;
      }
    }
  }
  return games;
}

}  // namespace autoref::experiments
