#include "runner/experiments/reading/scenario_reader.hpp"

#include <fmt/format.h>

#include "runner/experiments/cells.hpp"
#include "runner/experiments/reading/base_reader.hpp"
#include "runner/experiments/reading/factor_reader.hpp"
#include "runner/experiments/reading/judge_reader.hpp"
#include "runner/experiments/reading/situations_reader.hpp"
#include "runner/experiments/reading/team_experiments_reader.hpp"
#include "runner/experiments/reading/top_reader.hpp"
#include "runner/experiments/reading/tuning_reader.hpp"
#include "runner/experiments/schedule.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/files.hpp"
#include "runner/io/words.hpp"
#include "runner/settings/renamed.hpp"
#include "runner/settings/settings_reader.hpp"
#include "runner/settings/yaml.hpp"

namespace autoref::runner {
namespace {

constexpr int kMostJudged = 9999;
constexpr const char* kSetByValues = "set_by_values";

// Reads one document, top level first.
class ScenarioReader {
 public:
  ScenarioReader(const YamlFile& file, const Assignments& assignments) : top_(file, assignments) {}

  Scenario read() {
    read_schema();
    const YamlEntry& kind_entry = top_.required("kind");
    refuse_other_files(kind_entry);
    const std::string kind = top_.word(kind_entry, "kind", kinds());
    Scenario scenario;
    if (const YamlEntry* about = top_.find("about")) {
      scenario.about = top_.file().scalar(*about, "about", "a sentence", false);
    }
    if (kind == "game") {
      scenario.content = read_game();
    } else if (kind == "sweep") {
      scenario.content = read_sweep();
    } else if (kind == "roundrobin") {
      scenario.content = read_roundrobin(top_);
    } else if (kind == "sprt") {
      scenario.content = read_sprt_match(top_);
    } else if (kind == "gauntlet") {
      scenario.content = read_gauntlet(top_);
    } else if (kind == "knockout") {
      scenario.content = read_knockout(top_);
    } else if (kind == "situations") {
      scenario.content = read_situations(top_);
    } else if (kind == "tune") {
      scenario.content = read_tuning(top_);
    } else {
      scenario.content = read_judge();
    }
    return scenario;
  }

 private:
  void refuse_other_files(const YamlEntry& kind) const {
    const std::string text = kind.value.IsScalar() ? kind.value.Scalar() : "";
    if (const std::optional<std::string_view> now = new_kind_of(text)) {
      top_.file().refuse(value_location(kind), "kind",
                         fmt::format("unknown kind '{}'; its name is '{}' now", text, *now));
    }
    if (text == "lab") {
      top_.file().refuse(value_location(kind), "kind",
                         "this is a scene; play it with: autoref lab FILE");
    }
    if (text == "robot") {
      top_.file().refuse(value_location(kind), "kind",
                         "this is a robot type; name it in a scenario as a team's type");
    }
  }

  void read_schema() const {
    const YamlEntry& schema = top_.required("schema");
    const std::string expected = "1, the only schema so far";
    const std::string text = top_.file().scalar(schema, "schema", expected, true);
    if (whole_number_in(text) == 1) return;
    top_.file().refuse(value_location(schema), "schema",
                       fmt::format("expected {}, found '{}'", expected, text));
  }

  // Refuses a file whose set_by_values, which AutoRef writes to effective.yaml, has been changed.
  template <typename Schedule>
  void check_set_by_values(const Schedule& schedule) const {
    const YamlEntry* entry = top_.find(kSetByValues);
    if (entry == nullptr) return;
    SetByValues found;
    for (const YamlEntry& value : top_.file().entries(*entry, kSetByValues, {})) {
      for (const YamlEntry& setting : top_.file().entries(value, value.key, {})) {
        found[value.key][setting.key] =
            top_.file().scalar(setting, setting.key, "a plain value", false);
      }
    }
    if (found == set_by_values(schedule)) return;
    top_.file().refuse(entry->location, kSetByValues,
                       "does not match what base and the varied values set; leave it out");
  }

  GameSettings read_game() {
    GameSettings game;
    SettingsReader settings(top_.file(), game, top_.locations());
    top_.allow(settings.names());
    read_settings(top_.entries(), settings);
    top_.check([&game] { check_game(game); });
    top_.assign_all(game);
    return game;
  }

  Sweep read_sweep() {
    top_.allow({"base", "factors", kSetByValues, "pairs", "seed"});
    Sweep sweep;
    top_.read_base(sweep.base);
    FactorReader(top_.file(), top_.locations()).read(top_.required("factors"), sweep);
    for (const Factor& factor : sweep.factors) top_.refuse_assignment(factor.path);
    sweep.pairs = top_.pairs();
    sweep.seed = top_.seed();
    top_.check([&sweep] { scheduled_games(sweep); });  // checks that the values fit together
    check_set_by_values(sweep);
    return sweep;
  }

  JudgeSchedule read_judge() {
    top_.allow(
        {"base", "rules", "cameras", kSetByValues, "matchups", "teams", "games", "seed", "seeds"});
    JudgeSchedule schedule;
    top_.read_base(schedule.base);
    JudgeReader(top_.file(), top_.locations()).read(top_.entries(), schedule);
    schedule.games = top_.whole_number("games", 1, kMostJudged);
    if (top_.find("seeds") == nullptr) {
      const std::uint64_t seed = top_.seed();
      schedule.seeds = {{"", std::to_string(seed), seed}};
    }
    for (const char* varied : {"match.rules", "sim.camera"}) top_.refuse_assignment(varied);
    top_.check([&schedule] { games_of(schedule); });
    check_set_by_values(schedule);
    return schedule;
  }

  TopReader top_;
};

}  // namespace

Scenario read_scenario_text(const std::string& text, const std::string& file_name,
                            const Assignments& assignments) {
  const YamlFile file(text, file_name);
  return ScenarioReader(file, assignments).read();
}

Scenario read_scenario(const std::filesystem::path& file, const Assignments& assignments) {
  return read_scenario_text(read_user_file(file), file.string(), assignments);
}

}  // namespace autoref::runner
