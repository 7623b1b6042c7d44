// Situations: short scenes that compare attacking teams against defending ones.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "runner/experiments/named_teams.hpp"
#include "runner/experiments/situation.hpp"

namespace autoref::runner {

// Every attacking team, as team a, plays every situation against every defending team. A name may
// be in both lists.
struct Situations {
  GameSettings base;  // its teams, seed, a_plays and first_kickoff are ignored
  Teams attackers;
  Teams defenders;
  std::map<std::string, SituationSetup> situations;
  int pairs = 1;           // scenes drawn of each situation, 1 to 9999; each is played in two legs
  std::uint64_t seed = 1;  // master seed
};

// A situation and the teams that play it: the values of a group of scenes.
struct SituationMatchup {
  std::string situation;
  std::string attackers;
  std::string defenders;
  auto operator<=>(const SituationMatchup&) const =
      default;  // NOLINT(modernize-use-nullptr): no pointer
};

// In the order of the names.
std::vector<SituationMatchup> matchups_of(const Situations& situations);

}  // namespace autoref::runner
