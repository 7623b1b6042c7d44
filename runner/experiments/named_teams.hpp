// Teams that play against each other under names of their own.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "runner/settings/game_settings.hpp"

namespace autoref::runner {

using Teams = std::map<std::string, TeamSettings>;  // by the names that rows call them

// What all experiments between such teams have.
struct NamedTeams {
  GameSettings base;  // its teams do not count; its seed, a_plays and first_kickoff neither
  Teams teams;
  std::uint64_t seed = 1;  // of the whole experiment
};

// Two of the teams by their names, the first being team a.
struct Matchup {
  std::string team_a;
  std::string team_b;
  bool operator==(const Matchup&) const = default;
};

// "bold~zone".
std::string matchup_name(const Matchup& matchup);

// Throws std::invalid_argument unless a team may be called so: letters, digits, - and _, without
// "-p", by which game ids tell the pair.
void check_team_name(std::string_view name);

}  // namespace autoref::runner
