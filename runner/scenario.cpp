#include "runner/scenario.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "runner/errors.hpp"
#include "runner/factor_reader.hpp"
#include "runner/files.hpp"
#include "runner/judge_reader.hpp"
#include "runner/plan.hpp"
#include "runner/settings_reader.hpp"
#include "runner/words.hpp"
#include "runner/yaml.hpp"

namespace autoref::runner {
namespace {

using Entries = std::vector<YamlEntry>;

constexpr int kMostPairs = 9999;
constexpr int kMostJudged = 9999;
const std::vector<std::string> kKinds = {"game", "sweep", "judge"};
const std::vector<std::string> kVerbs = {"play", "run", "judge"};

// Reads one document, top level first.
class ScenarioReader {
 public:
  explicit ScenarioReader(const YamlFile& file) : file_(file), top_(file.top()) {}

  Scenario read() {
    read_schema();
    const YamlEntry& kind_entry = required_entry(file_, top_, "kind");
    refuse_other_files(kind_entry);
    const std::string kind = word(kind_entry, "kind", kKinds);
    Scenario scenario;
    if (const YamlEntry* about = find_entry(top_, "about")) {
      scenario.about = file_.scalar(*about, "about", "a sentence", false);
    }
    if (kind == "game") {
      scenario.content = read_game();
    } else if (kind == "sweep") {
      scenario.content = read_sweep();
    } else {
      scenario.content = read_judge();
    }
    return scenario;
  }

 private:
  void refuse_other_files(const YamlEntry& kind) const {
    const std::string text = kind.value.IsScalar() ? kind.value.Scalar() : "";
    if (text == "lab") {
      file_.refuse(value_place(kind), "kind", "this is a scene; play it with: autoref lab FILE");
    }
    if (text == "robot") {
      file_.refuse(value_place(kind), "kind",
                   "this is a type of robots; name it in a scenario as a team's type");
    }
  }

  std::string word(const YamlEntry& entry, std::string_view key,
                   const std::vector<std::string>& known) const {
    std::string word = file_.scalar(entry, key, "one of " + listed(known), false);
    if (std::find(known.begin(), known.end(), word) == known.end()) {
      file_.refuse(value_place(entry), key,
                   fmt::format("expected one of {}, found '{}'", listed(known), word));
    }
    return word;
  }

  template <typename Number>
  Number number(const YamlEntry& entry, std::string_view key, const std::string& expected,
                std::optional<Number> (*parse)(std::string_view), Number low, Number high) const {
    const std::string text = file_.scalar(entry, key, expected, true);
    const std::optional<Number> number = parse(text);
    if (!number || *number < low || *number > high) {
      file_.refuse(value_place(entry), key, fmt::format("expected {}, found '{}'", expected, text));
    }
    return *number;
  }

  void read_schema() const {
    number<int>(required_entry(file_, top_, "schema"), "schema", "1, the only schema so far",
                whole_number_in, 1, 1);
  }

  GameConfiguration read_game() {
    GameConfiguration game;
    SettingsReader settings(file_, game, places_);
    std::vector<std::string> known = {"schema", "kind", "about"};
    const std::vector<std::string> names = settings.names();
    known.insert(known.end(), names.begin(), names.end());
    refuse_unknown(file_, top_, known);
    read_first(top_, settings);
    for (const YamlEntry& entry : top_) {
      if (std::find(names.begin(), names.end(), entry.key) == names.end()) continue;
      if (!is_read_first(entry.key)) settings.read(entry, entry.key);
    }
    check(game);
    return game;
  }

  Sweep read_sweep() {
    refuse_unknown(file_, top_, {"schema", "kind", "about", "base", "factors", "pairs", "seed"});
    Sweep sweep;
    if (const YamlEntry* base = find_entry(top_, "base")) read_base(*base, sweep.base);
    check(sweep.base);
    FactorReader(file_, places_).read(required_entry(file_, top_, "factors"), sweep);
    sweep.pairs = number<int>(required_entry(file_, top_, "pairs"), "pairs",
                              fmt::format("a whole number from 1 to {}", kMostPairs),
                              whole_number_in, 1, kMostPairs);
    sweep.seed = seed();
    check_together(sweep);
    return sweep;
  }

  JudgePlan read_judge() {
    refuse_unknown(
        file_, top_,
        {"schema", "kind", "about", "base", "rules", "cameras", "matchups", "games", "seed"});
    JudgePlan plan;
    if (const YamlEntry* base = find_entry(top_, "base")) read_base(*base, plan.base);
    check(plan.base);
    JudgeReader(file_, places_).read(top_, plan);
    plan.games = number<int>(required_entry(file_, top_, "games"), "games",
                             fmt::format("a whole number from 1 to {}", kMostJudged),
                             whole_number_in, 1, kMostJudged);
    plan.seed = seed();
    check_together(plan);
    return plan;
  }

  std::uint64_t seed() const {
    return number<std::uint64_t>(required_entry(file_, top_, "seed"), "seed",
                                 "a whole number from 0 to 2^64 - 1", seed_in, 0, UINT64_MAX);
  }

  // Teams name types, and rules set other branches, wherever these stand beside them.
  static bool is_read_first(std::string_view key) { return key == "types" || key == "match"; }

  void read_first(const Entries& entries, SettingsReader& settings) const {
    for (const char* key : {"types", "match"}) {
      if (const YamlEntry* entry = find_entry(entries, key)) settings.read(*entry, key);
    }
  }

  void read_base(const YamlEntry& base, GameConfiguration& game) {
    SettingsReader settings(file_, game, places_);
    settings.hide("seed");
    const std::vector<std::string> known = settings.names();
    const Entries entries = file_.entries(base, "base", known);
    for (const YamlEntry& entry : entries) refuse_what_legs_decide(entry);
    read_first(entries, settings);
    for (const YamlEntry& entry : entries) {
      if (std::find(known.begin(), known.end(), entry.key) == known.end()) {
        file_.refuse(entry.place, "base", unknown_key_message(entry.key, known));
      }
      if (!is_read_first(entry.key)) settings.read(entry, entry.key);
    }
  }

  void refuse_what_legs_decide(const YamlEntry& entry) const {
    if (entry.key != "match" || !entry.value.IsMap()) return;
    for (const YamlEntry& key : file_.entries(entry, "match", {})) {
      const std::string path = "match." + key.key;
      if (is_decided_by_plan(path)) refuse_decided(file_, key.place, path);
    }
  }

  void check(const GameConfiguration& game) const {
    try {
      check_game(game);
    } catch (const std::invalid_argument& error) {
      file_.refuse(place_of_first_path_in(error.what()), "", error.what());
    }
  }

  // One factor's value may only make a game together with another's.
  void check_together(const Sweep& sweep) const {
    try {
      plan(sweep);
    } catch (const std::invalid_argument& error) {
      file_.refuse(place_of_first_path_in(error.what()), "", error.what());
    }
  }

  void check_together(const JudgePlan& plan) const {
    try {
      games_of(plan);
    } catch (const std::invalid_argument& error) {
      file_.refuse(place_of_first_path_in(error.what()), "", error.what());
    }
  }

  // Messages about several settings begin with the path of the one to mend, or of its branch.
  YamlPlace place_of_first_path_in(std::string_view message) const {
    const std::string path(message.substr(0, message.find_first_of(": ")));
    const auto found = places_.lower_bound(path);
    const bool is_path =
        found != places_.end() && (found->first == path || found->first.starts_with(path + "."));
    return is_path ? found->second : YamlPlace{};
  }

  const YamlFile& file_;
  const Entries top_;
  Places places_;
};

}  // namespace

std::string_view kind_of(const Scenario& scenario) { return kKinds[scenario.content.index()]; }
std::string_view verb_of(const Scenario& scenario) { return kVerbs[scenario.content.index()]; }

Scenario read_scenario_text(const std::string& text, const std::string& file_name) {
  const YamlFile file(text, file_name);
  return ScenarioReader(file).read();
}

Scenario read_scenario(const std::filesystem::path& file) {
  return read_scenario_text(read_user_file(file), file.string());
}

}  // namespace autoref::runner
