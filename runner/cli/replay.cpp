#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "runner/batch/program_files.hpp"
#include "runner/batch/result_folder.hpp"
#include "runner/cli/command_line.hpp"
#include "runner/cli/judged_results.hpp"
#include "runner/cli/play_one.hpp"
#include "runner/io/build_id.hpp"
#include "runner/io/checksum.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/words.hpp"
#include "runner/judge/judged_rows.hpp"
#include "runner/settings/resolved.hpp"

namespace autoref::runner {
namespace {

namespace fs = std::filesystem;

// Returns the id of a game. In judged experiments, `id` may also be the id of a fault, which is
// then printed.
std::string id_of_game(const ResultFolder& folder, const std::string& id) {
  if (!is_judged(folder.scenario)) return id;
  const std::optional<LookedUp> found = look_up(folder, id);
  if (!found) return id;
  if (!found->fault.empty())
    write_message(stderr, fmt::format("autoref: {}: {}\n", id, found->fault));
  return found->game_id;
}

const ScheduledGame& game_named(const ResultFolder& folder, const std::string& id) {
  const auto game = std::find_if(folder.games.begin(), folder.games.end(),
                                 [&id](const ScheduledGame& one) { return one.id == id; });
  if (game != folder.games.end()) return *game;
  std::vector<std::string> ids;
  for (const ScheduledGame& one : folder.games) ids.push_back(one.id);
  const std::string where = is_judged(folder.scenario)
                                ? "The last column of faults.csv lists the ids of faults"
                                : "The first column of results.csv lists all games played";
  throw InputError({folder.path.string()}, "",
                   fmt::format("contains no game '{}'; did you mean '{}'? {}", id,
                               nearest_word(id, ids), where));
}

}  // namespace

int replay_verb(const ReplayArguments& arguments) {
  const ResultFolder folder = open_results(arguments.folder, arguments.build);
  const ScheduledGame& game = game_named(folder, id_of_game(folder, arguments.game));
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
