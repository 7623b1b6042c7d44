#include "app/results/replay_verb.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/game/play_one.hpp"
#include "app/results/folder_arguments.hpp"
#include "app/results/judged_results.hpp"
#include "app/verbs.hpp"
#include "experiments/run/program_versions.hpp"
#include "experiments/run/result_folder.hpp"
#include "game/settings/game_settings.hpp"
#include "io/build_id.hpp"
#include "io/checksum.hpp"
#include "io/errors.hpp"
#include "io/words.hpp"
#include "judge/judged_rows.hpp"

namespace autoref::app {
namespace {

struct ReplayArguments : FolderArguments {
  std::string game;
  GameOutput output;
};

const experiments::ScheduledGame* find_game(const experiments::ResultFolder& folder,
                                            const std::string& id) {
  const auto game =
      std::find_if(folder.games.begin(), folder.games.end(),
                   [&id](const experiments::ScheduledGame& one) { return one.id == id; });
  return game == folder.games.end() ? nullptr : &*game;
}

// The game with exactly this id, or with a fault of exactly this id; null if there is none.
const experiments::ScheduledGame* find_game_or_fault(const experiments::ResultFolder& folder,
                                                     const std::string& id) {
  if (!is_judged(folder.scenario)) return find_game(folder, id);
  const std::optional<judge::FoundGame> found = judge::find_game(folder, id);
  if (!found) return find_game(folder, id);
  if (!found->fault.empty())
    io::write_message(stderr, fmt::format("autoref: {}: {}\n", id, found->fault));
  return find_game(folder, found->game_id);
}

std::vector<std::string> similar_ids(const experiments::ResultFolder& folder, const std::string& id,
                                     const std::string& turned) {
  std::vector<std::string> ids;
  for (const experiments::ScheduledGame& one : folder.games) ids.push_back(one.id);
  const auto begins = [&ids](const std::string& front) {
    return !front.empty() && std::any_of(ids.begin(), ids.end(), [&front](const std::string& one) {
      return one.starts_with(front);
    });
  };
  if (!begins(id) && begins(turned)) return io::suggested_words(turned, ids);
  std::vector<std::string> similar = io::suggested_words(id, ids);
  if (similar.empty() && !ids.empty()) similar.push_back(io::nearest_word(id, ids));
  return similar;
}

[[noreturn]] void refuse_game(const experiments::ResultFolder& folder, const std::string& id,
                              const std::string& turned) {
  const std::string where = is_judged(folder.scenario)
                                ? "The last column of faults.csv lists the ids of faults"
                                : "The first column of results.csv lists all games played";
  const std::string hint = io::suggestion_text(similar_ids(folder, id, turned));
  throw io::InputError(
      {folder.path.string()}, "",
      fmt::format("contains no game '{}'{} {}", id, hint.empty() ? "." : hint, where));
}

namespace fs = std::filesystem;

}  // namespace

std::string turned_id(const std::string& id) {
  const std::size_t tilde = id.find('~');
  if (tilde == std::string::npos) return {};
  const std::size_t before = id.find_last_of("+ ", tilde);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  const std::size_t pair = id.rfind("-p");
  const std::size_t end =
      std::min({id.find(' ', tilde), pair > tilde ? pair : std::string::npos, id.size()});
  return id.substr(0, begin) + id.substr(tilde + 1, end - tilde - 1) + "~" +
         id.substr(begin, tilde - begin) + id.substr(end);
}

const experiments::ScheduledGame& game_named(const experiments::ResultFolder& folder,
                                             const std::string& id) {
  if (const experiments::ScheduledGame* game = find_game_or_fault(folder, id)) return *game;
  const bool has_sides = folder.scenario.experiment().row_kind() == experiments::RowKind::kScene;
  const std::string turned = has_sides ? "" : turned_id(id);
  const experiments::ScheduledGame* game =
      turned.empty() ? nullptr : find_game_or_fault(folder, turned);
  if (game == nullptr) refuse_game(folder, id, turned);
  io::write_message(
      stderr, fmt::format("autoref: this folder lists the teams of '{}' in the other order: {}\n",
                          id, game->id));
  return *game;
}

namespace {

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
      fmt::format(
          "autoref: the row of build {0} has a different final state, {1}; this is build {2}\n",
          folder.build, io::hash_text(stored), io::build_id()));
  return io::kDifferent;
}

}  // namespace

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
      "Example:\n  autoref results replay results/runs/handicap-speed b.handicap=0.8-p0007-2 "
      "--events "
      "events.jsonl");
  choose(*verb, chosen, arguments, replay_verb);
}

}  // namespace autoref::app
