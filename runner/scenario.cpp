#include "runner/scenario.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "runner/base_reader.hpp"
#include "runner/errors.hpp"
#include "runner/factor_reader.hpp"
#include "runner/files.hpp"
#include "runner/judge_reader.hpp"
#include "runner/plan.hpp"
#include "runner/roundrobin_plan.hpp"
#include "runner/roundrobin_reader.hpp"
#include "runner/settings_reader.hpp"
#include "runner/words.hpp"
#include "runner/yaml.hpp"

namespace autoref::runner {
namespace {

using Entries = std::vector<YamlEntry>;

constexpr int kMostPairs = 9999;
constexpr int kMostJudged = 9999;
const std::vector<std::string> kKinds = {"game", "sweep", "judge", "roundrobin"};
const std::vector<std::string> kVerbs = {"play", "run", "judge", "run"};

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
    } else if (kind == "roundrobin") {
      scenario.content = read_roundrobin();
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
    read_settings(top_, settings);
    check([&game] { check_game(game); });
    return game;
  }

  Sweep read_sweep() {
    refuse_unknown(file_, top_, {"schema", "kind", "about", "base", "factors", "pairs", "seed"});
    Sweep sweep;
    read_base(BaseReader(file_, places_), sweep.base);
    FactorReader(file_, places_).read(required_entry(file_, top_, "factors"), sweep);
    sweep.pairs = pairs();
    sweep.seed = seed();
    check([&sweep] { plan(sweep); });  // factors may only make a game together
    return sweep;
  }

  JudgePlan read_judge() {
    refuse_unknown(
        file_, top_,
        {"schema", "kind", "about", "base", "rules", "cameras", "matchups", "games", "seed"});
    JudgePlan plan;
    read_base(BaseReader(file_, places_), plan.base);
    JudgeReader(file_, places_).read(top_, plan);
    plan.games = number<int>(required_entry(file_, top_, "games"), "games",
                             fmt::format("a whole number from 1 to {}", kMostJudged),
                             whole_number_in, 1, kMostJudged);
    plan.seed = seed();
    check([&plan] { games_of(plan); });
    return plan;
  }

  RoundRobin read_roundrobin() {
    refuse_unknown(file_, top_, {"schema", "kind", "about", "teams", "base", "pairs", "seed"});
    RoundRobin robin;
    const Elsewhere teams{"teams", "a round robin's teams stand beside its base, by their names"};
    read_base(BaseReader(file_, places_, teams), robin.base);
    RoundRobinReader(file_, places_).read(required_entry(file_, top_, "teams"), robin);
    robin.pairs = pairs();
    robin.seed = seed();
    check([&robin] { plan(robin); });
    return robin;
  }

  int pairs() {
    const YamlEntry& entry = required_entry(file_, top_, "pairs");
    places_["pairs"] = entry.place;
    return number<int>(entry, "pairs", fmt::format("a whole number from 1 to {}", kMostPairs),
                       whole_number_in, 1, kMostPairs);
  }

  std::uint64_t seed() const {
    return number<std::uint64_t>(required_entry(file_, top_, "seed"), "seed",
                                 "a whole number from 0 to 2^64 - 1", seed_in, 0, UINT64_MAX);
  }

  void read_base(const BaseReader& reader, GameConfiguration& game) const {
    if (const YamlEntry* base = find_entry(top_, "base")) reader.read(*base, game);
    check([&game] { check_game(game); });
  }

  // `work` throws where settings that are right alone make no game together.
  template <typename Work>
  void check(const Work& work) const {
    try {
      work();
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
