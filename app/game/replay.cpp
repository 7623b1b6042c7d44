#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "app/command_line.hpp"
#include "app/game/named_game.hpp"
#include "app/game/play_one.hpp"
#include "experiments/run/program_files.hpp"
#include "experiments/run/result_folder.hpp"
#include "game/settings/resolved.hpp"
#include "io/build_id.hpp"
#include "io/checksum.hpp"
#include "io/errors.hpp"

namespace autoref::app {
namespace {

namespace fs = std::filesystem;

}  // namespace

int replay_verb(const ReplayArguments& arguments) {
  const experiments::ResultFolder folder =
      experiments::open_results(arguments.folder, arguments.build);
  const experiments::ScheduledGame& game = game_named(folder, arguments.game);
  const fs::path commands = experiments::commands_file(folder.path, game.id);
  const game::GameRecord record = play_one(
      experiments::resolved(game), arguments.output, experiments::files_of_results(folder.path),
      {fs::exists(commands) ? commands : fs::path(), io::FileKind::kFile});
  const auto row = folder.completed_games.done.find(game.id);
  if (row == folder.completed_games.done.end()) return io::kDone;
  const std::uint64_t stored = row->second.record.state_hash;
  if (stored == record.state_hash) return io::kDone;
  io::write_message(
      stderr,
      fmt::format("autoref: the row of build {0} has another final state, {1}; this is build {2}\n",
                  folder.build, io::hash_text(stored), io::build_id()));
  return io::kDifferent;
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

}  // namespace autoref::app
