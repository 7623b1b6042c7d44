#include "runner/cli/referee_game.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "runner/io/errors.hpp"
#include "runner/logs/guessed_rules.hpp"
#include "runner/logs/log_game.hpp"
#include "runner/settings/fields.hpp"

namespace autoref::runner {
namespace {

bool assigns(const Assignments& assignments, const std::string& path) {
  return std::any_of(assignments.begin(), assignments.end(), [&path](const Assignment& assignment) {
    return full_path(assignment.path) == path;
  });
}

}  // namespace

void refuse_book_among(const Assignments& assignments) {
  for (const Assignment& assignment : assignments) {
    if (full_path(assignment.path) == "match.rules")
      throw InputError({assignment.flag}, "", "use --rules to choose the rule book");
  }
}

std::string book_of(const RefereeArguments& arguments, const RecordedFacts& facts,
                    const std::string& source) {
  if (!arguments.rules.empty()) return arguments.rules;
  const GuessedRules guessed = guessed_rules(facts.log);
  write_message(stderr, fmt::format("autoref: {}: {}: using the rules {} (change with --rules)\n",
                                    source, guessed.reason, guessed.book));
  return guessed.book;
}

GameSettings game_of(const RefereeArguments& arguments, const std::string& book,
                     const Assignments& assignments, const RecordedFacts& facts,
                     const RecordedGame& recorded, const std::string& source) {
  GameSettings game;
  blame("--rules", [&] { game = logged_game(book, facts, recorded); });
  const auto set = [&](const std::string& flag, const std::string& path, const std::string& value) {
    if (!value.empty()) blame(flag, [&] { set_by_path(game, path, value); });
  };
  set("--camera", "sim.camera", arguments.camera);
  set("--control", "match.control", arguments.control);
  set("--first-kickoff", "match.first_kickoff", arguments.first_kickoff);
  for (const Assignment& assignment : assignments) assign(assignment, game);
  try {
    check_judged(game);
  } catch (const std::invalid_argument& error) {
    throw InputError(
        {source}, "",
        fmt::format("this game cannot be refereed: {}; use --set to change it", error.what()));
  }
  return game;
}

void say_gaps(const RefereeArguments& arguments, const Assignments& assignments,
              const RecordedFacts& facts, const GameSettings& game, const std::string& source) {
  const auto is_set = [&](const std::string& path) {
    if (path == "match.first_kickoff" && !arguments.first_kickoff.empty()) return true;
    if (path == "match.control" && !arguments.control.empty()) return true;
    return assigns(assignments, path);
  };
  for (const std::string& gap : gaps_of(facts, game, is_set))
    write_message(stderr, fmt::format("autoref: {}: {}\n", source, gap));
}

}  // namespace autoref::runner
