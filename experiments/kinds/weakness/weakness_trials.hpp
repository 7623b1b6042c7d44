// The scenes that a search for weaknesses plays, in groups that share their distributions.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/kinds/weakness/weakness.hpp"
#include "experiments/kinds/weakness/weakness_search.hpp"
#include "experiments/results/game_row.hpp"
#include "experiments/scenes/scene_group.hpp"

namespace autoref::experiments {

// Scenes drawn from one situation: scene n is pair number n.
struct SceneTrial {
  std::string name;    // "k0007-midfield.2-x03"; start of its games' ids
  std::string family;  // name of the situation in the scenario
  SituationSetup situation;
  std::uint64_t seed = 0;
  int pairs = 1;
};

// A search: the family's name and the number of the search, counted from 1.
struct SearchName {
  std::string family;
  int number = 1;

  std::string text() const;  // "midfield.2"
  bool operator==(const SearchName&) const = default;
};

// All searches, by family and number.
std::vector<SearchName> searches_of(const Weakness& weakness);

// The trials of the four phases. Trials that are compared with each other share their seed, so
// equal pair numbers share their random numbers.
std::uint64_t seed_of_search(const Weakness& weakness, const SearchName& search);
SceneTrial candidate_trial(const Weakness& weakness, const SearchName& search, int iteration,
                           const std::string& candidate, SituationSetup situation);
SceneTrial usual_trial(const Weakness& weakness, const std::string& family);
SceneTrial test_trial(const Weakness& weakness, const SearchName& search, SituationSetup situation);

// A weakness in which some robots are left out, and its family without the same robots. `attempt`
// is part of the name: a robot's path, or "final" for the last test, which has its own seed.
struct ReducedTrials {
  SceneTrial reduced;
  SceneTrial usual;
};
inline constexpr const char* kFinalAttempt = "final";
ReducedTrials reduced_trials(const Weakness& weakness, const SearchName& search,
                             const SituationSetup& situation,
                             const std::vector<RobotOfSituation>& left_out, int round,
                             const std::string& attempt);

// The start of a scene, counted from 1, with the attackers in the west. Throws SettingError like
// drawn_state().
game::StartState start_of_scene(const SceneTrial& trial, const Field& field, int scene);

// Whether all scenes of the trial can be drawn. They cannot if robots overlap in every draw.
bool can_be_drawn(const SceneTrial& trial, const Field& field);

// The trial's scenes; nullopt if one of them has not been played. A scene whose worker was killed
// counts as not played, since it will be replayed.
std::optional<SceneGroup> played_scenes(const Weakness& weakness, const SceneTrial& trial,
                                        const RowsById& rows);

// The scenes of all trials in playing order, trial by trial.
std::vector<ScheduledGame> games_of(const Weakness& weakness,
                                    const std::vector<SceneTrial>& trials);

}  // namespace autoref::experiments
