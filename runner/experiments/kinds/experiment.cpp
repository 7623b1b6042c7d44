#include "runner/experiments/kinds/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace autoref::runner {
namespace {

// Whether an entry of `key`, which has games of its own, is one of `others`.
bool is_in_both(const Key& key, const Key& other, const std::string& path) {
  const auto is_of = [&](const std::string& name) {
    const std::string entry = name.empty() ? key.name : fmt::format("{}.{}", key.name, name);
    return path == entry || path.starts_with(entry + ".");
  };
  const std::vector<std::string> names = other.entries();
  return std::any_of(names.begin(), names.end(), is_of);
}

// The values of one experiment's keys that another one should share.
TextByPath comparable_values(const std::vector<Key>& keys, const std::vector<Key>& others) {
  TextByPath all;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (!keys[i].values) continue;
    TextByPath values = keys[i].values();
    if (keys[i].entries) {
      std::erase_if(values, [&key = keys[i], &other = others[i]](const auto& value) {
        return !is_in_both(key, other, value.first);
      });
    }
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

// Calls `work` for a copy's keys.
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

RowsById counted(const Schedule& schedule, RowsById rows) {
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
  return differences(comparable_values(its_keys, other_keys),
                     comparable_values(other_keys, its_keys));
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
    *key.pairs = pairs;
    experiment.games();  // throws if the number contradicts other settings
    return;
  }
  throw std::invalid_argument(
      fmt::format("a {} has no pairs: {}", experiment.kind().name, experiment.why_no_pairs()));
}

void set_master_seed(Experiment& experiment, std::uint64_t seed) {
  for (const Key& key : experiment.keys()) {
    if (key.set_seed) key.set_seed(seed);
  }
}

}  // namespace autoref::runner
