// The keys of scenario files of kind tune.
#include <fmt/format.h>

#include "experiments/kinds/tune/tuning.hpp"
#include "experiments/reading/named_teams_reader.hpp"
#include "experiments/reading/settings_text.hpp"
#include "experiments/reading/top_reader.hpp"
#include "experiments/schedule/sequential_settings.hpp"
#include "game/settings/fields.hpp"
#include "io/errors.hpp"

namespace autoref::experiments {
namespace {

constexpr Range kIterationCount = {1, 9999};
constexpr Range kTuningPairs = {1, kMostPairs};
constexpr Range kGain = {0, 100, true};    // values above 0
constexpr Range kDelta = {0, 50, true};    // in goals per game
constexpr Range kWeight = {0, 1e6, true};  // values above 0

// "iterations", "pairs", "gain" and so on; without the teams and parameters.
std::vector<game::Setting> settings_of(Tuning& tuning) {
  std::vector<game::Setting> settings = {
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
       "for spsa: by how many steps a typical difference moves the parameters in the first "
       "iteration"},
      {"test.delta",
       &tuning.test.d1,
       kDelta,
       {},
       "goals per game",
       "gain that the final test should detect"}};
  for (game::Setting& setting :
       settings_of(tuning.test, "test",
                   {"probability of the verdict \"better\" without any gain",
                    "probability of missing a gain of delta"}))
    settings.push_back(std::move(setting));
  return settings;
}

std::vector<game::Setting> weight_settings_of(Tuning& tuning) {
  std::vector<game::Setting> settings;
  settings.reserve(tuning.weights.size());
  for (auto& [name, weight] : tuning.weights) {
    settings.push_back(
        {"weights." + name, &weight, kWeight, {}, "", "weight of its games in the score"});
  }
  return settings;
}

constexpr const char* kItself = "self";

void read_team(TopReader& top, Tuning& tuning) {
  tuning.team = tuning.base.a;  // the base's rules determine the default number of robots
  const auto list = [&tuning] {
    return game::settings_of(tuning.team, tuning.base.types, "team.");
  };
  game::SettingsReader(top.file(), list, tuning.base, top.locations())
      .read(top.required("team"), "team");
  for (const game::Assignment& assignment : top.assignments()) {
    if (!assignment.path.starts_with("team.")) continue;
    game::locate_errors(assignment.flag, [&] {
      game::set_by_path({tuning.base, tuning.team, "team."}, assignment.path, assignment.value);
    });
  }
}

void read_opponents(TopReader& top, Tuning& tuning) {
  const game::YamlEntry* entry = top.find("opponents");
  if (entry == nullptr || entry->value.IsScalar()) {
    if (entry != nullptr) top.word(*entry, "opponents", {kItself});
    top.refuse_assignments("opponents.", "the tuned team plays against itself");
    return;
  }
  NamedTeamsReader(top.file(), top.locations(), top.assignments())
      .read(*entry, tuning.opponents, tuning.base, {1, SIZE_MAX});
}

void read_weights(TopReader& top, Tuning& tuning) {
  const game::YamlEntry* entry = top.find("weights");
  if (entry == nullptr) return;
  if (tuning.is_against_itself()) {
    top.file().refuse(
        entry->location, "weights",
        "weights are only for opponents, and the file has no opponents; leave this key out");
  }
  for (const auto& [name, team] : tuning.opponents) tuning.weights[name] = 1;
  game::SettingsReader(top.file(), weight_settings_of(tuning), top.locations())
      .read(*entry, "weights");
}

Key setting_key(Tuning& tuning, const std::string& name) {
  return settings_key(name, [&tuning] { return settings_of(tuning); });
}

Key pairs_per_candidate_key(Tuning& tuning) {
  Key key = without_default(setting_key(tuning, "pairs"));
  key.pairs = &tuning.pairs;
  return key;
}

// The key `gain`, which is read after the method. The method must be SPSA.
Key gain_key(Tuning& tuning) {
  Key key = setting_key(tuning, "gain");
  key.read = [&tuning, read_setting = key.read](TopReader& top) {
    read_setting(top);
    const game::YamlEntry* entry = top.find("gain");
    if (entry == nullptr || tuning.method == kSpsaName) return;
    top.file().refuse(entry->location, "gain", "only applies to method spsa; leave it out");
  };
  key.text = [&tuning, text_of_setting = key.text] {
    return tuning.method == kSpsaName ? text_of_setting() : "";
  };
  return key;
}

Key tuned_base_key(Tuning& tuning) {
  Key key = base_without_teams_key(
      tuning.base,
      "give the tuned team under `team` and its opponents under `opponents`, outside the base");
  key.read = [read_base = key.read](TopReader& top) {
    read_base(top);
    top.refuse_assignments("teams.", "the teams of a tuning are team.KEY and opponents.NAME.KEY");
  };
  return key;
}

Key team_key(Tuning& tuning) {
  const auto settings = [&tuning] {
    return game::settings_of(tuning.team, tuning.base.types, "team.");
  };
  Key key{"team", "a team", "the team to improve, with any setting that a team can have"};
  key.read = [&tuning](TopReader& top) { read_team(top, tuning); };
  key.text = [settings] { return text_of(settings()); };
  key.values = [settings] { return values_of(settings()); };
  key.teams = [&tuning]() -> std::vector<TeamAt> { return {{"team", &tuning.team}}; };
  return key;
}

// The key `weights`, which is read together with the opponents.
Key weights_key(Tuning& tuning) {
  Key key{"weights", "numbers above 0 by opponent; 1",
          "weight of each opponent's games in the score"};
  key.text = [&tuning] { return text_of(weight_settings_of(tuning)); };
  key.values = [&tuning] { return values_of(weight_settings_of(tuning)); };
  return key;
}

// Every candidate's score includes all opponents, so no opponent has games of its own.
Key opponents_key(Tuning& tuning) {
  Key key = teams_key("opponents",
                      "its opponents; `self`: both candidates of an iteration play each other",
                      tuning.opponents, tuning.base);
  key.value = "teams by name, or `self`; `self`";
  key.read = [&tuning](TopReader& top) {
    read_opponents(top, tuning);
    read_weights(top, tuning);
  };
  key.text = [&tuning, teams = key.text] {
    return tuning.is_against_itself() ? fmt::format("opponents: {}\n", kItself) : teams();
  };
  key.entries = nullptr;
  return key;
}

}  // namespace

std::vector<Key> Tuning::keys() {
  return {tuned_base_key(*this),
          team_key(*this),
          parameters_key(*this),
          setting_key(*this, "method"),
          without_default(setting_key(*this, "iterations")),
          pairs_per_candidate_key(*this),
          gain_key(*this),
          settings_branch_key(kTestKey, "the test", "the test of the result at the end",
                              [this] { return settings_of(*this); }),
          weights_key(*this),
          opponents_key(*this),
          seed_key(seed)};
}

}  // namespace autoref::experiments
