#include "experiments/kinds/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>

#include "experiments/reading/top_reader.hpp"

namespace autoref::experiments {
namespace {

// The entry of a key that a path leads to: "zone" for "teams.zone.robots", "" for the key itself.
std::string_view entry_in(std::string_view path, const Key& key) {
  if (path.size() == key.name.size()) return {};
  path.remove_prefix(key.name.size() + 1);
  return path.substr(0, path.find('.'));
}

// Keeps only values of entries that also exist in the same key of the other experiment.
void keep_common_entries(const Key& key, const Key& other, TextByPath& values) {
  const std::vector<std::string> names = other.entries();
  const std::set<std::string_view> others(names.begin(), names.end());
  std::erase_if(values,
                [&](const auto& value) { return !others.contains(entry_in(value.first, key)); });
}

// The values of an experiment's keys that should be the same in another experiment.
TextByPath shared_values(const std::vector<Key>& keys, const std::vector<Key>& others) {
  assert(keys.size() == others.size());
  TextByPath all;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (!keys[i].values) continue;
    TextByPath values = keys[i].values();
    if (keys[i].entries) keep_common_entries(keys[i], others[i], values);
    all.merge(values);
  }
  return all;
}

std::string differences(const TextByPath& here, const TextByPath& there) {
  std::string text;
  const auto note = [&text](const std::string& path, const std::string& x, const std::string& y) {
    if (x == y) return;
    text += fmt::format("{}{} is {} here and {} there", text.empty() ? "" : "; ", path, x, y);
  };
  const std::string missing = "not given";
  for (const auto& [path, value] : here)
    note(path, value, there.contains(path) ? there.at(path) : missing);
  for (const auto& [path, value] : there) {
    if (!here.contains(path)) note(path, missing, value);
  }
  return text;
}

// Calls `work` with the keys of a copy of the experiment, since keys can change their experiment.
template <typename Work>
auto with_keys(const Experiment& experiment, const Work& work) {
  const std::unique_ptr<Experiment> copy = experiment.copy();
  return work(copy->keys());
}

}  // namespace

Schedule Experiment::schedule(const RowsById& /*rows*/) const {
  std::vector<ScheduledGame> all = games();
  const std::size_t needed = all.size();
  return {std::move(all), needed};
}

bool Experiment::is_decided(const RowsById& /*rows*/) const { return false; }

void read_keys(TopReader& top, Experiment& experiment) {
  const std::vector<Key> keys = experiment.keys();
  std::vector<std::string> names;
  std::vector<std::string> branches;
  for (const Key& key : keys) {
    names.push_back(key.name);
    if (key.teams && key.base == nullptr) branches.push_back(key.name);
  }
  top.allow(names, std::move(branches));
  for (const Key& key : keys) {
    if (key.read) key.read(top);
  }
  top.check([&experiment] { experiment.games(); });
  for (const Key& key : keys) {
    if (key.verify) key.verify(top);
  }
}

RowsById needed_rows(const Schedule& schedule, RowsById rows) {
  std::set<std::string_view> needed;
  for (std::size_t i = 0; i < std::min(schedule.needed, schedule.games.size()); ++i)
    needed.insert(schedule.games[i].id);
  std::erase_if(rows, [&needed](const auto& entry) { return !needed.contains(entry.first); });
  return rows;
}

RowFormat row_format(const Experiment& experiment) {
  return RowFormat(experiment.value_columns(), experiment.row_kind());
}

std::string changes_between(const Experiment& here, const Experiment& there) {
  if (&here.kind() != &there.kind()) return {};
  const std::unique_ptr<Experiment> one = here.copy();
  const std::unique_ptr<Experiment> other = there.copy();
  const std::vector<Key> its_keys = one->keys();
  const std::vector<Key> other_keys = other->keys();
  return differences(shared_values(its_keys, other_keys), shared_values(other_keys, its_keys));
}

std::optional<int> pairs_of(const Experiment& experiment) {
  return with_keys(experiment, [](const std::vector<Key>& keys) -> std::optional<int> {
    for (const Key& key : keys) {
      if (key.pairs != nullptr) return *key.pairs;
    }
    return std::nullopt;
  });
}

std::optional<std::uint64_t> master_seed_of(const Experiment& experiment) {
  return with_keys(experiment, [](const std::vector<Key>& keys) -> std::optional<std::uint64_t> {
    for (const Key& key : keys) {
      if (key.seed) return key.seed();
    }
    return std::nullopt;
  });
}

std::string seed_text(const Experiment& experiment) {
  return with_keys(experiment, [](const std::vector<Key>& keys) {
    for (const Key& key : keys) {
      if (key.seed_text) return key.seed_text();
    }
    return std::string();
  });
}

void set_pairs(Experiment& experiment, int pairs) {
  if (pairs < 1 || pairs > kMostPairs) {
    throw std::invalid_argument(
        fmt::format("expected a whole number from 1 to {}, found {}", kMostPairs, pairs));
  }
  for (const Key& key : experiment.keys()) {
    if (key.pairs == nullptr) continue;
    const int former = std::exchange(*key.pairs, pairs);
    try {
      experiment.games();  // throws if the number contradicts other settings
    } catch (...) {
      *key.pairs = former;
      throw;
    }
    return;
  }
  throw std::invalid_argument(
      fmt::format("a {} has no pairs: {}", experiment.kind().name, experiment.why_no_pairs()));
}

std::optional<TeamVersions> versions_of(const Experiment& experiment) {
  const std::unique_ptr<Experiment> copy = experiment.copy();
  const std::optional<VersionedTeams> teams = copy->versioned_teams();
  return teams && teams->versions->are_followed() ? std::optional(*teams->versions) : std::nullopt;
}

void set_master_seed(Experiment& experiment, std::uint64_t seed) {
  for (const Key& key : experiment.keys()) {
    if (key.set_seed) key.set_seed(seed);
  }
}

}  // namespace autoref::experiments
