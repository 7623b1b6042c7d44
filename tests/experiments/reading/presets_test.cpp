// A setting that the user gives overrides every preset: in a file, as a factor or by --set, in any
// order.
#include <gtest/gtest.h>

#include <set>

#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/kinds/sweep/sweep.hpp"
#include "experiments/schedule/schedule.hpp"
#include "game/settings/fields.hpp"
#include "io/errors.hpp"

namespace autoref::experiments {
namespace {

using Values = std::map<std::string, std::string>;  // by full path

// All settings of a game and the overrides of its teams' robots.
Values values_of(game::GameSettings game) {
  Values values;
  for (const game::Setting& setting : game::settings_of(game)) {
    if (const auto* of = std::get_if<game::ChangesOf>(&setting.target)) {
      for (const auto& [path, value] : *of->changes) {
        if (game::branch_of(path) == of->branch) {
          values[setting.path + path.substr(of->branch.size())] = game::spelt(value);
        }
      }
    }
    if (!game::is_alias(setting) && !game::holds_others(setting))
      values[setting.path] = game::value_of(setting);
  }
  return values;
}

struct Preset {
  std::string path;
  std::vector<std::string> words;
};

// Every preset of a game, found in the list of settings.
std::vector<Preset> presets() {
  game::GameSettings game;
  game::set_by_path(game, "b.players.2.handicap", "1");
  std::vector<Preset> found;
  for (const game::Setting& setting : game::settings_of(game)) {
    if (game::is_preset(setting)) found.push_back({setting.path, setting.allowed_words});
    for (const std::string& name : game::names_in(setting)) {
      const game::Setting held = game::setting_in(setting, name).value();
      if (game::is_preset(held)) found.push_back({held.path, held.allowed_words});
    }
  }
  return found;
}

std::vector<game::Assignment> in_order(const std::string& path, const std::string& value,
                                       const std::string& preset, const std::string& word,
                                       bool preset_first) {
  const game::Assignment own = {"", path, value};
  const game::Assignment its = {"", preset, word};
  return preset_first ? game::Assignments{its, own} : game::Assignments{own, its};
}

// The paths that a preset sets: those whose values differ between two of its words, or between a
// word and the default.
std::set<std::string> set_by(const Preset& preset) {
  std::set<std::string> paths;
  const Values defaults = values_of({});
  for (const std::string& word : preset.words) {
    game::GameSettings game;
    game::set_by_path(game, preset.path, word);
    for (const auto& [path, value] : values_of(game)) {
      const auto usual = defaults.find(path);
      const bool differs = usual == defaults.end() || usual->second != value;
      if (differs && path != preset.path && !path.starts_with("teams.b.players.2.type") &&
          !path.ends_with("_factor")) {
        paths.insert(path);
      }
    }
  }
  return paths;
}

// A value of the setting that differs from the preset's.
std::string other_value(const std::string& path, const std::string& value) {
  game::GameSettings game;
  for (const char* text : {"1", "2", "0.5", "0.1", "5", "7", "12", "0.01", "0.05", "90", "true",
                           "false", "box", "quarter_circles"}) {
    try {
      game::set_by_path(game, path, text);
    } catch (const std::invalid_argument&) {
      continue;
    }
    if (game::value_at(game, path) != value) return game::value_at(game, path);
  }
  return "none found for " + path;
}

// Calls `check` for every setting of every word of every preset.
template <typename Check>
int for_each_setting(const Check& check) {
  int count = 0;
  for (const Preset& preset : presets()) {
    const std::set<std::string> paths = set_by(preset);
    EXPECT_FALSE(paths.empty()) << preset.path;
    for (const std::string& word : preset.words) {
      game::GameSettings game;
      game::set_by_path(game, preset.path, word);
      const Values alone = values_of(game);
      for (const std::string& path : paths) {
        check(preset.path, word, path, other_value(path, alone.at(path)), alone);
        ++count;
      }
    }
  }
  return count;
}

// Expects every setting to have the preset's value, except the setting that the user gave.
void expect_only_one_differs(const game::GameSettings& game, const std::string& path,
                             const std::string& value, Values alone, const std::string& what) {
  alone[path] = value;
  EXPECT_EQ(values_of(game), alone) << what << " over " << path << " = " << value;
}

TEST(Presets, LeaveSingleSettingsAloneInAnyOrder) {
  const int settings =
      for_each_setting([](const std::string& preset, const std::string& word,
                          const std::string& path, const std::string& value, const Values& alone) {
        for (const bool preset_first : {true, false}) {
          game::GameSettings game;
          for (const game::Assignment& a : in_order(path, value, preset, word, preset_first)) {
            game::set_by_path(game, a.path, a.value);
          }
          expect_only_one_differs(game, path, value, alone, preset + "=" + word);
        }
      });
  EXPECT_GT(settings, 250);  // presets of cameras, balls, dribblers and rule books
}

TEST(Presets, LeaveTheFilesSettingsAloneIfChosenOnTheCommandLine) {
  for_each_setting([](const std::string& preset, const std::string& word, const std::string& path,
                      const std::string& value, const Values& alone) {
    game::GameSettings written;
    game::set_by_path(written, path, value);
    const Scenario file = {"", written};
    std::string text = "schema: 1\nkind: game\n";
    std::string indent;
    for (std::size_t from = 0; from != std::string::npos;) {
      const std::size_t dot = path.find('.', from);
      text += indent + path.substr(from, dot - from) + ":";
      from = dot == std::string::npos ? dot : dot + 1;
      text += dot == std::string::npos ? " " + value + "\n" : "\n";
      indent += "  ";
    }
    try {
      const Scenario scenario =
          read_scenario_text(text, "x.yaml", {{"--set " + preset, preset, word}});
      expect_only_one_differs(std::get<game::GameSettings>(scenario.content), path, value, alone,
                              preset + "=" + word);
    } catch (const io::InputError&) {
      // Some combinations of a value and a preset are invalid; for example, the robots may not fit
      // on the field.
    }
  });
}

Sweep preset_sweep_of(const std::string& lines) {
  const std::string text = "schema: 1\nkind: sweep\npairs: 1\nseed: 1\n" + lines;
  return *read_scenario_text(text, "x.yaml").as<Sweep>();
}

// The games' configurations by cell name.
std::map<std::string, game::GameSettings> cells_of(const Sweep& sweep) {
  std::map<std::string, game::GameSettings> cells;
  for (const ScheduledGame& game : sweep.games()) {
    cells[game.id.substr(0, game.id.find("-p"))] = game.settings.combined();
  }
  return cells;
}

TEST(Presets, AsFactorsLeaveTheBaseAlone) {
  const auto cells = cells_of(preset_sweep_of(
      "base: { teams: { b: { robots: 3 } }, match: { half_s: 5 }, sim: { latency_s: 0.1 } "
      "}\nfactors: { match.rules: [paper, \"2014\"], sim.camera: [none, realistic] }\n"));
  ASSERT_EQ(cells.size(), 4U);
  for (const auto& [name, game] : cells) {
    EXPECT_EQ(game.b.robots, 3) << name;
    EXPECT_EQ(game.a.robots, 6) << name;
    EXPECT_EQ(game.match.half_s, 5) << name;
    EXPECT_EQ(game.sim.latency_s, 0.1) << name;
  }
  EXPECT_EQ(cells.at("match.rules=2014+sim.camera=realistic").sim.vision.ball_noise_m, 0.0014);
}

TEST(Presets, AsFactorsLeaveOtherFactorsAloneInAnyOrder) {
  for (const char* factors :
       {"sim.camera: [none, realistic], sim.latency_s: [0.1, 0.2], match.half_s: [5, 7], "
        "match.rules: [paper, \"2014\"]",
        "match.rules: [paper, \"2014\"], match.half_s: [5, 7], sim.latency_s: [0.1, 0.2], "
        "sim.camera: [none, realistic]"}) {
    for (const auto& [name, game] :
         cells_of(preset_sweep_of("factors: { " + std::string(factors) + " }\n"))) {
      const auto says = [&name = name](const std::string& cell) {
        return name.find(cell) != std::string::npos;
      };
      EXPECT_EQ(game.sim.latency_s, says("latency_s=0.1") ? 0.1 : 0.2) << name;
      EXPECT_EQ(game.match.half_s, says("half_s=5") ? 5 : 7) << name;
      EXPECT_EQ(game.sim.vision.ball_noise_m, says("camera=none") ? 0 : 0.0014) << name;
      EXPECT_EQ(game.match.rules.name, says("rules=2014") ? "2014" : "paper") << name;
    }
  }
}

TEST(Presets, AsFactorsKeepTheirNamesIfSingleSettingsDiffer) {
  const Sweep sweep = preset_sweep_of(
      "base: { sim: { vision: { reports_height: false } } }\n"
      "factors: { sim.camera: [paper, none] }\n");
  EXPECT_EQ(sweep.factors[0].values, (std::vector<game::SettingValue>{"paper", "none"}));
}

TEST(Presets, ReadTheSameFromTheEffectiveFile) {
  for (const char* lines :
       {"base: { teams: { b: { robots: 3 } }, match: { half_s: 5 } }\n"
        "factors: { match.rules: [paper, \"2014\", 2026-b], sim.camera: [none, realistic] }\n",
        "base: { sim: { camera: realistic, latency_s: 0.1 }, match: { rules: 2026-a } }\n"
        "factors: { sim.camera: [realistic, none], sim.ball.preset: [tigers, default] }\n",
        "base: { teams: { b: { dribbler: { force_n: 3 } } } }\n"
        "factors: { b.dribbler.preset: [perfect, default], b.handicap: [1.0, 0.5] }\n",
        "factors: { b.players.3.dribbler.preset: [perfect, default], b.robots: [6, 5] }\n"}) {
    const Sweep sweep = preset_sweep_of(lines);
    const std::string text = effective_text({"A sweep.", sweep});
    const auto again = *read_scenario_text(text, "effective.yaml").as<Sweep>();
    EXPECT_EQ(effective_text({"A sweep.", again}), text);
    const auto cells = cells_of(sweep);
    const auto cells_again = cells_of(again);
    ASSERT_EQ(cells.size(), cells_again.size());
    for (const auto& [name, game] : cells) {
      EXPECT_EQ(values_of(cells_again.at(name)), values_of(game)) << name << "\n" << text;
    }
  }
}

TEST(Presets, AreSpeltOutForEachValueInTheEffectiveFile) {
  const std::string text = effective_text(
      {"A sweep.", preset_sweep_of("base: { match: { half_s: 5 } }\n"
                                   "factors: { match.rules: [paper, \"2014\"] }\n")});
  EXPECT_NE(text.find("    half_s: 5.0 "), std::string::npos) << text;
  EXPECT_NE(text.find("\"match.rules=2014\":\n"), std::string::npos) << text;
  EXPECT_NE(text.find("    match.switch.bot_crash_unique: true\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("match.half_s"), std::string::npos) << text;
}

TEST(Presets, CannotBeContradictedInTheEffectiveFile) {
  std::string text =
      effective_text({"", preset_sweep_of("factors: { match.rules: [paper, \"2014\"] }\n")});
  const std::string line = "    match.switch.bot_crash_unique: true\n";
  text.replace(text.find(line), line.size(), "    match.switch.bot_crash_unique: false\n");
  try {
    read_scenario_text(text, "effective.yaml");
    FAIL() << "accepted";
  } catch (const io::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("set_by_values: "), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace autoref::experiments
