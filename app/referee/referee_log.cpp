#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "app/command_line.hpp"
#include "app/game/page_recorder.hpp"
#include "app/one_of.hpp"
#include "app/output_file.hpp"
#include "app/referee/referee_game.hpp"
#include "game/settings/assignments.hpp"
#include "game/settings/game_settings.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/terminal.hpp"
#include "io/words.hpp"
#include "logs/calls.hpp"
#include "logs/log_page.hpp"
#include "logs/log_report.hpp"
#include "logs/recorded_teams.hpp"
#include "logs/user_log.hpp"
#include "soccer/side.hpp"

namespace autoref::app {
namespace {

void say_keepers(const RefereeArguments& arguments, const logs::RecordedFacts& facts) {
  for (const Side side : kSides) {
    const std::optional<int> keeper = facts.teams.actual_keepers[side];
    if (!keeper) continue;
    const std::string colour(colour_of(side));
    const std::string what =
        *keeper < 0
            ? "no other robot keeps it all the time: the rules on keepers do not apply to " + colour
            : fmt::format("robot {} keeps it: using {}", *keeper, *keeper);
    io::write_message(
        stderr, fmt::format("autoref: {}: the announced keeper of {} does not keep the goal; {}\n",
                            arguments.log, colour, what));
  }
}

void say_ends(const RefereeArguments& arguments, const logs::RecordedFacts& facts) {
  const logs::TurnedStages& stages = facts.teams.turned;
  if (stages.empty()) return;
  std::vector<std::string> names;
  for (const Stage stage : stages) names.emplace_back(name_of(stage));
  io::write_message(stderr, fmt::format("autoref: {}: both keepers are at the other ends than the "
                                        "referee packets say in {}; using those that are seen\n",
                                        arguments.log, io::listed(names)));
}

std::vector<logs::Call> annotated_calls(const RefereeArguments& arguments) {
  if (arguments.annotations.empty()) return {};
  return logs::annotations_in(io::read_user_file(arguments.annotations), arguments.annotations);
}

league::FrameSource source_of(const RefereeArguments& arguments) {
  if (arguments.source.empty()) return league::FrameSource::kFirst;
  return arguments.source == "tracker" ? league::FrameSource::kTracker
                                       : league::FrameSource::kVision;
}

void add_outputs(CLI::App& verb, RefereeArguments& arguments) {
  verb.add_option("--events", arguments.events,
                  "Write AutoRef's decisions to FILE, one JSON object per line.")
      ->type_name("FILE");
  verb.add_option("--game-events", arguments.game_events,
                  "Write AutoRef's decisions to FILE as the league's game events, one JSON object "
                  "per line.")
      ->type_name("FILE");
  verb.add_option("--report", arguments.report,
                  "Write an HTML page of the game with the calls of both referees.")
      ->type_name("FILE");
  verb.add_option("--annotations", arguments.annotations,
                  "Compare with a person's list of calls, a CSV file with the head "
                  "time,call,side, instead of the recorded commands.")
      ->type_name("FILE");
  verb.add_flag("--json", arguments.json, "Print one JSON object.");
}

}  // namespace

int referee_verb(const RefereeArguments& arguments) {
  if (arguments.is_live) return live_referee_verb(arguments);
  if (arguments.log.empty())
    throw io::InputError({"--log"}, "",
                         "name a log, or referee the game on the network with --live");
  const game::Assignments assignments = game::assignments_in(arguments.sets);
  refuse_book_among(assignments);
  check_outputs({{"--events", arguments.events},
                 {"--game-events", arguments.game_events},
                 {"--report", arguments.report}},
                {arguments.log, arguments.annotations});
  std::optional<io::PendingFile> events;
  std::optional<io::PendingFile> game_events;
  std::optional<io::PendingFile> page;
  open_output(events, "--events", arguments.events);
  open_output(game_events, "--game-events", arguments.game_events);
  open_output(page, "--report", arguments.report);
  const std::vector<logs::Call> annotated = annotated_calls(arguments);
  const std::string log = logs::seekable_log(arguments.log);
  logs::RecordedFacts facts = read_facts(arguments.log, log, source_of(arguments));
  io::write_message(stderr, logs::damage_text(arguments.log, facts));
  if (facts.log.frames == 0) {
    throw io::InputError({arguments.log}, "",
                         arguments.source.empty()
                             ? "contains neither vision nor tracker packets to referee"
                             : fmt::format("contains no {} packets to referee", arguments.source));
  }
  const std::string book = book_of(arguments, facts, arguments.log);
  std::vector<referee::Configuration> games;
  for (const logs::RecordedGame& recorded : facts.games) {
    const game::GameSettings game =
        game_of(arguments, book, assignments, facts, recorded, arguments.log);
    if (games.empty()) say_gaps(arguments, assignments, facts, game, arguments.log);
    games.push_back(game::referee_configuration(game::resolved(game)));
  }
  facts.teams =
      logs::teams_in(log, games.front().field, games.front().rules.change_ends, facts.log.source);
  say_keepers(arguments, facts);
  say_ends(arguments, facts);
  std::vector<view::RecordedDecision> decisions;
  const auto keep = [&](const referee::Decision& decision) {
    if (page) decisions.push_back(recorded(decision));
  };
  logs::LogRefereeResult evaluation = logs::referee_log(log, facts, games, keep);
  const logs::Comparison comparison{!arguments.annotations.empty(), arguments.report};
  if (comparison.is_annotated)
    evaluation.agreement = logs::agreement_with_annotations(annotated, evaluation.calls);
  if (events) events->commit(evaluation.events);
  if (game_events) game_events->commit(game::game_event_lines(evaluation.game_events));
  if (page)
    page->commit(logs::log_page(log, arguments.log, games.front().field, decisions,
                                evaluation.agreement, facts.log.source));
  fmt::print("{}\n", arguments.json
                         ? logs::referee_log_json(evaluation, facts, comparison)
                         : io::text_of(logs::referee_log_text(evaluation, facts, comparison),
                                       io::text_width(stdout)));
  return facts.log.damage ? io::kBadInput : io::kDone;
}

void add_referee_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand(
      "referee",
      "Referee a recorded or live game from its vision packets, alone or beside another referee.");
  auto arguments = std::make_shared<RefereeArguments>();
  CLI::Option* log = verb->add_option("--log,LOG", arguments->log, "A .log or .log.gz file.");
  log->type_name("FILE");
  CLI::Option* live = verb->add_flag("--live", arguments->is_live,
                                     "Referee the game on the league's network instead of a log.");
  live->excludes(log);
  add_live_referee_options(*verb, *arguments);
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
      ->check(one_of({"vision", "tracker"}));
  verb->add_option("--camera", arguments->camera, "Camera preset that describes the vision noise.")
      ->type_name("PRESET");
  add_set_option(*verb, arguments->sets);
  add_outputs(*verb, *arguments);
  verb->footer(
      "Beside the recorded referee, AutoRef follows its commands and makes its own calls in "
      "between.\n"
      "With --control autoref it ignores them and runs the game by itself.\n\n"
      "Field, lengths of halves, first kick-off and robots are taken from the log if it has them;\n"
      "anything missing is reported once, with the option that sets it. A log of several games is\n"
      "refereed game by game. Yellow is west. If blue defends the goal at -x in the log, the\n"
      "field is rotated.\n\n"
      "With --live, AutoRef judges the packets on the network until Ctrl-C and only says what it\n"
      "would call. With --game-controller it reports to the league's game controller; with\n"
      "--control autoref it commands the game itself.\n\n"
      "Example:\n  autoref referee --log game.log.gz --camera paper --events events.jsonl\n"
      "  autoref referee --live --interface 192.168.1.20 --game-controller auto");
  verb->callback(
      [arguments, &chosen] { chosen = [arguments] { return referee_verb(*arguments); }; });
}

}  // namespace autoref::app
