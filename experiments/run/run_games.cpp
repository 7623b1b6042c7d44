#include "experiments/run/run_games.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <utility>

#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/results/game_row.hpp"
#include "experiments/results/shard.hpp"
#include "experiments/run/result_folder.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;

std::string changes_besides_seed(Scenario here, const Scenario& there, std::uint64_t seed) {
  set_master_seed(here.experiment(), seed);
  return changes_between(here.experiment(), there.experiment());
}

}  // namespace

std::optional<Scenario> scenario_of_folder(const fs::path& folder) {
  const fs::path file = folder / kEffectiveFile;
  try {
    const std::optional<std::string> text = io::read_file(file);
    if (!text) return std::nullopt;
    Scenario scenario = read_scenario_text(*text, file.string());
    return scenario.is_game() ? std::nullopt : std::optional(scenario);
  } catch (const io::InputError&) {
    return std::nullopt;
  }
}

void refuse_other_seed(const Scenario& here, const Scenario& there, const fs::path& folder) {
  const std::optional<std::uint64_t> seed = master_seed_of(here.experiment());
  const std::optional<std::uint64_t> former = master_seed_of(there.experiment());
  if (!seed || !former || seed == former || kind_of(here) != kind_of(there)) return;
  const std::string others = changes_besides_seed(here, there, *former);
  throw io::InputError(
      {folder.string()}, "",
      fmt::format("holds games of seed {0}, but this is seed {1}{2}; continue with --seed {0} (or "
                  "seed: {0} in the file), or choose another folder for seed {1}, such as -o "
                  "{3}-seed-{1}",
                  *former, *seed, others.empty() ? "" : fmt::format(" (also, {})", others),
                  (folder / "").parent_path().string()));
}

std::string note_on_pairs(const Scenario& here, const Scenario& there, int beyond) {
  const std::optional<int> pairs = pairs_of(here.experiment());
  const std::optional<int> former = pairs_of(there.experiment());
  if (!pairs || !former || *pairs == *former) return {};
  if (*pairs > *former && beyond > 0) {
    return fmt::format(
        "the folder had {} pairs, now {}; the games already played count if they still belong to "
        "the experiment",
        *former, *pairs);
  }
  if (*pairs > *former) {
    return fmt::format(
        "the folder had {} pairs, now {}; the games already played count, and only the others are "
        "played",
        *former, *pairs);
  }
  return fmt::format(
      "the folder had {} pairs, now {}: {} surplus rows do not count; they stay in {}/ and count "
      "again with --pairs {}",
      *former, *pairs, beyond, kGamesFolder, *former);
}

RunGames::RunGames(const Scenario& scenario, const ExperimentOptions& options,
                   const RowFormat& format)
    : scenario_(scenario),
      options_(options),
      format_(format),
      former_(scenario_of_folder(options.folder)),
      changes_(former_ ? changes_between(scenario.experiment(), former_->experiment())
                       : std::string()) {}

RowInventory RunGames::inventory_of(RowsInFiles rows) const {
  return take_row_inventory(scenario_, std::move(rows), format_, options_.build,
                            options_.allow_mixed_build, options_.folder, changes_);
}

std::vector<std::string> RunGames::open() {
  StoredRows stored = read_rows(options_.folder / kGamesFolder, format_);
  const bool has_rows = !stored.rows.empty();
  if (former_ && has_rows) refuse_other_seed(scenario_, *former_, options_.folder);
  RowInventory row_inventory = inventory_of(std::move(stored.rows));
  schedule_ = std::move(row_inventory.schedule);
  rows_ = std::move(row_inventory.completed_games.done);
  std::vector<std::string> notes;
  if (!stored.damaged.empty() && !missing().empty()) {
    notes.push_back(fmt::format(
        "damaged rows that do not count: {}, the first at {}; their games will be replayed",
        stored.damaged.size(), stored.damaged.front().at));
  }
  const std::string others =
      note_on_other_games(row_inventory.completed_games.other_games, has_rows);
  if (!others.empty()) notes.push_back(others);
  for (const auto& [build, count] : row_inventory.completed_games.other_builds)
    notes.push_back(fmt::format("{} rows are from build {}; they do not count", count, build));
  set_killed_games_aside(notes);
  is_decided_ = scenario_.experiment().is_decided(rows_);
  return notes;
}

std::string RunGames::note_on_other_games(int count, bool has_rows) const {
  std::string pairs =
      former_ && has_rows ? note_on_pairs(scenario_, *former_, count) : std::string();
  if (!pairs.empty() || count == 0) return pairs;
  return fmt::format("{} rows belong to games that are not in the scenario; they do not count",
                     count);
}

void RunGames::set_killed_games_aside(std::vector<std::string>& notes) {
  for (const ScheduledGame& game : schedule_.games) {
    const auto row = rows_.find(game.id);
    if (row == rows_.end() || !has(game)) continue;
    if (is_killed(row->second)) to_replay_.insert(game.id);
  }
  for (const std::string& id : to_replay_) rows_.erase(id);
  if (to_replay_.empty()) return;
  notes.push_back(
      fmt::format("{} games are void because their workers were killed; they will be replayed",
                  to_replay_.size()));
  schedule_ = scenario_.experiment().schedule(rows_);
}

void RunGames::reread() {
  rows_ =
      inventory_of(read_rows(options_.folder / kGamesFolder, format_).rows).completed_games.done;
  for (const std::string& id : to_replay_) rows_.erase(id);
}

void RunGames::add(GameRow row) {
  to_replay_.erase(row.game_id);
  const std::string id = row.game_id;
  rows_[id] = std::move(row);
}

void RunGames::update_schedule() {
  if (scenario_.experiment().follows_its_rows()) schedule_ = scenario_.experiment().schedule(rows_);
}

void RunGames::update_decision() { is_decided_ = scenario_.experiment().is_decided(rows_); }

std::vector<std::size_t> RunGames::missing() const {
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < std::min(schedule_.needed, schedule_.games.size()); ++i) {
    const ScheduledGame& game = schedule_.games[i];
    if (has(game) && !rows_.contains(game.id)) missing.push_back(i);
  }
  return missing;
}

io::GameCounts RunGames::counts() const {
  const std::size_t known = std::min(schedule_.needed, schedule_.games.size());
  io::GameCounts counts{.total = static_cast<int>(schedule_.needed - known), .voids = 0};
  for (std::size_t i = 0; i < known; ++i) {
    const ScheduledGame& game = schedule_.games[i];
    if (!has(game)) continue;
    const auto row = rows_.find(game.id);
    ++counts.total;
    counts.done += row == rows_.end() ? 0 : 1;
    *counts.voids += row != rows_.end() && is_void(row->second.record) ? 1 : 0;
  }
  return counts;
}

bool RunGames::depends_on_others() const {
  if (options_.shard.of == 1 || schedule_.needed <= schedule_.games.size()) return false;
  return std::any_of(schedule_.games.begin(), schedule_.games.end(),
                     [this](const ScheduledGame& game) { return !rows_.contains(game.id); });
}

}  // namespace autoref::experiments
