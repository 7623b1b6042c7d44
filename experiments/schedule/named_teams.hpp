// Experiments between named teams.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "game/settings/game_settings.hpp"

namespace autoref::experiments {

using Teams = std::map<std::string, game::TeamSettings>;  // by name, as in result rows

// Settings shared by all experiments between named teams.
struct NamedTeams {
  game::GameSettings base;  // its teams, seed, a_plays and first_kickoff are ignored
  Teams teams;
  std::uint64_t seed = 1;  // master seed of the experiment
};

// The range of team counts that an experiment accepts.
struct TeamCount {
  std::size_t least = 2;
  std::size_t most = SIZE_MAX;
};

// The names of two teams that play each other.
struct Matchup {
  std::string team_a;
  std::string team_b;
  bool operator==(const Matchup&) const = default;
};

// "bold~zone".
std::string matchup_name(const Matchup& matchup);

// Throws std::invalid_argument unless the name consists of letters, digits, - and _, without "-p",
// which marks the pair in game ids.
void check_team_name(std::string_view name);

}  // namespace autoref::experiments
