#include "experiments/kinds/tune/tuning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "experiments/reading/settings_text.hpp"
#include "experiments/reading/top_reader.hpp"
#include "strategies/registry.hpp"

namespace autoref::experiments {
namespace {

constexpr Range kParameterValue = {-1e9, 1e9};  // the same range as for `params`
constexpr double kStepShare = 0.2;              // the default step as a fraction of the range

// "tune.pass_risk.from" and so on.
std::vector<game::Setting> settings_of(TunedParameter& parameter) {
  const auto path = [&parameter](const char* key) {
    return fmt::format("tune.{}.{}", parameter.name, key);
  };
  return {{path("from"), &parameter.from, kParameterValue, {}, "", "smallest value"},
          {path("to"), &parameter.to, kParameterValue, {}, "", "largest value"},
          {path("start"),
           &parameter.start,
           kParameterValue,
           {},
           "",
           "value from which the search starts"},
          {path("step"),
           &parameter.step,
           kParameterValue,
           {},
           "",
           "how far the value is varied at first"},
          {path("whole"),
           &parameter.whole,
           {},
           {"false", "true"},
           "",
           "whether to try only whole numbers"}};
}

// The strategy's own description of a parameter; nullptr if there is none or the team is a program.
const strategies::Tunable* described(const game::TeamSettings& team, const std::string& name) {
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
  ParameterReader(TopReader& top, const Tuning& tuning, const game::YamlEntry& entry)
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
    game::SettingsReader settings(top_.file(), settings_of(parameter), top_.locations());
    top_.locations()[path_] = entry_.location;
    settings.read(entry_, path_);
    for (const char* key : {"from", "to", "start", "step"}) {  // so that defaults have a location
      top_.locations().try_emplace(fmt::format("{}.{}", path_, key), entry_.location);
    }
    given_ = top_.file().entries(entry_, path_, {});
    if (its != nullptr && its->is_flag && !parameter.whole) refuse_between();
    if (its == nullptr) require({"from", "to"});
    if (its == nullptr && !has_value) require({"start"});
    if (game::find_entry(given_, "step") == nullptr) parameter.step = default_step(parameter);
    return parameter;
  }

 private:
  void require(const std::vector<const char*>& keys) const {
    for (const char* key : keys) {
      if (game::find_entry(given_, key) != nullptr) continue;
      top_.file().refuse(entry_.location, path_,
                         fmt::format("the key '{}' is missing; a program does not describe its "
                                     "parameters, so give from, to and start",
                                     key));
    }
  }

  void refuse_between() const {
    top_.file().refuse(game::find_entry(given_, "whole")->location, path_ + ".whole",
                       "the parameter can only be 0 or 1; leave this key out");
  }

  static double default_step(const TunedParameter& parameter) {
    const double step = kStepShare * (parameter.to - parameter.from);
    return parameter.whole ? std::max(1.0, step) : step;
  }

  TopReader& top_;
  const Tuning& tuning_;
  const game::YamlEntry& entry_;
  const std::string path_;
  std::vector<game::YamlEntry> given_;
};

void read_parameters(TopReader& top, Tuning& tuning) {
  const game::YamlEntry& entry = top.required("tune");
  for (const game::YamlEntry& parameter : top.file().entries(entry, "tune", {})) {
    // Refuses a parameter that the strategy does not have, just as the key `params` does.
    const strategies::Entry* strategy = tuning.team.program.command.empty()
                                            ? strategies::find_strategy(tuning.team.strategy)
                                            : nullptr;
    if (strategy != nullptr && described(tuning.team, parameter.key) == nullptr) {
      std::vector<std::string> known;
      known.reserve(strategy->params.size());
      for (const strategies::Tunable& its : strategy->params) known.emplace_back(its.name);
      top.file().refuse(parameter.location, "tune",
                        game::unknown_key_message(parameter.key, known));
    }
    top.refuse_assignments("team.params." + parameter.key,
                           "the file tunes this parameter; change its start there");
    tuning.parameters.push_back(ParameterReader(top, tuning, parameter).read());
  }
  if (!tuning.parameters.empty()) return;
  top.file().refuse(entry.location, "tune",
                    "expected a parameter, such as pass_risk: { from: 0.2, to: 0.9 }");
}

// A parameter's default in words, for the reference page.
std::string default_of(const std::string& names) {
  static const std::map<std::string, std::string> kDefaults = {
      {"`from`", "the strategy's smallest value"},
      {"`to`", "the strategy's largest value"},
      {"`start`", "the team's value"},
      {"`step`", fmt::format("{} of the range", kStepShare)}};
  const auto found = kDefaults.find(names);
  return found == kDefaults.end() ? "" : found->second;
}

}  // namespace

Key parameters_key(Tuning& tuning) {
  const auto settings = [&tuning] {
    std::vector<game::Setting> all;
    for (TunedParameter& parameter : tuning.parameters) {
      for (game::Setting& setting : settings_of(parameter)) all.push_back(std::move(setting));
    }
    return all;
  };
  Key key{"tune", "", "parameters to change, by name"};
  key.below = []() -> KeysBelow {
    TunedParameter parameter;
    std::vector<KeyRow> rows = rows_of(settings_of(parameter), {"from", "to", "start", "step"});
    for (KeyRow& row : rows) {
      if (row.names != "`whole`") row.value = "number; " + default_of(row.names);
    }
    return {"a parameter", "", std::move(rows)};
  };
  key.read = [&tuning](TopReader& top) { read_parameters(top, tuning); };
  key.text = [settings] { return text_of(settings()); };
  key.values = [settings] { return values_of(settings()); };
  return key;
}

}  // namespace autoref::experiments
