#include "runner/experiments/reading/tuning_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "runner/experiments/reading/named_teams_reader.hpp"
#include "runner/experiments/tuning_schedule.hpp"
#include "runner/experiments/tuning_settings.hpp"
#include "runner/io/errors.hpp"
#include "runner/settings/fields.hpp"
#include "strategies/registry.hpp"

namespace autoref::runner {
namespace {

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

void read_numbers(TopReader& top, Tuning& tuning) {
  SettingsReader settings(top.file(), settings_of(tuning), top.locations());
  for (const char* key : {"method", "iterations", "pairs", "gain", "test"}) {
    const YamlEntry* entry = top.find(key);
    if (entry == nullptr) continue;
    top.locations()[key] = entry->location;
    settings.read(*entry, key);
  }
  const YamlEntry* gain = top.find("gain");
  if (gain == nullptr || tuning.method == kSpsaName) return;
  top.file().refuse(gain->location, "gain", "belongs to method spsa; leave it out");
}

}  // namespace

Tuning read_tuning(TopReader& top) {
  top.allow({"team", "tune", "opponents", "weights", "base", "method", "iterations", "pairs",
             "gain", "test", "seed"});
  Tuning tuning;
  top.read_base(tuning.base, {"teams",
                              "give the tuned team under `team` and its opponents under "
                              "`opponents`, beside the base"});
  refuse_assignments(top, "teams.", "the teams of a tuning are team.KEY and opponents.NAME.KEY");
  tuning.seed = top.seed();
  read_team(top, tuning);
  read_opponents(top, tuning);
  read_weights(top, tuning);
  read_parameters(top, tuning);
  for (const char* key : {"iterations", "pairs"}) top.required(key);
  read_numbers(top, tuning);
  top.check([&tuning] { scheduled_games(tuning); });
  return tuning;
}

}  // namespace autoref::runner
