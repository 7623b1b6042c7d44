#include "runner/scenario.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "runner/errors.hpp"
#include "runner/files.hpp"
#include "runner/plan.hpp"
#include "runner/robot_types.hpp"
#include "runner/settings_reader.hpp"
#include "runner/words.hpp"
#include "runner/yaml.hpp"

namespace autoref::runner {
namespace {

using Entries = std::vector<YamlEntry>;

constexpr int kMostPairs = 9999;
const std::vector<std::string> kKinds = {"game", "sweep"};

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
    } else {
      scenario.content = read_sweep();
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
    // Teams name types, wherever these stand beside them.
    if (const YamlEntry* types = find_entry(top_, "types")) settings.read(*types, "types");
    for (const YamlEntry& entry : top_) {
      if (std::find(names.begin(), names.end(), entry.key) == names.end()) continue;
      if (entry.key != "types") settings.read(entry, entry.key);
    }
    check(game);
    return game;
  }

  Sweep read_sweep() {
    refuse_unknown(file_, top_, {"schema", "kind", "about", "base", "factors", "pairs", "seed"});
    Sweep sweep;
    if (const YamlEntry* base = find_entry(top_, "base")) read_base(*base, sweep.base);
    check(sweep.base);
    read_factors(required_entry(file_, top_, "factors"), sweep);
    sweep.pairs = number<int>(required_entry(file_, top_, "pairs"), "pairs",
                              fmt::format("a whole number from 1 to {}", kMostPairs),
                              whole_number_in, 1, kMostPairs);
    sweep.seed = number<std::uint64_t>(required_entry(file_, top_, "seed"), "seed",
                                       "a whole number from 0 to 2^64 - 1", seed_in, 0, UINT64_MAX);
    check_together(sweep);
    return sweep;
  }

  void read_base(const YamlEntry& base, GameConfiguration& game) {
    SettingsReader settings(file_, game, places_);
    settings.hide("seed");
    const std::vector<std::string> known = settings.names();
    const Entries entries = file_.entries(base, "base", known);
    if (const YamlEntry* types = find_entry(entries, "types")) settings.read(*types, "types");
    for (const YamlEntry& entry : entries) {
      if (std::find(known.begin(), known.end(), entry.key) == known.end()) {
        file_.refuse(entry.place, "base", unknown_key_message(entry.key, known));
      }
      refuse_what_legs_decide(entry);
      if (entry.key != "types") settings.read(entry, entry.key);
    }
  }

  void refuse_what_legs_decide(const YamlEntry& entry) const {
    if (entry.key != "match" || !entry.value.IsMap()) return;
    for (const YamlEntry& key : file_.entries(entry, "match", {})) {
      if (is_decided_by_plan("match." + key.key)) refuse_decided(key.place, "match." + key.key);
    }
  }

  static bool is_decided_by_plan(std::string_view path) {
    return path == "match.a_plays" || path == "match.first_kickoff" || path == "seed";
  }

  [[noreturn]] void refuse_decided(const YamlPlace& place, std::string_view path) const {
    file_.refuse(place, path, "a sweep gives every game its own; leave it out here");
  }

  void read_factors(const YamlEntry& factors, Sweep& sweep) {
    const Entries entries = file_.entries(factors, "factors", {});
    if (entries.empty()) file_.refuse(factors.place, "factors", "expected at least one factor");
    for (const YamlEntry& entry : entries) {
      if (is_decided_by_plan(entry.key)) refuse_decided(entry.place, entry.key);
      sweep.factors.push_back(read_factor(entry, sweep.base));
      refuse_overlap(entry, sweep.factors);
    }
  }

  Factor read_factor(const YamlEntry& entry, GameConfiguration& base) {
    Factor factor{short_path(entry.key), {}};
    places_[full_path(entry.key)] = entry.place;
    if (!entry.value.IsSequence() || entry.value.size() == 0) {
      file_.refuse(value_place(entry), entry.key, "expected a list of values, such as [1.0, 0.9]");
    }
    for (const YAML::Node& value : entry.value) {
      const YamlPlace place = place_of(value);
      if (!value.IsScalar()) file_.refuse(place, entry.key, "expected a list of plain values");
      const std::string text = read_factor_value(entry, place, value.Scalar(), base);
      if (std::find(factor.values.begin(), factor.values.end(), text) != factor.values.end()) {
        file_.refuse(place, entry.key, fmt::format("the value {} is given twice", text));
      }
      factor.values.push_back(text);
    }
    return factor;
  }

  std::string read_factor_value(const YamlEntry& entry, const YamlPlace& place,
                                const std::string& text, GameConfiguration& base) const {
    GameConfiguration game = base;
    try {
      set_by_path(game, entry.key, text, file_.folder());
    } catch (const std::invalid_argument& error) {
      file_.refuse(place, entry.key, error.what());
    }
    base.types.insert(game.types.begin(), game.types.end());
    return value_at(game, entry.key);
  }

  // Two factors that set the same number would make the later one win unnoticed.
  void refuse_overlap(const YamlEntry& entry, const std::vector<Factor>& factors) const {
    const auto branch_of = [](const std::string& path) { return path.substr(0, path.rfind('.')); };
    const auto is_parts = [&](const std::string& part, const std::string& whole) {
      if (whole == "sim.camera") {
        return part.starts_with("sim.vision.") || part == "sim.radio.command_loss" ||
               part == "sim.latency_s";
      }
      if (branch_of(part) != branch_of(whole)) return false;
      return whole.ends_with(".preset") ||
             (whole.ends_with(".handicap") && part.ends_with("_factor"));
    };
    const std::string& last = factors.back().path;
    for (std::size_t i = 0; i + 1 < factors.size(); ++i) {
      const std::string& other = factors[i].path;
      if (other == last || is_parts(other, last) || is_parts(last, other)) {
        file_.refuse(entry.place, entry.key, fmt::format("'{}' sets the same number", other));
      }
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

Scenario read_scenario_text(const std::string& text, const std::string& file_name) {
  const YamlFile file(text, file_name);
  return ScenarioReader(file).read();
}

Scenario read_scenario(const std::filesystem::path& file) {
  return read_scenario_text(read_user_file(file), file.string());
}

}  // namespace autoref::runner
