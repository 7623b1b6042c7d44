#include "game/settings/assignments.hpp"

#include <fmt/format.h>

#include "game/settings/fields.hpp"
#include "io/words.hpp"

namespace autoref::game {
namespace {

Assignment assignment_in(const std::string& set) {
  const std::string flag = "--set " + set;
  const std::size_t equals = set.find('=');
  const std::string key(io::trimmed(std::string_view(set).substr(0, equals)));
  if (equals == std::string::npos || key.empty()) {
    throw io::InputError({flag}, "", "expected KEY=VALUE, such as match.half_s=60");
  }
  return {flag, key, std::string(io::trimmed(std::string_view(set).substr(equals + 1)))};
}

}  // namespace

Assignments assignments_in(const std::vector<std::string>& sets) {
  Assignments all;
  for (const std::string& set : sets) {
    Assignment next = assignment_in(set);
    for (const Assignment& other : all) {
      // If a key is given twice, the last value counts.
      const std::string path = full_path(next.path);
      const std::string others = full_path(other.path);
      if (path == others || !sets_same_number(path, others)) continue;
      throw io::InputError({next.flag}, "",
                           fmt::format("{} sets the same value; leave one out", other.flag));
    }
    all.push_back(std::move(next));
  }
  return all;
}

std::string flags_of(const Assignments& assignments) {
  std::vector<std::string> flags;
  for (const Assignment& assignment : assignments) flags.push_back(assignment.flag);
  return fmt::format("{}", fmt::join(flags, " "));
}

void assign(const Assignment& assignment, GameSettings& game) {
  locate_errors(assignment.flag, [&] { set_by_path(game, assignment.path, assignment.value); });
}

void assign_all(const Assignments& assignments, GameSettings& game) {
  for (const Assignment& assignment : assignments) assign(assignment, game);
  // The settings only need to be valid together, not after each single assignment.
  locate_errors(flags_of(assignments), [&] { check_game(game); });
}

}  // namespace autoref::game
