// The bracket of a knockout: which ties there are, who meets in them and who goes on.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "runner/experiments/knockout.hpp"

namespace autoref::runner {

enum class DecidedBy { kNothing, kGoals, kExtraTime, kShootout, kForfeit, kSeed };

// "goals", "extra time", "shoot-out", "forfeit", "better seed"; "" as long as nothing decided it.
std::string name_of(DecidedBy decided_by);

struct Tie {
  int number = 1;    // over all rounds, counted from 1
  std::string name;  // "quarter-final 2", "final", "third place"
  // The better seed is a; none as long as the ties before are not decided.
  std::optional<std::string> a;
  std::optional<std::string> b;
  std::vector<std::string> games;  // ids of those that are played, in their order
  int void_games = 0;
  DecidedBy decided_by = DecidedBy::kNothing;
  bool a_won = false;

  bool is_known() const { return a.has_value() && b.has_value(); }
  bool is_decided() const { return decided_by != DecidedBy::kNothing; }
};

// The ties round by round, the final and after it the third place's at their end. Seeds are placed
// as is usual: were each tie won by the better seed, the first would meet the last in the first
// round, the two best in the final. Where the number of teams is no power of two, the best have no
// tie in the first round. `decide` is called for each tie whose teams are known.
std::vector<Tie> bracket_of(const Knockout& knockout, const std::function<void(Tie&)>& decide);

}  // namespace autoref::runner
