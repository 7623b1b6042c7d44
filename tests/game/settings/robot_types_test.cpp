// Robot types: their files, and how scenarios, sweeps and flags name them.
#include "game/settings/robot_types.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/kinds/sweep/sweep.hpp"
#include "experiments/schedule/schedule.hpp"
#include "game/settings/fields.hpp"
#include "io/errors.hpp"
#include "tests/checkout.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::game {
namespace {

const std::string kType = "schema: 1\nkind: robot\n";
const std::string kTypesGame = "schema: 1\nkind: game\n";
const std::string kTypesSweep = "schema: 1\nkind: sweep\npairs: 1\nseed: 1\n";

// A folder with a scenario, and the types `slow` and `fast` in a subfolder.
class ScenarioWithTypes : public testing::Test {
 protected:
  ScenarioWithTypes() {
    std::filesystem::create_directory(folder_ / "robots");
    write_content(folder_ / "robots/slow.yaml", kType + "robot: { speed_mps: 2.2 }\n");
    write_content(folder_ / "robots/fast.yaml", kType + "robot: { speed_mps: 3.5 }\n");
  }
  experiments::Scenario read(const std::string& text) const {
    write_content(folder_ / "x.yaml", text);
    return experiments::read_scenario(folder_ / "x.yaml");
  }
  GameSettings game(const std::string& text) const {
    return std::get<GameSettings>(read(kTypesGame + text).content);
  }
  experiments::Sweep sweep(const std::string& text) const {
    return *read(kTypesSweep + text).as<experiments::Sweep>();
  }
  std::string refusal(const std::string& text) const {
    try {
      read(text);
      return "accepted";
    } catch (const io::InputError& error) {
      return error.what();
    }
  }
  static double speed_mps(const GameSettings& game, std::size_t number) {
    return spec_of(game, game.b, "teams.b").robots.at(number).body.speed_mps;
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  TemporaryFolder folder_;
};

TEST_F(ScenarioWithTypes, FindsThemRelativeToItself) {
  const GameSettings it = game(
      "teams: { b: { type: robots/slow.yaml, players: { 1: { type: robots/fast.yaml } } } }\n");
  EXPECT_EQ(speed_mps(it, 0), 2.2);
  EXPECT_EQ(speed_mps(it, 1), 3.5);
}

TEST_F(ScenarioWithTypes, VariesThemAsFactorsWithReadableIds) {
  const std::vector<experiments::ScheduledGame> games =
      sweep(
          "factors:\n  b.type: [none, robots/slow.yaml]\n"
          "  b.players.3.handicap: [1.0, 0.7]\n")
          .games();
  ASSERT_EQ(games.size(), 8U);
  const auto both =
      std::find_if(games.begin(), games.end(), [](const experiments::ScheduledGame& game) {
        return game.id == "b.type=slow+b.players.3.handicap=0.7-p0001-2";
      });
  ASSERT_NE(both, games.end());
  EXPECT_EQ(speed_mps(games.front().settings.combined(), 3), 3.0);
  const GameSettings it = both->settings.combined();
  EXPECT_EQ(speed_mps(it, 3), 2.2);
  EXPECT_EQ(spec_of(it, it.b, "teams.b").robots[3].speed_factor, 0.7);
  EXPECT_EQ(spec_of(it, it.b, "teams.b").robots[2].speed_factor, 1.0);
}

TEST_F(ScenarioWithTypes, VariesATypeTogetherWithTheTeamsValues) {
  const std::vector<experiments::ScheduledGame> games =
      sweep(
          "base: { teams: { b: { type: robots/fast.yaml, robot: { mass_kg: 3 } } } }\n"
          "factors: { b.type: [robots/slow.yaml] }\n")
          .games();
  const GameSettings it = games[0].settings.combined();
  EXPECT_EQ(speed_mps(it, 0), 2.2);
  EXPECT_EQ(spec_of(it, it.b, "teams.b").robots[0].body.mass_kg, 3);
}

TEST_F(ScenarioWithTypes, IsReproducedFromItsEffectiveText) {
  const experiments::Scenario scenario =
      read(kTypesGame +
           "teams: { b: { type: robots/slow.yaml, players: { 1: { type: "
           "robots/fast.yaml, kicker: { reach_m: 0.02 } } } } }\n");
  const experiments::Scenario back = experiments::read_scenario_text(
      experiments::effective_text(scenario), "elsewhere/effective.yaml");
  EXPECT_EQ(configuration_hash(std::get<GameSettings>(back.content)),
            configuration_hash(std::get<GameSettings>(scenario.content)));
}

TEST_F(ScenarioWithTypes, HasItsSweepReproducedFromTheEffectiveText) {
  const experiments::Scenario scenario =
      read(kTypesSweep + "factors: { b.type: [none, robots/slow.yaml] }\n");
  const experiments::Scenario back = experiments::read_scenario_text(
      experiments::effective_text(scenario), "elsewhere/effective.yaml");
  const std::vector<experiments::ScheduledGame> games = scenario.as<experiments::Sweep>()->games();
  const std::vector<experiments::ScheduledGame> games_back = back.as<experiments::Sweep>()->games();
  ASSERT_EQ(games_back.size(), games.size());
  for (std::size_t i = 0; i < games.size(); ++i) {
    EXPECT_EQ(games_back[i].id, games[i].id);
    EXPECT_EQ(configuration_hash(games_back[i].settings.combined()),
              configuration_hash(games[i].settings.combined()));
  }
}

TEST_F(ScenarioWithTypes, HasAHashOfValuesNotNames) {
  const std::string text = "teams: { b: { type: robots/slow.yaml } }\n";
  const std::uint64_t slow = configuration_hash(game(text));
  write_content(folder_ / "robots/lame.yaml", content_of(folder_ / "robots/slow.yaml"));
  EXPECT_EQ(configuration_hash(game("teams: { b: { type: robots/lame.yaml } }\n")), slow);
  EXPECT_EQ(configuration_hash(game("teams: { b: { robot: { speed_mps: 2.2 } } }\n")), slow);
  write_content(folder_ / "robots/slow.yaml", kType + "robot: { speed_mps: 2.1 }\n");
  EXPECT_NE(configuration_hash(game(text)), slow);
}

TEST_F(ScenarioWithTypes, NamesItsOwnLocationForATypeThatCannotBeRead) {
  const std::string start = file("x.yaml") + ":3:21: teams.b.type: ";
  const std::string message = refusal(kTypesGame + "teams: { b: { type: robots/lost.yaml } }\n");
  EXPECT_TRUE(message.starts_with(start)) << message;
  EXPECT_NE(message.find("robots/lost.yaml: the file cannot be read"), std::string::npos);
}

TEST_F(ScenarioWithTypes, RefusesAnUnknownType) {
  const std::string message = refusal(kTypesGame + "teams: { b: { type: slow } }\n");
  EXPECT_TRUE(message.starts_with(file("x.yaml") + ":3:21: teams.b.type: ")) << message;
  EXPECT_NE(message.find("a file such as robots/slow.yaml, or one of none"), std::string::npos);
}

TEST_F(ScenarioWithTypes, NamesTheTypesLocationForAnErrorInIt) {
  write_content(folder_ / "robots/slow.yaml", kType + "robot: { speed: 2 }\n");
  const std::string message = refusal(kTypesGame + "teams: { b: { type: robots/slow.yaml } }\n");
  EXPECT_TRUE(message.starts_with(file("robots/slow.yaml") + ":3:10: robot: unknown key 'speed'"))
      << message;
}

TEST_F(ScenarioWithTypes, RefusesTwoTypesWithTheSameName) {
  std::filesystem::create_directory(folder_ / "other");
  write_content(folder_ / "other/slow.yaml", kType + "robot: { speed_mps: 1 }\n");
  const std::string message = refusal(
      kTypesGame + "teams: { a: { type: robots/slow.yaml }, b: { type: other/slow.yaml } }\n");
  EXPECT_NE(message.find("another robot type is already called 'slow'"), std::string::npos)
      << message;
}

TEST_F(ScenarioWithTypes, SaysThatATypeIsNamedAfterItsFile) {
  const std::string message =
      refusal(kTypesGame + "teams: { b: { type: robots/very slow.yaml } }\n");
  EXPECT_TRUE(message.starts_with(file("x.yaml") + ":3:21: teams.b.type: ")) << message;
  EXPECT_TRUE(message.ends_with("found 'very slow'; rename the file")) << message;
}

TEST_F(ScenarioWithTypes, ResolvesAFlagsPathInTheGivenFolder) {
  GameSettings it;
  set_by_path(it, "b.type", "robots/slow.yaml", folder_.path());
  set_by_path(it, "b.players.2.type", "robots/fast.yaml", folder_.path());
  EXPECT_EQ(speed_mps(it, 0), 2.2);
  EXPECT_EQ(speed_mps(it, 2), 3.5);
  set_by_path(it, "b.type", "none", folder_.path());
  EXPECT_EQ(speed_mps(it, 0), 3.0);
}

struct TypeMistake {
  const char* name;
  std::string text;
  const char* message;  // start of the message
};

class WrongType : public testing::TestWithParam<TypeMistake> {};

TEST_P(WrongType, IsRefusedWithItsLocation) {
  try {
    read_robot_type_text(GetParam().text, "t.yaml");
    FAIL() << "was accepted";
  } catch (const io::InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with(GetParam().message)) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(
    Files, WrongType,
    testing::Values(
        TypeMistake{"Empty", "", "t.yaml: the file is empty"},
        TypeMistake{"OtherKind", kTypesGame, "t.yaml:2:7: kind: expected robot, found 'game'"},
        TypeMistake{"NoSchema", "kind: robot\n", "t.yaml:1:1: the key 'schema' is missing"},
        TypeMistake{"UnknownBranch", kType + "wheels: {}\n", "t.yaml:3:1: unknown key 'wheels'"},
        TypeMistake{"Factor", kType + "handicap: 0.5\n", "t.yaml:3:1: unknown key 'handicap'"},
        TypeMistake{"Number", kType + "robot: 5\n", "t.yaml:3:8: robot: expected a mapping"},
        TypeMistake{"Range", kType + "robot: { mass_kg: 0 }\n",
                    "t.yaml:3:19: robot.mass_kg: expected a number from 0.001 to 100 kg"},
        TypeMistake{"Quoted", kType + "robot: { mass_kg: \"2\" }\n",
                    "t.yaml:3:19: robot.mass_kg: expected a number"},
        TypeMistake{"Twice", kType + "robot: { mass_kg: 2, mass_kg: 2 }\n", "t.yaml:3:22: robot: "},
        TypeMistake{"Preset", kType + "dribbler: { preset: sticky }\n",
                    "t.yaml:3:21: dribbler.preset: expected one of default, perfect, rc2026, found "
                    "'sticky'"},
        TypeMistake{"Holds", kType + "dribbler: { holds: 1 }\n",
                    "t.yaml:3:20: dribbler.holds: expected one of false, true, found '1'"},
        TypeMistake{"About", kType + "about: [1]\n", "t.yaml:3:8: about: expected a sentence"}),
    [](const auto& test) { return test.param.name; });

RobotChanges read_robot_type(const std::filesystem::path& file) {
  return read_robot_type_text(content_of(file), file.string());
}

TEST(RobotTypes, OfTheRepositoryCanAllBeRead) {
  int types = 0;
  for (const auto& entry : std::filesystem::directory_iterator(in_checkout("scenarios/robots"))) {
    EXPECT_FALSE(read_robot_type(entry.path()).empty()) << entry.path();
    ++types;
  }
  EXPECT_GE(types, 3);
}

TEST(RobotTypes, PaperHasTheDefaultValues) {
  const RobotChanges paper = read_robot_type(in_checkout("scenarios/robots/paper.yaml"));
  sim::RobotSpec robot;
  std::size_t settings = 0;
  for (const Setting& setting : settings_of(robot, "")) {
    if (is_alias(setting)) continue;
    ++settings;
    ASSERT_TRUE(paper.contains(setting.path)) << setting.path;
    EXPECT_EQ(paper.at(setting.path), current_value(setting)) << setting.path;
  }
  EXPECT_EQ(paper.size(), settings);
}

}  // namespace
}  // namespace autoref::game
