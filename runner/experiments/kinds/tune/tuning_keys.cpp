// The keys of a tuning's scenario file.
#include <fmt/format.h>

#include <algorithm>

#include "runner/experiments/kinds/tune/tuning.hpp"
#include "runner/experiments/reading/named_teams_reader.hpp"
#include "runner/experiments/reading/settings_text.hpp"
#include "runner/experiments/sequential_settings.hpp"
#include "runner/io/errors.hpp"
#include "runner/settings/fields.hpp"
#include "strategies/registry.hpp"

namespace autoref::runner {
namespace {

constexpr Range kIterationCount = {1, 9999};
constexpr Range kTuningPairs = {1, kMostPairs};
constexpr Range kGain = {0, 100, true};         // above 0
constexpr Range kDelta = {0, 50, true};         // goals
constexpr Range kWeight = {0, 1e6, true};       // above 0
constexpr Range kParameterValue = {-1e9, 1e9};  // as of `params`

// "iterations", "pairs", "gain" and so on; without the teams and parameters.
std::vector<Setting> settings_of(Tuning& tuning) {
  std::vector<Setting> settings = {
      {"method", &tuning.method, {}, {kSpsaName, kCmaEsName}, "", "optimiser"},
      {"iterations", &tuning.iterations, kIterationCount, {}, "", "steps of the optimiser"},
      {"pairs",
       &tuning.pairs,
       kTuningPairs,
       {},
       "",
       "pairs of legs per candidate, opponent and iteration"},
      {"gain",
       &tuning.gain,
       kGain,
       {},
       "",
       "of spsa: steps that a usual difference moves the parameters in the first iteration"},
      {"test.delta",
       &tuning.test.d1,
       kDelta,
       {},
       "goals per game",
       "gain that the final test looks for"}};
  for (Setting& setting : settings_of(
           tuning.test, "test",
           {"probability of better without any gain", "probability of missing a gain of delta"}))
    settings.push_back(std::move(setting));
  return settings;
}

// "tune.pass_risk.from" and so on.
std::vector<Setting> settings_of(TunedParameter& parameter) {
  const auto path = [&parameter](const char* key) {
    return fmt::format("tune.{}.{}", parameter.name, key);
  };
  return {{path("from"), &parameter.from, kParameterValue, {}, "", "least value"},
          {path("to"), &parameter.to, kParameterValue, {}, "", "largest value"},
          {path("start"), &parameter.start, kParameterValue, {}, "", "value to improve on"},
          {path("step"),
           &parameter.step,
           kParameterValue,
           {},
           "",
           "distance over which its effect is looked for at first"},
          {path("whole"),
           &parameter.whole,
           {},
           {"false", "true"},
           "",
           "whether only whole numbers are played"}};
}

std::vector<Setting> weight_settings_of(Tuning& tuning) {
  std::vector<Setting> settings;
  settings.reserve(tuning.weights.size());
  for (auto& [name, weight] : tuning.weights) {
    settings.push_back(
        {"weights." + name, &weight, kWeight, {}, "", "weight of its games in the score"});
  }
  return settings;
}

constexpr const char* kItself = "self";
constexpr double kStepShare = 0.2;  // the default step as a fraction of the range

// Refuses command-line settings below a branch such as "teams.", or of a path without a final dot,
// which would have no effect.
void refuse_assignments(const TopReader& top, const std::string& branch,
                        const std::string& message) {
  for (const Assignment& assignment : top.assignments()) {
    const std::string path = full_path(assignment.path);
    if (branch.ends_with('.') ? path.starts_with(branch) : path == branch)
      throw InputError({assignment.flag}, "", message);
  }
}

void read_team(TopReader& top, Tuning& tuning) {
  tuning.team = tuning.base.a;  // the base's rules determine the default number of robots
  const auto list = [&tuning] { return settings_of(tuning.team, tuning.base.types, "team."); };
  SettingsReader(top.file(), list, tuning.base, top.locations()).read(top.required("team"), "team");
  for (const Assignment& assignment : top.assignments()) {
    if (!assignment.path.starts_with("team.")) continue;
    blame(assignment.flag, [&] {
      set_by_path({tuning.base, tuning.team, "team."}, assignment.path, assignment.value);
    });
  }
}

void read_opponents(TopReader& top, Tuning& tuning) {
  const YamlEntry* entry = top.find("opponents");
  if (entry == nullptr) return;
  if (entry->value.IsScalar()) {
    top.word(*entry, "opponents", {kItself});
    refuse_assignments(top, "opponents.", "the tuned team plays against itself");
    return;
  }
  NamedTeamsReader(top.file(), top.locations(), top.assignments())
      .read(*entry, tuning.opponents, tuning.base, {1, SIZE_MAX});
}

void read_weights(TopReader& top, Tuning& tuning) {
  const YamlEntry* entry = top.find("weights");
  if (entry == nullptr) return;
  if (tuning.is_against_itself()) {
    top.file().refuse(entry->location, "weights",
                      "weights belong to opponents, and there are none; leave it out");
  }
  for (const auto& [name, team] : tuning.opponents) tuning.weights[name] = 1;
  SettingsReader(top.file(), weight_settings_of(tuning), top.locations()).read(*entry, "weights");
}

// The strategy's own description of a parameter; nullptr if it has none, or for a program.
const strategies::Tunable* described(const TeamSettings& team, const std::string& name) {
  const strategies::Entry* strategy =
      team.program.command.empty() ? strategies::find_strategy(team.strategy) : nullptr;
  if (strategy == nullptr) return nullptr;
  const auto found =
      std::find_if(strategy->params.begin(), strategy->params.end(),
                   [&name](const strategies::Tunable& its) { return its.name == name; });
  return found == strategy->params.end() ? nullptr : &*found;
}

class ParameterReader {
 public:
  ParameterReader(TopReader& top, const Tuning& tuning, const YamlEntry& entry)
      : top_(top), tuning_(tuning), entry_(entry), path_("tune." + entry.key) {}

  TunedParameter read() {
    TunedParameter parameter;
    parameter.name = entry_.key;
    const strategies::Tunable* its = described(tuning_.team, entry_.key);
    if (its != nullptr) {
      parameter.from = its->range.low;
      parameter.to = its->range.high;
      parameter.start = its->standard;
      parameter.whole = its->is_flag;
    }
    const auto value = tuning_.team.params.find(entry_.key);
    const bool has_value = value != tuning_.team.params.end();
    if (has_value) parameter.start = value->second;
    SettingsReader settings(top_.file(), settings_of(parameter), top_.locations());
    top_.locations()[path_] = entry_.location;
    settings.read(entry_, path_);
    for (const char* key : {"from", "to", "start", "step"}) {  // to report defaults somewhere
      top_.locations().try_emplace(fmt::format("{}.{}", path_, key), entry_.location);
    }
    given_ = top_.file().entries(entry_, path_, {});
    if (its != nullptr && its->is_flag && !parameter.whole) refuse_between();
    if (its == nullptr) require({"from", "to"});
    if (its == nullptr && !has_value) require({"start"});
    if (find_entry(given_, "step") == nullptr) parameter.step = default_step(parameter);
    return parameter;
  }

 private:
  void require(const std::vector<const char*>& keys) const {
    for (const char* key : keys) {
      if (find_entry(given_, key) != nullptr) continue;
      top_.file().refuse(entry_.location, path_,
                         fmt::format("the key '{}' is missing; a program does not describe its "
                                     "parameters, so give from, to and start",
                                     key));
    }
  }

  void refuse_between() const {
    top_.file().refuse(find_entry(given_, "whole")->location, path_ + ".whole",
                       "the parameter is either 0 or 1, and only these are played; leave it out");
  }

  static double default_step(const TunedParameter& parameter) {
    const double step = kStepShare * (parameter.to - parameter.from);
    return parameter.whole ? std::max(1.0, step) : step;
  }

  TopReader& top_;
  const Tuning& tuning_;
  const YamlEntry& entry_;
  const std::string path_;
  std::vector<YamlEntry> given_;
};

void read_parameters(TopReader& top, Tuning& tuning) {
  const YamlEntry& entry = top.required("tune");
  for (const YamlEntry& parameter : top.file().entries(entry, "tune", {})) {
    // Refuses a parameter that the strategy does not have, as `params` does.
    const strategies::Entry* strategy = tuning.team.program.command.empty()
                                            ? strategies::find_strategy(tuning.team.strategy)
                                            : nullptr;
    if (strategy != nullptr && described(tuning.team, parameter.key) == nullptr) {
      std::vector<std::string> known;
      known.reserve(strategy->params.size());
      for (const strategies::Tunable& its : strategy->params) known.emplace_back(its.name);
      top.file().refuse(parameter.location, "tune", unknown_key_message(parameter.key, known));
    }
    refuse_assignments(top, "team.params." + parameter.key,
                       "the file tunes this parameter; change its start there");
    tuning.parameters.push_back(ParameterReader(top, tuning, parameter).read());
  }
  if (!tuning.parameters.empty()) return;
  top.file().refuse(entry.location, "tune",
                    "expected a parameter, such as pass_risk: { from: 0.2, to: 0.9 }");
}

// The settings of a key.
std::vector<Setting> settings_at(Tuning& tuning, const std::string& key) {
  std::vector<Setting> settings = settings_of(tuning);
  std::erase_if(settings, [&key](const Setting& setting) {
    return setting.path != key && !setting.path.starts_with(key + ".");
  });
  return settings;
}

enum class Need { kOptional, kRequired };

Key number_key(Tuning& tuning, const std::string& name, Need need = Need::kOptional) {
  const std::vector<Setting> settings = settings_at(tuning, name);
  const bool has_default = need == Need::kOptional;
  Key key{name, has_default ? rows_of(settings).front().value : expected_of(settings.front()),
          std::string(settings.front().about)};
  key.read = [&tuning, name, need](TopReader& top) {
    const YamlEntry* entry = need == Need::kRequired ? &top.required(name) : top.find(name);
    if (entry == nullptr) return;
    top.locations()[name] = entry->location;
    SettingsReader(top.file(), settings_of(tuning), top.locations()).read(*entry, name);
    if (name != "gain" || tuning.method == kSpsaName) return;
    top.file().refuse(entry->location, name, "belongs to method spsa; leave it out");
  };
  key.text = [&tuning, name] {
    const bool is_used = name != "gain" || tuning.method == kSpsaName;
    return is_used ? text_of(settings_at(tuning, name)) : "";
  };
  key.values = [&tuning, name] { return values_of(settings_at(tuning, name)); };
  return key;
}

std::vector<Key> number_keys(Tuning& tuning) {
  std::vector<Key> keys = {number_key(tuning, "method"),
                           number_key(tuning, "iterations", Need::kRequired),
                           number_key(tuning, "pairs", Need::kRequired), number_key(tuning, "gain"),
                           number_key(tuning, "test")};
  keys[2].pairs = &tuning.pairs;
  keys.back().value.clear();
  keys.back().about = "the test of the result at the end";
  keys.back().below = {"the test", "", rows_of(settings_at(tuning, "test"))};
  return keys;
}

Key tuned_base_key(Tuning& tuning) {
  Key key = base_without_teams_key(tuning.base,
                                   "give the tuned team under `team` and its opponents under "
                                   "`opponents`, beside the base");
  key.read = [read_base = key.read](TopReader& top) {
    read_base(top);
    refuse_assignments(top, "teams.", "the teams of a tuning are team.KEY and opponents.NAME.KEY");
  };
  return key;
}

Key team_key(Tuning& tuning) {
  const auto settings = [&tuning] { return settings_of(tuning.team, tuning.base.types, "team."); };
  Key key{"team", "a team", "the team to improve, with any setting that a team can have"};
  key.read = [&tuning](TopReader& top) { read_team(top, tuning); };
  key.text = [settings] { return text_of(settings()); };
  key.values = [settings] { return values_of(settings()); };
  key.teams = [&tuning]() -> std::vector<TeamAt> { return {{"team", &tuning.team}}; };
  return key;
}

Key parameters_key(Tuning& tuning) {
  const auto settings = [&tuning] {
    std::vector<Setting> all;
    for (TunedParameter& parameter : tuning.parameters) {
      for (Setting& setting : settings_of(parameter)) all.push_back(std::move(setting));
    }
    return all;
  };
  Key key{"tune", "", "parameters to change, by name"};
  key.below = {"a parameter",
               "",
               {{"`from`, `to`", "numbers; the strategy's range", "least and largest value"},
                {"`start`", "number; the team's value", "value to improve on"},
                {"`step`", "number; a fifth of the range",
                 "distance over which its effect is looked for at first"},
                {"`whole`", "true or false; false", "whether only whole numbers are played"}}};
  key.read = [&tuning](TopReader& top) { read_parameters(top, tuning); };
  key.text = [settings] { return text_of(settings()); };
  key.values = [settings] { return values_of(settings()); };
  return key;
}

// Read with the opponents.
Key weights_key(Tuning& tuning) {
  Key key{"weights", "numbers above 0 by opponent; 1",
          "weight of each opponent's games in the score"};
  key.text = [&tuning] { return text_of(weight_settings_of(tuning)); };
  key.values = [&tuning] { return values_of(weight_settings_of(tuning)); };
  return key;
}

// All of them are in every game's score, so none has games of its own.
Key opponents_key(Tuning& tuning) {
  Key key = teams_key("opponents",
                      "whom it plays against; `self`: both candidates of an iteration play each "
                      "other",
                      tuning.opponents, tuning.base);
  key.value = "teams by name, or `self`; `self`";
  key.read = [&tuning](TopReader& top) {
    read_opponents(top, tuning);
    read_weights(top, tuning);
  };
  key.text = [&tuning, teams = key.text] {
    return tuning.is_against_itself() ? "opponents: self\n" : teams();
  };
  key.entries = nullptr;
  return key;
}

}  // namespace

std::vector<Key> Tuning::keys() {
  std::vector<Key> all = {tuned_base_key(*this), team_key(*this), parameters_key(*this)};
  for (Key& key : number_keys(*this)) all.push_back(std::move(key));
  all.push_back(weights_key(*this));
  all.push_back(opponents_key(*this));
  all.push_back(seed_key(seed));
  return all;
}

}  // namespace autoref::runner
