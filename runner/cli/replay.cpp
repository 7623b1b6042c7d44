#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "runner/batch/program_files.hpp"
#include "runner/batch/result_folder.hpp"
#include "runner/cli/command_line.hpp"
#include "runner/cli/named_game.hpp"
#include "runner/cli/play_one.hpp"
#include "runner/io/build_id.hpp"
#include "runner/io/checksum.hpp"
#include "runner/io/errors.hpp"
#include "runner/settings/resolved.hpp"

namespace autoref::runner {
namespace {

namespace fs = std::filesystem;

}  // namespace

int replay_verb(const ReplayArguments& arguments) {
  const ResultFolder folder = open_results(arguments.folder, arguments.build);
  const ScheduledGame& game = game_named(folder, arguments.game);
  const fs::path commands = commands_file(folder.path, game.id);
  const GameRecord record =
      play_one(resolved(game), arguments.output, files_of_results(folder.path),
               {fs::exists(commands) ? commands : fs::path(), FileKind::kFile});
  const auto row = folder.completed_games.done.find(game.id);
  if (row == folder.completed_games.done.end()) return kDone;
  const std::uint64_t stored = row->second.record.state_hash;
  if (stored == record.state_hash) return kDone;
  write_message(
      stderr,
      fmt::format("autoref: the row of build {0} has another final state, {1}; this is build {2}\n",
                  folder.build, hash_text(stored), build_id()));
  return kDifferent;
}

void add_replay_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("replay", "Play one game of a results folder again.");
  auto arguments = std::make_shared<ReplayArguments>();
  add_folder_options(*verb, *arguments);
  verb->add_option(
          "GAME_ID", arguments->game,
          "A game's id from the first column of results.csv, or a fault's id from faults.csv.")
      ->required();
  add_output_options(*verb, arguments->output);
  add_speed_option(*verb, arguments->output);
  verb->footer(
      "Example:\n  autoref replay results/runs/handicap-speed b.handicap=0.8-p0007-2 --events "
      "events.jsonl");
  verb->callback(
      [arguments, &chosen] { chosen = [arguments] { return replay_verb(*arguments); }; });
}

}  // namespace autoref::runner
