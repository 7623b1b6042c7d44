#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "app/game/page_recorder.hpp"
#include "app/output_file.hpp"
#include "app/referee_game.hpp"
#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "game/loop/chain_log.hpp"
#include "game/settings/assignments.hpp"
#include "game/settings/game_settings.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/terminal.hpp"
#include "io/words.hpp"
#include "logs/calls.hpp"
#include "logs/log_page.hpp"
#include "logs/log_report.hpp"
#include "logs/log_tables.hpp"
#include "logs/recorded_teams.hpp"
#include "logs/user_log.hpp"
#include "soccer/side.hpp"

namespace autoref::app {
namespace {

struct RefereeLogArguments : RefereeArguments {
  std::string log;
  std::string annotations;  // CSV to compare with; empty: the recorded commands
  std::string chains;       // output file for possession chains; empty: none
  std::string actions;      // output file for actions; empty: none
  std::string report;       // output file for the page of both referees; empty: none
  bool json = false;
};

void print_keepers(const RefereeLogArguments& arguments, const logs::RecordedFacts& facts) {
  for (const Side side : kSides) {
    const std::optional<int> keeper = facts.teams.actual_keepers[side];
    if (!keeper) continue;
    const std::string colour(colour_of(side));
    const std::string what =
        *keeper < 0
            ? "no other robot stays in goal, so the rules on keepers do not apply to " + colour
            : fmt::format("robot {} does: using {}", *keeper, *keeper);
    io::write_message(
        stderr, fmt::format("autoref: {}: the announced keeper of {} does not keep the goal; {}\n",
                            arguments.log, colour, what));
  }
}

void print_ends(const RefereeLogArguments& arguments, const logs::RecordedFacts& facts) {
  const logs::TurnedStages& stages = facts.teams.turned;
  if (stages.empty()) return;
  std::vector<std::string> names;
  for (const Stage stage : stages) names.emplace_back(name_of(stage));
  io::write_message(
      stderr,
      fmt::format("autoref: {}: the referee packets and the "
                  "positions of both keepers disagree about which ends the teams defend in {}; "
                  "using the keepers' positions\n",
                  arguments.log, io::listed(names)));
}

std::vector<logs::Call> annotated_calls(const RefereeLogArguments& arguments) {
  if (arguments.annotations.empty()) return {};
  return logs::annotations_in(io::read_user_file(arguments.annotations), arguments.annotations);
}

league::FrameSource source_of(const RefereeLogArguments& arguments) {
  if (arguments.source.empty()) return league::FrameSource::kFirst;
  return arguments.source == "tracker" ? league::FrameSource::kTracker
                                       : league::FrameSource::kVision;
}

// Adds the chains, shots and actions to the recording, as a page shows them.
void add_play(const logs::PlayOfLog& play, view::GameRecording& recording) {
  constexpr double kRate_hz = logs::RecordedPlay::kRate_hz;
  for (const game::PossessionChain& chain : play.chains) recording.add(recorded(chain, kRate_hz));
  for (const logs::RecordedShot& shot : play.shots)
    recording.add(recorded(shot.shot, kRate_hz, shot.blue_on_positive_half));
  for (const logs::RecordedAction& action : play.actions)
    recording.add(recorded(action.action, kRate_hz, action.blue_on_positive_half));
}

std::string chains_text(const logs::PlayOfLog& play) {
  std::vector<game::ChainRow> rows;
  for (const game::PossessionChain& chain : play.chains)
    rows.push_back({static_cast<int>(rows.size()) + 1, chain});
  return io::csv_text(io::table_rows(
      game::chain_columns(logs::game_of_colours(), logs::RecordedPlay::kRate_hz), rows));
}

std::string actions_text(const logs::PlayOfLog& play) {
  std::vector<game::BallAction> rows;
  rows.reserve(play.actions.size());
  for (const logs::RecordedAction& recorded : play.actions) rows.push_back(recorded.action);
  return io::csv_text(io::table_rows(
      game::action_columns(logs::game_of_colours(), logs::RecordedPlay::kRate_hz), rows));
}

// The output files; nullopt: not wanted. They appear when the log has been refereed.
struct LogFiles {
  // Throws InputError naming the flag if a file cannot be written.
  explicit LogFiles(const RefereeLogArguments& arguments) {
    check_outputs({{"--events", arguments.events},
                   {"--game-events", arguments.game_events},
                   {"--chains", arguments.chains},
                   {"--actions", arguments.actions},
                   {"--report", arguments.report}},
                  {arguments.log, arguments.annotations});
    open_output(events, "--events", arguments.events);
    open_output(game_events, "--game-events", arguments.game_events);
    open_output(chains, "--chains", arguments.chains);
    open_output(actions, "--actions", arguments.actions);
    open_output(page, "--report", arguments.report);
  }

  // Writes all files but the page.
  void commit(const logs::LogRefereeResult& result) {
    if (events) events->commit(result.events);
    if (game_events) game_events->commit(game::game_event_lines(result.game_events));
    if (chains) chains->commit(chains_text(result.play));
    if (actions) actions->commit(actions_text(result.play));
  }

  std::optional<io::PendingFile> events;
  std::optional<io::PendingFile> game_events;
  std::optional<io::PendingFile> chains;
  std::optional<io::PendingFile> actions;
  std::optional<io::PendingFile> page;
};

int referee_log_verb(const RefereeLogArguments& arguments) {
  const game::Assignments assignments = game::assignments_in(arguments.sets);
  refuse_book_among(assignments);
  LogFiles files(arguments);
  const std::vector<logs::Call> annotated = annotated_calls(arguments);
  const std::string log = logs::seekable_log(arguments.log);
  logs::RecordedFacts facts = logs::read_facts(arguments.log, log, source_of(arguments));
  io::write_message(stderr, logs::damage_text(arguments.log, facts));
  check_has_frames(arguments, facts, arguments.log);
  const std::string book = book_of(arguments, facts, arguments.log);
  std::vector<referee::Configuration> games;
  for (const logs::RecordedGame& recorded : facts.games) {
    const game::GameSettings game =
        game_of(arguments, book, assignments, facts, recorded, arguments.log);
    if (games.empty()) print_gaps(arguments, assignments, facts, game, arguments.log);
    games.push_back(game::referee_configuration(game::resolved(game)));
  }
  facts.teams =
      logs::teams_in(log, games.front().field, games.front().rules.change_ends, facts.log.source);
  print_keepers(arguments, facts);
  print_ends(arguments, facts);
  view::GameRecording recording;
  const auto keep = [&](const referee::Decision& decision) {
    if (files.page) recording.add(recorded(decision));
  };
  logs::LogRefereeResult evaluation = logs::referee_log(log, facts, games, keep);
  const logs::Comparison comparison{!arguments.annotations.empty(), arguments.report};
  if (comparison.is_annotated)
    evaluation.agreement = logs::agreement_with_annotations(annotated, evaluation.calls);
  files.commit(evaluation);
  if (files.page) {
    add_play(evaluation.play, recording);
    files.page->commit(logs::log_page(log, arguments.log, games.front().field, recording,
                                      chain_kinds(), evaluation.agreement, facts.log.source));
  }
  fmt::print("{}\n", arguments.json
                         ? logs::referee_log_json(evaluation, facts, comparison)
                         : io::text_of(logs::referee_log_text(evaluation, facts, comparison),
                                       io::text_width(stdout)));
  return facts.log.damage ? io::kBadInput : io::kDone;
}

}  // namespace

void add_referee_log_verb(CLI::App& referee, Chosen& chosen) {
  CLI::App* verb = referee.add_subcommand(
      "log",
      "Referee a recorded game from its packets; compare the calls with the recorded referee's.");
  auto arguments = std::make_shared<RefereeLogArguments>();
  verb->add_option("--log,LOG", arguments->log, "A .log or .log.gz file.")
      ->required()
      ->type_name("FILE");
  add_referee_options(*verb, *arguments, "default if the log has one",
                      "default if the log begins with them");
  add_decision_outputs(*verb, arguments->events, arguments->game_events);
  add_play_outputs(*verb, arguments->chains, arguments->actions);
  verb->add_option("--report", arguments->report,
                   "Write an HTML page of the game with the calls of both referees.")
      ->type_name("FILE");
  verb->add_option("--annotations", arguments->annotations,
                   "Compare with a person's list of calls (a CSV file with the header "
                   "time,call,side) instead of the recorded commands.")
      ->type_name("FILE");
  add_json_flag(*verb, arguments->json);
  verb->footer(
      "AutoRef follows the commands of the recorded referee and makes its own calls in between.\n"
      "With --control autoref it ignores them and runs the game by itself.\n\n"
      "Field, lengths of halves, first kick-off and robots are taken from the log if it has them;\n"
      "anything missing is reported once, with the option that sets it. A log of several games is\n"
      "refereed game by game. Yellow is west. If blue defends the goal at -x in the log, the\n"
      "field is rotated.\n\n"
      "Example:\n  autoref referee log game.log.gz --camera paper --events events.jsonl");
  choose(*verb, chosen, arguments, referee_log_verb);
}

}  // namespace autoref::app
