#include "runner/settings/team_names.hpp"

#include <fmt/format.h>

#include "runner/settings/match_rules.hpp"

namespace autoref::runner {

PerSide<std::string> shown_names(const GameConfiguration& game) {
  PerSide<std::string> names;
  for (const Side side : kSides) {
    names[side] = team_on(game, side).strategy;
    const char letter = side == game.match.a_plays ? 'a' : 'b';
    if (game.a.strategy == game.b.strategy) names[side] += fmt::format(" ({})", letter);
  }
  return names;
}

}  // namespace autoref::runner
