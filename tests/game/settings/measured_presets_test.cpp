// Presets of ball and camera from files, and how scenarios, sweeps and flags name them.
#include "game/settings/measured_presets.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "experiments/kinds/judge/judge_schedule.hpp"
#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/kinds/sweep/sweep.hpp"
#include "experiments/schedule/schedule.hpp"
#include "io/errors.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::game {
namespace {

const std::string kHead = "schema: 1\nkind: measured\n";
const std::string kGame = "schema: 1\nkind: game\n";
const std::string kSweep = "schema: 1\nkind: sweep\npairs: 1\nseed: 1\n";

// A folder with a scenario and, in a subfolder, a measured game.
class ScenarioWithPresets : public testing::Test {
 protected:
  ScenarioWithPresets() {
    std::filesystem::create_directory(folder_ / "games");
    write_content(folder_ / "games/mine.yaml", kHead +
                                                   "about: A game.\n"
                                                   "ball: { roll_mps2: 0.31 }\n"
                                                   "contacts: { wall_restitution: 0.41 }\n"
                                                   "frame_rate_hz: 73.2\n"
                                                   "vision: { ball_noise_m: 0.0008 }\n"
                                                   "radio: { command_loss: 0.07 }\n");
    write_content(folder_ / "games/ball.yaml", kHead + "ball: { roll_mps2: 0.25 }\n");
    write_content(folder_ / "games/camera.yaml", kHead + "frame_rate_hz: 80\n");
  }
  experiments::Scenario read(const std::string& text, const Assignments& assignments = {}) const {
    write_content(folder_ / "x.yaml", text);
    return experiments::read_scenario(folder_ / "x.yaml", assignments);
  }
  GameSettings game(const std::string& text, const Assignments& assignments = {}) const {
    return std::get<GameSettings>(read(kGame + text, assignments).content);
  }
  // The games of a sweep over these factors, with each pair's second game left out.
  std::vector<GameSettings> games(const std::string& text) const {
    std::vector<GameSettings> all;
    for (const experiments::ScheduledGame& game :
         read(kSweep + text).as<experiments::Sweep>()->games()) {
      if (game.id.ends_with("-1")) all.push_back(game.settings.combined());
    }
    return all;
  }
  std::string refusal(const std::string& text) const {
    try {
      read(kGame + text);
      return "accepted";
    } catch (const io::InputError& error) {
      return error.what();
    }
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  TemporaryFolder folder_;
};

TEST_F(ScenarioWithPresets, SetsBallAndContactsFromAFileRelativeToItself) {
  const GameSettings it = game("sim: { ball: { preset: games/mine.yaml } }\n");
  EXPECT_EQ(it.sim.ball.roll_mps2, 0.31);
  EXPECT_EQ(it.sim.contacts.wall_restitution, 0.41);
  EXPECT_EQ(it.sim.ball.slide_mps2, sim::BallParameters{}.slide_mps2);
  EXPECT_EQ(it.sim.frame_rate_hz, 60);
}

TEST_F(ScenarioWithPresets, SetsVisionFrameRateAndRadioFromAFile) {
  const GameSettings it = game("sim: { camera: games/mine.yaml }\n");
  EXPECT_EQ(it.sim.vision.ball_noise_m, 0.0008);
  EXPECT_EQ(it.sim.frame_rate_hz, 73.2);
  EXPECT_EQ(it.sim.radio.command_loss, 0.07);
  EXPECT_EQ(it.sim.latency_s, sim::Configuration{}.latency_s);
  EXPECT_EQ(it.sim.ball.roll_mps2, sim::BallParameters{}.roll_mps2);
}

TEST_F(ScenarioWithPresets, AcceptsAWordInPlaceOfABranch) {
  const GameSettings it = game(
      "sim: { ball: games/mine.yaml, camera: games/mine.yaml, kicker: rc2026 }\n"
      "teams: { b: { dribbler: perfect, players: { 2: { kicker: default } } } }\n");
  EXPECT_EQ(it.sim.ball.roll_mps2, 0.31);
  EXPECT_EQ(it.sim.frame_rate_hz, 73.2);
  EXPECT_EQ(value_at(it, "sim.kicker.preset"), "rc2026");
  EXPECT_EQ(value_at(it, "b.dribbler.preset"), "perfect");
  EXPECT_EQ(value_at(it, "b.players.2.kicker.preset"), "default");
}

TEST_F(ScenarioWithPresets, AcceptsTheNameOfAKnownBallInPlaceOfTheBranch) {
  EXPECT_EQ(game("sim: { ball: tigers }\n").sim.ball.slide_mps2, 3.0);
}

TEST_F(ScenarioWithPresets, LetsGivenSettingsOverrideTheFileInAnyOrder) {
  for (const char* text :
       {"sim: { contacts: { wall_restitution: 0.5 }, vision: { ball_noise_m: 0.002 }, ball: "
        "games/mine.yaml, camera: games/mine.yaml }\n",
        "sim: { camera: games/mine.yaml, ball: games/mine.yaml, vision: { ball_noise_m: 0.002 }, "
        "contacts: { wall_restitution: 0.5 } }\n"}) {
    const GameSettings it = game(text);
    EXPECT_EQ(it.sim.contacts.wall_restitution, 0.5);
    EXPECT_EQ(it.sim.vision.ball_noise_m, 0.002);
    EXPECT_EQ(it.sim.ball.roll_mps2, 0.31);
  }
}

TEST_F(ScenarioWithPresets, LetsASettingOfTheFilesBranchOverrideTheFile) {
  const GameSettings it = game("sim: { ball: { roll_mps2: 0.2, preset: games/mine.yaml } }\n");
  EXPECT_EQ(it.sim.ball.roll_mps2, 0.2);
  EXPECT_EQ(it.sim.contacts.wall_restitution, 0.41);
}

TEST_F(ScenarioWithPresets, ReplacesThePresetOfTheFileByThatOfAFlag) {
  const Assignments flags = {{"--set", "sim.ball", file("games/ball.yaml")}};
  const GameSettings it = game("sim: { ball: games/mine.yaml }\n", flags);
  EXPECT_EQ(it.sim.ball.roll_mps2, 0.25);
  EXPECT_EQ(it.sim.contacts.wall_restitution, sim::ContactParameters{}.wall_restitution);
  const Assignments known = {{"--set", "sim.ball", "tigers"}};
  EXPECT_EQ(game("sim: { ball: games/mine.yaml }\n", known).sim.contacts.wall_restitution,
            sim::ContactParameters{}.wall_restitution);
}

TEST_F(ScenarioWithPresets, ResolvesAFlagsPathInTheGivenFolder) {
  GameSettings it;
  set_by_path(it, "sim.ball", "games/mine.yaml", folder_.path());
  set_by_path(it, "sim.camera", "games/camera.yaml", folder_.path());
  EXPECT_EQ(it.sim.ball.roll_mps2, 0.31);
  EXPECT_EQ(it.sim.frame_rate_hz, 80);
}

TEST_F(ScenarioWithPresets, IsReproducedFromItsEffectiveText) {
  const experiments::Scenario scenario =
      read(kGame + "sim: { ball: games/mine.yaml, camera: games/mine.yaml }\n");
  const std::string text = experiments::effective_text(scenario);
  EXPECT_EQ(text.find("mine"), std::string::npos);
  const experiments::Scenario back =
      experiments::read_scenario_text(text, "elsewhere/effective.yaml");
  EXPECT_EQ(configuration_hash(std::get<GameSettings>(back.content)),
            configuration_hash(std::get<GameSettings>(scenario.content)));
}

TEST_F(ScenarioWithPresets, HasAHashOfValuesNotNames) {
  const std::uint64_t hash = configuration_hash(game("sim: { ball: games/ball.yaml }\n"));
  EXPECT_EQ(configuration_hash(game("sim: { ball: { roll_mps2: 0.25 } }\n")), hash);
  EXPECT_NE(configuration_hash(game("")), hash);
}

TEST_F(ScenarioWithPresets, HasASweepWhoseGamesDoNotDependOnTheOrderOfPresets) {
  const std::string base = "base: { sim: { camera: rc2026-b } }\n";
  const std::vector<GameSettings> one =
      games(base + "factors: { sim.ball: [games/mine.yaml, grsim] }\n");
  const std::vector<GameSettings> other =
      games(base + "factors: { sim.ball: [grsim, games/mine.yaml] }\n");
  ASSERT_EQ(one.size(), 2U);
  ASSERT_EQ(other.size(), 2U);
  EXPECT_EQ(one[0].sim.contacts.wall_restitution, 0.41);
  EXPECT_EQ(one[1].sim.contacts.wall_restitution, sim::ContactParameters{}.wall_restitution);
  EXPECT_EQ(configuration_hash(one[0]), configuration_hash(other[1]));
  EXPECT_EQ(configuration_hash(one[1]), configuration_hash(other[0]));
}

TEST_F(ScenarioWithPresets, HasItsSweepReproducedFromTheEffectiveText) {
  const experiments::Scenario scenario =
      read(kSweep +
           "base: { sim: { camera: rc2026-b } }\n"
           "factors:\n  sim.camera: [games/camera.yaml, realistic, games/mine.yaml]\n"
           "  sim.ball: [tigers, games/mine.yaml]\n");
  const experiments::Scenario back = experiments::read_scenario_text(
      experiments::effective_text(scenario), "elsewhere/effective.yaml");
  EXPECT_EQ(experiments::effective_text(back), experiments::effective_text(scenario));
  const std::vector<experiments::ScheduledGame> games = scenario.as<experiments::Sweep>()->games();
  const std::vector<experiments::ScheduledGame> games_back = back.as<experiments::Sweep>()->games();
  ASSERT_EQ(games.size(), 12U);
  ASSERT_EQ(games_back.size(), games.size());
  EXPECT_EQ(games[0].id, "sim.camera=camera+sim.ball=tigers-p0001-1");
  for (std::size_t i = 0; i < games.size(); ++i) {
    EXPECT_EQ(games_back[i].id, games[i].id);
    EXPECT_EQ(configuration_hash(games_back[i].settings.combined()),
              configuration_hash(games[i].settings.combined()));
  }
}

TEST_F(ScenarioWithPresets, HasASweepThatRefusesAFlagForAVariedPreset) {
  try {
    read(kSweep + "factors: { sim.ball: [tigers, games/mine.yaml] }\n",
         {{"--set sim.ball.preset=grsim", "sim.ball.preset", "grsim"}});
    FAIL() << "was accepted";
  } catch (const io::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("the file varies this setting"), std::string::npos);
  }
}

TEST_F(ScenarioWithPresets, JudgesGamesWithCamerasFromFiles) {
  const experiments::Scenario scenario = read(
      "schema: 1\nkind: judge\ncameras: [none, games/mine.yaml]\n"
      "matchups: [basic~basic]\ngames: 1\nseed: 1\n");
  const auto back = experiments::read_scenario_text(experiments::effective_text(scenario), "e");
  EXPECT_EQ(back.as<experiments::JudgeSchedule>()->cameras,
            (std::vector<std::string>{"none", "mine"}));
}

TEST_F(ScenarioWithPresets, NamesItsOwnLocationForAFileThatCannotBeRead) {
  const std::string message = refusal("sim: { camera: games/lost.yaml }\n");
  EXPECT_TRUE(message.starts_with(file("x.yaml") + ":3:16: sim.camera: ")) << message;
  EXPECT_NE(message.find("games/lost.yaml: the file cannot be read"), std::string::npos) << message;
}

TEST_F(ScenarioWithPresets, RefusesAnUnknownPreset) {
  const std::string message = refusal("sim: { ball: mine }\n");
  EXPECT_EQ(message, file("x.yaml") +
                         ":3:14: sim.ball.preset: expected a file such as measured.yaml, or one of "
                         "default, erforce, tigers, grsim, rc2026, found 'mine'");
}

TEST_F(ScenarioWithPresets, RefusesAFileWithoutTheValuesThatItIsGivenFor) {
  const std::string camera = refusal("sim: { camera: games/ball.yaml }\n");
  EXPECT_TRUE(camera.starts_with(file("x.yaml") + ":3:16: sim.camera: ")) << camera;
  EXPECT_TRUE(
      camera.ends_with("games/ball.yaml has no values for the camera; expected one of "
                       "frame_rate_hz, latency_s, vision, radio"))
      << camera;
  const std::string ball = refusal("sim: { ball: games/camera.yaml }\n");
  EXPECT_TRUE(ball.ends_with("has no values for the ball; expected one of ball, contacts")) << ball;
}

TEST_F(ScenarioWithPresets, NamesTheFilesLocationForAnErrorInIt) {
  write_content(folder_ / "games/mine.yaml", kHead + "vision: { noise: 0 }\n");
  const std::string message = refusal("sim: { camera: games/mine.yaml }\n");
  EXPECT_TRUE(message.starts_with(file("games/mine.yaml") + ":3:11: vision: unknown key 'noise'"))
      << message;
}

TEST_F(ScenarioWithPresets, RefusesAFileWithTheNameOfAKnownPreset) {
  write_content(folder_ / "games/tigers.yaml", kHead + "ball: {}\n");
  const std::string message = refusal("sim: { ball: games/tigers.yaml }\n");
  EXPECT_TRUE(message.ends_with(
      "another preset is already called 'tigers'; rename the file games/tigers.yaml"))
      << message;
}

TEST_F(ScenarioWithPresets, IsNotAMeasuredGame) {
  write_content(folder_ / "x.yaml", kHead);
  EXPECT_THROW(experiments::read_scenario(folder_ / "x.yaml"), io::InputError);
}

struct MeasuredMistake {
  const char* name;
  std::string text;
  const char* message;  // start of the message
};

class WrongMeasuredFile : public testing::TestWithParam<MeasuredMistake> {};

TEST_P(WrongMeasuredFile, IsRefusedWithItsLocation) {
  try {
    read_measured_text(GetParam().text, "m.yaml");
    FAIL() << "was accepted";
  } catch (const io::InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with(GetParam().message)) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(
    Files, WrongMeasuredFile,
    testing::Values(
        MeasuredMistake{"OtherKind", kGame, "m.yaml:2:7: kind: expected measured, found 'game'"},
        MeasuredMistake{"UnknownSection", kHead + "wheels: {}\n",
                        "m.yaml:3:1: unknown key 'wheels'"},
        MeasuredMistake{"OtherSettingOfTheWorld", kHead + "substeps: 4\n",
                        "m.yaml:3:1: unknown key 'substeps'"},
        MeasuredMistake{"OtherSettingOfTheRadio", kHead + "radio: { hold_s: 1 }\n",
                        "m.yaml:3:10: radio: unknown key 'hold_s'"},
        MeasuredMistake{"Number", kHead + "vision: 5\n", "m.yaml:3:9: vision: expected a mapping"},
        MeasuredMistake{"Word", kHead + "frame_rate_hz: fast\n",
                        "m.yaml:3:16: frame_rate_hz: expected a number from 30 to 240"},
        MeasuredMistake{"Range", kHead + "ball: { roll_mps2: -1 }\n",
                        "m.yaml:3:20: ball.roll_mps2: expected a number above 0"},
        MeasuredMistake{"OtherFile", kHead + "ball: { preset: other.yaml }\n",
                        "m.yaml:3:17: ball.preset: expected one of default, erforce"},
        MeasuredMistake{"About", kHead + "about: [1]\n", "m.yaml:3:8: about: expected a sentence"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace autoref::game
