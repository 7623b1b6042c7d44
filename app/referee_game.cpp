#include "app/referee_game.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/shared_options.hpp"
#include "game/settings/fields.hpp"
#include "io/errors.hpp"
#include "logs/log_game.hpp"
#include "soccer/rules/rule_changes.hpp"

namespace autoref::app {
namespace {

bool assigns(const game::Assignments& assignments, const std::string& path) {
  return std::any_of(assignments.begin(), assignments.end(),
                     [&path](const game::Assignment& assignment) {
                       return game::full_path(assignment.path) == path;
                     });
}

}  // namespace

void add_referee_options(CLI::App& verb, RefereeArguments& arguments,
                         const std::string& default_control, const std::string& default_source) {
  verb.add_option("--rules", arguments.rules,
                  "Rule book (autoref show rules lists them); guessed from the field and the date "
                  "by default.")
      ->type_name("BOOK");
  verb.add_option("--first-kickoff", arguments.first_kickoff,
                  "Side that takes the first kick-off, overriding the packets.")
      ->type_name("west|east");
  verb.add_option("--control", arguments.control,
                  fmt::format("Who commands the game. human: the other referee ({}); none: "
                              "nobody, play is on throughout; autoref: AutoRef.",
                              default_control))
      ->type_name("human|none|autoref");
  verb.add_option(
          "--source", arguments.source,
          fmt::format(
              "Source of the positions of robots and ball: vision packets ({}) or tracker packets.",
              default_source))
      ->type_name("SOURCE")
      ->check(one_of({"vision", "tracker"}));
  verb.add_option("--camera", arguments.camera, "Camera preset that describes the vision noise.")
      ->type_name("PRESET");
  add_set_option(verb, arguments.sets);
}

void refuse_book_among(const game::Assignments& assignments) {
  for (const game::Assignment& assignment : assignments) {
    if (game::full_path(assignment.path) == kRuleBookPath)
      throw io::InputError({assignment.flag}, "", "use --rules to choose the rule book");
  }
}

void check_has_frames(const RefereeArguments& arguments, const logs::RecordedFacts& facts,
                      const std::string& source) {
  if (facts.log.frames > 0) return;
  throw io::InputError({source}, "",
                       arguments.source.empty()
                           ? "contains neither vision nor tracker packets to referee"
                           : fmt::format("contains no {} packets to referee", arguments.source));
}

std::string book_of(const RefereeArguments& arguments, const logs::RecordedFacts& facts,
                    const std::string& source) {
  if (!arguments.rules.empty()) return arguments.rules;
  const logs::GuessedRules guessed = logs::guessed_rules(facts.log);
  io::write_message(
      stderr, fmt::format("autoref: {}: {}: using the rules {} (change with --rules)\n", source,
                          guessed.reason, guessed.book));
  return guessed.book;
}

game::GameSettings game_of(const RefereeArguments& arguments, const std::string& book,
                           const game::Assignments& assignments, const logs::RecordedFacts& facts,
                           const logs::RecordedGame& recorded, const std::string& source) {
  game::GameSettings game;
  game::locate_errors("--rules", [&] { game = logs::logged_game(book, facts, recorded); });
  const auto set = [&](const std::string& flag, const std::string& path, const std::string& value) {
    if (!value.empty()) game::locate_errors(flag, [&] { game::set_by_path(game, path, value); });
  };
  set("--camera", "sim.camera", arguments.camera);
  set("--control", "match.control", arguments.control);
  set("--first-kickoff", "match.first_kickoff", arguments.first_kickoff);
  for (const game::Assignment& assignment : assignments) game::assign(assignment, game);
  try {
    logs::check_judged(game);
  } catch (const std::invalid_argument& error) {
    throw io::InputError(
        {source}, "",
        fmt::format("this game cannot be refereed: {}; use --set to change it", error.what()));
  }
  return game;
}

void print_gaps(const RefereeArguments& arguments, const game::Assignments& assignments,
                const logs::RecordedFacts& facts, const game::GameSettings& game,
                const std::string& source) {
  const auto is_set = [&](const std::string& path) {
    if (path == "match.first_kickoff" && !arguments.first_kickoff.empty()) return true;
    if (path == "match.control" && !arguments.control.empty()) return true;
    return assigns(assignments, path);
  };
  for (const std::string& gap : logs::gaps_of(facts, game, is_set))
    io::write_message(stderr, fmt::format("autoref: {}: {}\n", source, gap));
}

}  // namespace autoref::app
