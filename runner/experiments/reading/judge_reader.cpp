#include "runner/experiments/reading/judge_reader.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "runner/experiments/reading/factor_reader.hpp"
#include "runner/io/words.hpp"
#include "runner/settings/fields.hpp"

namespace autoref::runner {
namespace {

constexpr const char* kTuningSeed = "tuning";
constexpr const char* kTestSeed = "test";
constexpr std::size_t kCommitDigits = 8;

}  // namespace

void JudgeReader::read(const std::vector<YamlEntry>& top, JudgeSchedule& schedule) const {
  if (const YamlEntry* rules = find_entry(top, "rules")) {
    schedule.rules = values(*rules, "match.rules");
  }
  schedule.cameras = values(required_entry(file_, top, "cameras"), "sim.camera");
  refuse_both(top, "matchups", "teams");
  refuse_both(top, "seed", "seeds");
  if (const YamlEntry* matchups = find_entry(top, "matchups")) read_matchups(*matchups, schedule);
  if (const YamlEntry* teams = find_entry(top, "teams")) {
    schedule.teams = values(*teams, "a.strategy");
  }
  if (const YamlEntry* seeds = find_entry(top, "seeds")) read_seeds(*seeds, schedule);
}

void JudgeReader::refuse_both(const std::vector<YamlEntry>& top, const char* one,
                              const char* other) const {
  const YamlEntry* entry = find_entry(top, other);
  if (entry == nullptr || find_entry(top, one) == nullptr) return;
  file_.refuse(entry->location, other, fmt::format("the file also has '{}'; leave one out", one));
}

std::vector<std::string> JudgeReader::values(const YamlEntry& entry,
                                             const std::string& path) const {
  GameSettings any;
  return spelt(FactorReader(file_, locations_).values(entry, path, any));
}

void JudgeReader::read_matchups(const YamlEntry& entry, JudgeSchedule& schedule) const {
  if (!entry.value.IsSequence() || entry.value.size() == 0) {
    file_.refuse(value_location(entry), "matchups", "expected a list, such as [basic~dummy]");
  }
  for (const YAML::Node& value : entry.value) schedule.matchups.push_back(matchup_in(value));
}

void JudgeReader::read_seeds(const YamlEntry& entry, JudgeSchedule& schedule) const {
  const std::vector<std::string> names = {kTuningSeed, kTestSeed};
  const std::vector<YamlEntry> given = file_.entries(entry, "seeds", names);
  refuse_unknown(file_, given, names);
  schedule.seeds.clear();
  for (const std::string& name : names) {
    const YamlEntry* one = find_entry(given, name);
    if (one == nullptr) continue;
    schedule.seeds.push_back(seed_of(*one));
    if (schedule.seeds.front().name == name ||
        schedule.seeds.front().value != schedule.seeds.back().value)
      continue;
    file_.refuse(value_location(*one), "seeds." + name,
                 "equals the other seed; games to test the referee must not be those it was "
                 "tuned on");
  }
  if (schedule.seeds.empty()) {
    file_.refuse(value_location(entry), "seeds",
                 "expected seeds by name, such as { tuning: 1, test: 2 }");
  }
}

NamedSeed JudgeReader::seed_of(const YamlEntry& entry) const {
  const std::string path = "seeds." + entry.key;
  const std::string expected =
      "a whole number from 0 to 2^64 - 1, or the first eight hexadecimal digits of a commit";
  const std::string text = file_.scalar(entry, path, expected, false);
  std::optional<std::uint64_t> seed = seed_in(text);
  if (!seed && text.size() == kCommitDigits) seed = hexadecimal_in(text);
  if (!seed) {
    file_.refuse(value_location(entry), path,
                 fmt::format("expected {}, found '{}'", expected, text));
  }
  return {entry.key, text, *seed};
}

std::array<std::string, 2> JudgeReader::matchup_in(const YAML::Node& value) const {
  const std::string text = value.IsScalar() ? value.Scalar() : "";
  const std::size_t tilde = text.find('~');
  if (tilde == std::string::npos) {
    file_.refuse(location_of(value), "matchups", "expected two strategies, such as basic~dummy");
  }
  std::array<std::string, 2> matchup = {text.substr(0, tilde), text.substr(tilde + 1)};
  try {
    GameSettings any;
    set_by_path(any, "a.strategy", matchup[0]);
    set_by_path(any, "b.strategy", matchup[1]);
  } catch (const std::invalid_argument& error) {
    file_.refuse(location_of(value), "matchups", error.what());
  }
  return matchup;
}

}  // namespace autoref::runner
