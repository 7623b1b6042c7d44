#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>

#include "runner/cli/command_line.hpp"
#include "runner/cli/output_file.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/files.hpp"
#include "runner/logs/annotations.hpp"
#include "runner/logs/guessed_rules.hpp"
#include "runner/logs/log_game.hpp"
#include "runner/logs/log_page.hpp"
#include "runner/logs/log_report.hpp"
#include "runner/logs/recorded_teams.hpp"
#include "runner/logs/user_log.hpp"
#include "runner/settings/assignments.hpp"
#include "runner/settings/fields.hpp"
#include "runner/settings/resolved.hpp"
#include "soccer/colour.hpp"

namespace autoref::runner {
namespace {

bool assigns(const Assignments& assignments, const std::string& path) {
  return std::any_of(assignments.begin(), assignments.end(), [&path](const Assignment& assignment) {
    return full_path(assignment.path) == path;
  });
}

// The rule book must be chosen first: it provides field, robots and lengths, which the log then
// overrides.
void refuse_book_among(const Assignments& assignments) {
  for (const Assignment& assignment : assignments) {
    if (full_path(assignment.path) == "match.rules")
      throw InputError({assignment.flag}, "", "use --rules to choose the rule book");
  }
}

// The rule book chosen, or else guessed.
std::string book_of(const RefereeArguments& arguments, const RecordedFacts& facts) {
  if (!arguments.rules.empty()) return arguments.rules;
  const GuessedRules guessed = guessed_rules(facts.log);
  write_message(stderr, fmt::format("autoref: {}: {}: using the rules {} (change with --rules)\n",
                                    arguments.log, guessed.reason, guessed.book));
  return guessed.book;
}

GameSettings game_of(const RefereeArguments& arguments, const std::string& book,
                     const Assignments& assignments, const RecordedFacts& facts,
                     const RecordedGame& recorded) {
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
        {arguments.log}, "",
        fmt::format("this game cannot be refereed: {}; use --set to change it", error.what()));
  }
  return game;
}

void say_gaps(const RefereeArguments& arguments, const Assignments& assignments,
              const RecordedFacts& facts, const GameSettings& game) {
  const auto is_set = [&](const std::string& path) {
    if (path == "match.first_kickoff" && !arguments.first_kickoff.empty()) return true;
    return assigns(assignments, path);
  };
  for (const std::string& gap : gaps_of(facts, game, is_set))
    write_message(stderr, fmt::format("autoref: {}: {}\n", arguments.log, gap));
}

void say_keepers(const RefereeArguments& arguments, const RecordedFacts& facts) {
  for (const Side side : kSides) {
    const std::optional<int> keeper = facts.teams.actual_keepers[side];
    if (!keeper) continue;
    const std::string colour(colour_of(side));
    const std::string what =
        *keeper < 0
            ? "no other robot keeps it all the time: the rules on keepers do not apply to " + colour
            : fmt::format("robot {} keeps it: using {}", *keeper, *keeper);
    write_message(
        stderr, fmt::format("autoref: {}: the announced keeper of {} does not keep the goal; {}\n",
                            arguments.log, colour, what));
  }
}

std::vector<Call> annotated_calls(const RefereeArguments& arguments) {
  if (arguments.annotations.empty()) return {};
  return annotations_in(read_user_file(arguments.annotations), arguments.annotations);
}

league::FrameSource source_of(const RefereeArguments& arguments) {
  if (arguments.source.empty()) return league::FrameSource::kFirst;
  return arguments.source == "tracker" ? league::FrameSource::kTracker
                                       : league::FrameSource::kVision;
}

}  // namespace

int referee_verb(const RefereeArguments& arguments) {
  const Assignments assignments = assignments_in(arguments.sets);
  refuse_book_among(assignments);
  check_outputs({{"--events", arguments.events},
                 {"--game-events", arguments.game_events},
                 {"--report", arguments.report}},
                {arguments.log, arguments.annotations});
  std::optional<PendingFile> events;
  std::optional<PendingFile> game_events;
  std::optional<PendingFile> page;
  open_output(events, "--events", arguments.events);
  open_output(game_events, "--game-events", arguments.game_events);
  open_output(page, "--report", arguments.report);
  const std::vector<Call> annotated = annotated_calls(arguments);
  RecordedFacts facts = read_facts(arguments.log, source_of(arguments));
  write_message(stderr, damage_text(arguments.log, facts));
  if (facts.log.frames == 0) {
    throw InputError({arguments.log}, "",
                     arguments.source.empty()
                         ? "contains neither vision nor tracker packets to referee"
                         : fmt::format("contains no {} packets to referee", arguments.source));
  }
  const std::string book = book_of(arguments, facts);
  std::vector<referee::Configuration> games;
  for (const RecordedGame& recorded : facts.games) {
    const GameSettings game = game_of(arguments, book, assignments, facts, recorded);
    if (games.empty()) say_gaps(arguments, assignments, facts, game);
    games.push_back(referee_configuration(resolved(game)));
  }
  facts.teams = teams_in(arguments.log, games.front().field, games.front().rules.change_ends,
                         facts.log.source);
  say_keepers(arguments, facts);
  std::vector<RecordedDecision> decisions;
  const auto keep = [&](const referee::Decision& decision) {
    if (page) decisions.push_back(recorded(decision));
  };
  LogRefereeResult evaluation = referee_log(arguments.log, facts, games, keep);
  const Comparison comparison{!arguments.annotations.empty(), arguments.report};
  if (comparison.is_annotated)
    evaluation.agreement = agreement_with_annotations(annotated, evaluation.calls);
  if (events) events->commit(evaluation.events);
  if (game_events) game_events->commit(game_event_lines(evaluation.game_events));
  if (page)
    page->commit(log_page(arguments.log, games.front().field, decisions, evaluation.agreement,
                          facts.log.source));
  fmt::print("{}\n", arguments.json ? referee_log_json(evaluation, facts, comparison)
                                    : referee_log_text(evaluation, facts, comparison));
  return facts.log.damage ? kBadInput : kDone;
}

void add_referee_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand(
      "referee",
      "Referee a recorded game from its vision packets and compare with the recorded commands.");
  auto arguments = std::make_shared<RefereeArguments>();
  verb->add_option("--log,LOG", arguments->log, "A .log or .log.gz file.")
      ->type_name("FILE")
      ->required();
  verb->add_option("--rules", arguments->rules,
                   "Rule book (autoref rules lists them); guessed from the log's field and date "
                   "by default.")
      ->type_name("BOOK");
  verb->add_option("--first-kickoff", arguments->first_kickoff,
                   "Side of the first kick-off, overriding the log.")
      ->type_name("west|east");
  verb->add_option("--control", arguments->control,
                   "Who commands the game: human, the recorded referee (default if the log has "
                   "one); none, play is on throughout; or autoref.")
      ->type_name("human|none|autoref");
  verb->add_option("--source", arguments->source,
                   "Where robots and ball come from: the packets of vision (default if the log "
                   "begins with them) or those of a tracker.")
      ->type_name("vision|tracker")
      ->check(CLI::IsMember({"vision", "tracker"}));
  verb->add_option("--camera", arguments->camera, "Camera preset that describes the vision noise.")
      ->type_name("PRESET");
  add_set_option(*verb, arguments->sets);
  verb->add_option("--events", arguments->events,
                   "Write AutoRef's decisions to FILE, one JSON object per line.")
      ->type_name("FILE");
  verb->add_option("--game-events", arguments->game_events,
                   "Write AutoRef's decisions to FILE as the league's game events, one JSON object "
                   "per line.")
      ->type_name("FILE");
  verb->add_option("--report", arguments->report,
                   "Write an HTML page of the game with the calls of both referees.")
      ->type_name("FILE");
  verb->add_option("--annotations", arguments->annotations,
                   "Compare with a person's list of calls, a CSV file with the head "
                   "time,call,side, instead of the recorded commands.")
      ->type_name("FILE");
  verb->add_flag("--json", arguments->json, "Print one JSON object.");
  verb->footer(
      "Beside the recorded referee, AutoRef follows its commands and makes its own calls in "
      "between.\n"
      "With --control autoref it ignores them and runs the game by itself.\n\n"
      "Field, lengths of halves, first kick-off and robots are taken from the log if it has them;\n"
      "anything missing is reported once, with the option that sets it. A log of several games is\n"
      "refereed game by game. Yellow is west. If blue defends the goal at -x in the log, the\n"
      "field is rotated.\n\n"
      "Example:\n  autoref referee --log game.log.gz --camera paper --events events.jsonl");
  verb->callback(
      [arguments, &chosen] { chosen = [arguments] { return referee_verb(*arguments); }; });
}

}  // namespace autoref::runner
