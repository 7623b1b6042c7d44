#include "runner/cli/settings.hpp"

#include <fmt/format.h>

#include "runner/settings/fields.hpp"
#include "runner/settings/robot_types.hpp"

namespace autoref::runner {
namespace {

void set(const std::string& assignment, GameConfiguration& game) {
  const std::string flag = "--set " + assignment;
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw InputError({flag}, "", "expected KEY=VALUE, such as match.half_s=60");
  }
  blame(flag, [&] {
    set_by_path(game, assignment.substr(0, equals), assignment.substr(equals + 1), {});
  });
}

}  // namespace

void apply_sets(const std::vector<std::string>& sets, GameConfiguration& game) {
  for (const std::string& assignment : sets) set(assignment, game);
  // Only all of them together need to make a game.
  blame(fmt::format("--set {}", fmt::join(sets, " --set ")), [&] { check_game(game); });
}

}  // namespace autoref::runner
