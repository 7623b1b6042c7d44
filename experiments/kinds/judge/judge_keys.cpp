// The keys of scenario files of kind judge.
#include <fmt/format.h>

#include <stdexcept>

#include "experiments/kinds/judge/judge_schedule.hpp"
#include "experiments/reading/factor_reader.hpp"
#include "experiments/reading/top_reader.hpp"
#include "game/settings/fields.hpp"
#include "io/words.hpp"
#include "soccer/rules/rule_changes.hpp"

namespace autoref::experiments {
namespace {

constexpr const char* kSeedValue =
    "whole number from 0 to 2^64 - 1, or the first eight hexadecimal digits of a commit";
constexpr int kMostJudged = 9999;
constexpr const char* kTuningSeed = "tuning";
constexpr const char* kTestSeed = "test";
constexpr std::size_t kCommitDigits = 8;

// Refuses a file that has both keys.
void refuse_both(const TopReader& top, const char* one, const char* other) {
  const game::YamlEntry* entry = top.find(other);
  if (entry == nullptr || top.find(one) == nullptr) return;
  top.file().refuse(entry->location, other,
                    fmt::format("the file also has '{}'; leave one out", one));
}

std::vector<std::string> values_in(TopReader& top, const game::YamlEntry& entry,
                                   const std::string& path, game::GameSettings& base) {
  return game::spelt(FactorReader(top.file(), top.locations()).values(entry, path, base));
}

std::array<std::string, 2> matchup_in(const game::YamlFile& file, const YAML::Node& value) {
  const std::string text = value.IsScalar() ? value.Scalar() : "";
  const std::size_t tilde = text.find('~');
  if (tilde == std::string::npos) {
    file.refuse(game::location_of(value), "matchups",
                "expected two strategies, such as basic~dummy");
  }
  std::array<std::string, 2> matchup = {text.substr(0, tilde), text.substr(tilde + 1)};
  try {
    game::GameSettings any;
    game::set_by_path(any, "a.strategy", matchup[0]);
    game::set_by_path(any, "b.strategy", matchup[1]);
  } catch (const std::invalid_argument& error) {
    file.refuse(game::location_of(value), "matchups", error.what());
  }
  return matchup;
}

void read_matchups(const TopReader& top, JudgeSchedule& schedule) {
  refuse_both(top, "matchups", "teams");
  const game::YamlEntry* entry = top.find("matchups");
  if (entry == nullptr) return;
  if (!entry->value.IsSequence() || entry->value.size() == 0) {
    top.file().refuse(game::value_location(*entry), "matchups",
                      "expected a list, such as [basic~dummy]");
  }
  for (const YAML::Node& value : entry->value)
    schedule.matchups.push_back(matchup_in(top.file(), value));
}

NamedSeed seed_of(const game::YamlFile& file, const game::YamlEntry& entry) {
  const std::string path = "seeds." + entry.key;
  const std::string expected = fmt::format("a {}", kSeedValue);
  const std::string text = file.scalar(entry, path, expected, false);
  std::optional<std::uint64_t> seed = io::seed_in(text);
  if (!seed && text.size() == kCommitDigits) seed = io::hexadecimal_in(text);
  if (!seed)
    file.refuse(game::value_location(entry), path,
                fmt::format("expected {}, found '{}'", expected, text));
  return {entry.key, text, *seed};
}

std::vector<NamedSeed> seeds_in(const game::YamlFile& file, const game::YamlEntry& entry) {
  const std::vector<std::string> names = {kTuningSeed, kTestSeed};
  const std::vector<game::YamlEntry> given = file.entries(entry, "seeds", names);
  game::refuse_unknown(file, given, names);
  std::vector<NamedSeed> seeds;
  for (const std::string& name : names) {
    const game::YamlEntry* one = game::find_entry(given, name);
    if (one == nullptr) continue;
    seeds.push_back(seed_of(file, *one));
    if (seeds.size() == 1 || seeds.front().value != seeds.back().value) continue;
    file.refuse(game::value_location(*one), "seeds." + name,
                "equals the other seed; games to test the referee must not be those it was "
                "tuned on");
  }
  if (seeds.empty()) {
    file.refuse(game::value_location(entry), "seeds",
                "expected seeds by name, such as { tuning: 1, test: 2 }");
  }
  return seeds;
}

// A key with a list of values for a setting that the file varies.
// A list of presets. The first one is applied to `base`, as in FactorReader::read().
Key values_key(const char* name, std::string value, std::string about, const char* path,
               std::vector<std::string>& values, bool is_required, game::GameSettings& base) {
  Key key{name, std::move(value), std::move(about)};
  key.read = [name, path, &values, is_required, &base](TopReader& top) {
    const game::YamlEntry* entry = is_required ? &top.required(name) : top.find(name);
    if (entry != nullptr) values = values_in(top, *entry, path, base);
    top.refuse_assignment(path);
    game::set_by_path(base, path, values.front());
  };
  key.text = [name, &values] { return fmt::format("{}: [{}]\n", name, io::listed(values)); };
  return key;
}

Key matchups_key(JudgeSchedule& schedule) {
  const auto text = [&schedule] {
    std::vector<std::string> matchups;
    for (const auto& matchup : schedule.matchups) matchups.push_back(name_of(matchup));
    return io::listed(matchups);
  };
  Key key{"matchups", "list such as `rowdy~cobalt`", "pairs of teams, played in turn"};
  key.read = [&schedule](TopReader& top) { read_matchups(top, schedule); };
  key.text = [&schedule, text] {
    return schedule.matchups.empty() ? "" : fmt::format("matchups: [{}]\n", text());
  };
  key.values = [text] { return TextByPath{{"matchups", text()}}; };
  return key;
}

Key strategies_key(JudgeSchedule& schedule) {
  Key key{"teams", "list of strategies",
          "instead of `matchups`: teams, all pairs of which play about equally often"};
  key.read = [&schedule](TopReader& top) {
    if (const game::YamlEntry* entry = top.find("teams"))
      schedule.teams = values_in(top, *entry, "a.strategy", schedule.base);
  };
  key.text = [&schedule] {
    return schedule.teams.empty() ? "" : fmt::format("teams: [{}]\n", io::listed(schedule.teams));
  };
  key.values = [&schedule] { return TextByPath{{"teams", io::listed(schedule.teams)}}; };
  return key;
}

Key games_key(JudgeSchedule& schedule) {
  Key key{"games", "whole number", "number of games per rule book, camera and seed"};
  key.read = [&schedule](TopReader& top) {
    schedule.games_each = top.whole_number("games", 1, kMostJudged);
  };
  key.text = [&schedule] { return fmt::format("games: {}\n", schedule.games_each); };
  return key;
}

bool has_one_seed(const JudgeSchedule& schedule) { return schedule.seeds.front().name.empty(); }

// The key of a single seed, which has no name.
Key unnamed_seed_key(JudgeSchedule& schedule) {
  Key key{"seed", "whole number", "the experiment's random seed"};
  key.read = [&schedule](TopReader& top) {
    refuse_both(top, "seed", "seeds");
    if (top.find("seeds") != nullptr) return;
    const std::uint64_t seed = top.seed();
    schedule.seeds = {{"", std::to_string(seed), seed}};
  };
  key.text = [&schedule] {
    return has_one_seed(schedule) ? fmt::format("seed: {}\n", schedule.seeds.front().text) : "";
  };
  key.values = [&schedule] {
    TextByPath values;
    if (has_one_seed(schedule)) values["seed"] = std::to_string(schedule.seeds.front().value);
    return values;
  };
  key.entries = [&schedule] {
    return std::vector<std::string>(has_one_seed(schedule) ? 1 : 0);  // a single seed has no name
  };
  key.seed = [&schedule] {
    return has_one_seed(schedule) ? std::optional(schedule.seeds.front().value) : std::nullopt;
  };
  key.set_seed = [&schedule](std::uint64_t seed) {
    schedule.seeds = {{"", std::to_string(seed), seed}};
  };
  key.seed_text = [&schedule] { return text_of(schedule.seeds); };
  return key;
}

Key named_seeds_key(JudgeSchedule& schedule) {
  Key key{"seeds", "", "instead of `seed`"};
  key.below = []() -> KeysBelow {
    return {"seeds",
            "",
            {{fmt::format("`{}`", kTuningSeed), kSeedValue,
              "games that may be used to improve the referee"},
             {fmt::format("`{}`", kTestSeed), kSeedValue, "games that test the referee"}}};
  };
  key.read = [&schedule](TopReader& top) {
    if (const game::YamlEntry* entry = top.find("seeds"))
      schedule.seeds = seeds_in(top.file(), *entry);
  };
  key.text = [&schedule] {
    if (has_one_seed(schedule)) return std::string();
    std::string text = "seeds:\n";
    for (const NamedSeed& seed : schedule.seeds)
      text += fmt::format("  {}: {}\n", seed.name, seed.text);
    return text;
  };
  key.values = [&schedule] {
    TextByPath values;
    for (const NamedSeed& seed : schedule.seeds) {
      if (!seed.name.empty()) values["seeds." + seed.name] = std::to_string(seed.value);
    }
    return values;
  };
  key.entries = [&schedule] {
    std::vector<std::string> names;
    for (const NamedSeed& seed : schedule.seeds) {
      if (!seed.name.empty()) names.push_back(seed.name);
    }
    return names;
  };
  return key;
}

}  // namespace

std::vector<Key> JudgeSchedule::keys() {
  const auto varied_now = [this] { return varied_settings(); };
  return {base_key(base, varied_now),
          values_key("rules", "list of rule books", "the results have a table for each",
                     kRuleBookPath, rules, false, base),
          values_key("cameras", "list of camera presets", "every rule book is played with each",
                     kCameraPath, cameras, true, base),
          set_by_values_key(base, varied_now),
          matchups_key(*this),
          strategies_key(*this),
          games_key(*this),
          unnamed_seed_key(*this),
          named_seeds_key(*this)};
}

}  // namespace autoref::experiments
