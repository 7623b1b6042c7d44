#include "experiments/run/folder_changes.hpp"

#include <fmt/format.h>

#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/results/shard.hpp"
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
        "the folder had {} pairs, now {}; those of its games that still belong to the experiment "
        "count",
        *former, *pairs);
  }
  if (*pairs > *former) {
    return fmt::format(
        "the folder had {} pairs, now {}; its games count, and only the new ones are played",
        *former, *pairs);
  }
  return fmt::format(
      "the folder had {} pairs, now {}: {} surplus rows do not count; they stay in {}/ and count "
      "again with --pairs {}",
      *former, *pairs, beyond, kGamesFolder, *former);
}

}  // namespace autoref::experiments
