#include "game/settings/fields.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

namespace autoref::game {
namespace {

std::string refusal_of_value(std::string_view path, std::string_view text) {
  GameSettings game;
  try {
    set_by_path(game, path, text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(SetByPath, ReachesEveryPartOfAGame) {
  GameSettings game;
  set_by_path(game, "match.half_s", "60");
  set_by_path(game, "teams.a.robots", "5");
  set_by_path(game, "sim.camera", "realistic");
  set_by_path(game, "field.defence_area.shape", "box");
  set_by_path(game, "seed", "7");
  EXPECT_EQ(game.match.half_s, 60);
  EXPECT_EQ(game.a.robots, 5);
  EXPECT_EQ(game.field.defence_area.shape, DefenceArea::Shape::kBox);
  EXPECT_EQ(game.seed, 7U);
  EXPECT_EQ(game.sim.vision.ball_noise_m, 0.0014);
  EXPECT_FALSE(game.sim.vision.reports_height);
  EXPECT_EQ(game.sim.radio.command_loss, 0.03);
  EXPECT_EQ(value_at(game, "sim.camera"), "realistic");
  set_by_path(game, "sim.vision.reports_height", "true");
  EXPECT_EQ(value_at(game, "sim.camera"), "other");
}

TEST(SetByPath, AcceptsAAndBForTheTeams) {
  GameSettings game;
  set_by_path(game, "a.robots", "4");
  set_by_path(game, "b.strategy", "dummy");
  EXPECT_EQ(game.a.robots, 4);
  EXPECT_EQ(game.b.strategy, "dummy");
}

TEST(SetByPath, SetsBothFactorsWithAHandicap) {
  GameSettings game;
  set_by_path(game, "b.handicap", "0.8");
  EXPECT_EQ(game.b.speed_factor, 0.8);
  EXPECT_EQ(game.b.acceleration_factor, 0.8);
  EXPECT_EQ(game.a.speed_factor, 1.0);
}

TEST(SetByPath, SetsTheBallsValuesWithAPreset) {
  GameSettings game;
  set_by_path(game, "sim.ball.preset", "tigers");
  EXPECT_EQ(game.sim.ball.slide_mps2, 3.0);
  EXPECT_EQ(game.sim.ball.hop_later_xy, 0.85);
  EXPECT_EQ(value_at(game, "sim.ball.preset"), "tigers");
  EXPECT_EQ(refusal_of_value("sim.ball.preset", "tiger"),
            "expected a file such as measured.yaml, or one of default, erforce, tigers, grsim, "
            "rc2026, found 'tiger'; did you mean 'tigers'?");
}

TEST(SetByPath, SuggestsThePathsThatEndWithAnUnknownOne) {
  EXPECT_EQ(refusal_of_value("half_s", "60"), "unknown key 'half_s'; did you mean 'match.half_s'?");
  EXPECT_EQ(refusal_of_value("robots", "5"),
            "unknown key 'robots'; did you mean 'a.robots' or 'b.robots'?");
  EXPECT_EQ(refusal_of_value("defence_area.shape", "box"),
            "unknown key 'defence_area.shape'; did you mean 'field.defence_area.shape'?");
  EXPECT_EQ(refusal_of_value("speed_mps", "2"),
            "unknown key 'speed_mps'; did you mean 'a.robot.speed_mps', 'b.robot.speed_mps' or "
            "'sim.robot.speed_mps'?");
  EXPECT_EQ(refusal_of_value("shot_mps", "6"),
            "unknown key 'shot_mps'; did you mean 'a.params.shot_mps' or 'b.params.shot_mps'?");
}

TEST(SetByPath, SuggestsThePathsWhoseLastNameIsNear) {
  EXPECT_EQ(refusal_of_value("halfs", "60"), "unknown key 'halfs'; did you mean 'match.half_s'?");
  EXPECT_EQ(refusal_of_value("mtach.half_s", "60"),
            "unknown key 'mtach.half_s'; did you mean 'match.half_s'?");
}

TEST(SetByPath, SuggestsTheWordsThatBeginLikeAnUnknownOne) {
  const auto ends = [](std::string_view path, std::string_view text, const char* end) {
    EXPECT_TRUE(refusal_of_value(path, text).ends_with(end)) << refusal_of_value(path, text);
  };
  ends("match.rules", "2026", "; did you mean '2026-b' or '2026-a'?");
  ends("sim.camera", "rc2026", "; did you mean 'rc2026-b' or 'rc2026-a'?");
  ends("b.strategy", "co", "; did you mean 'cobalt', 'cobalt1' or 'counter'?");
  ends("match.control", "game", "; did you mean 'game-controller'?");
}

TEST(SetByPath, LetsSingleSettingsOverrideAPreset) {
  GameSettings game;
  set_by_path(game, "sim.ball.preset", "grsim");
  set_by_path(game, "sim.ball.roll_mps2", "0.5");
  EXPECT_EQ(game.sim.ball.slide_mps2, 10.3);
  EXPECT_EQ(game.sim.ball.roll_mps2, 0.5);
  EXPECT_EQ(value_at(game, "sim.ball.preset"), "other");
}

TEST(SetByPath, SetsAStrategysParameters) {
  GameSettings game;
  set_by_path(game, "a.params.shot_mps", "6.5");
  EXPECT_EQ(game.a.params.at("shot_mps"), 6.5);
}

TEST(SetByPath, NamesTheNearestKeyForAnUnknownOne) {
  EXPECT_NE(refusal_of_value("match.half", "60").find("'match.half_s'"), std::string::npos);
  EXPECT_NE(refusal_of_value("b.robot", "5").find("'b.robots'"), std::string::npos);
  EXPECT_NE(refusal_of_value("params.x", "5").find("unknown key"), std::string::npos);
  EXPECT_NE(refusal_of_value("a.params", "5").find("unknown key"), std::string::npos);
}

TEST(SetByPath, SetsOverridesOfATeamsRobotsOrOfOneRobot) {
  GameSettings game;
  set_by_path(game, "b.robot.speed_mps", "2");
  set_by_path(game, "b.players.3.dribbler.preset", "perfect");
  EXPECT_EQ(value_at(game, "b.robot.speed_mps"), "2.0");
  EXPECT_EQ(value_at(game, "b.players.3.dribbler.preset"), "perfect");
  EXPECT_EQ(value_at(game, "b.players.3.dribbler.holds"), "true");
  EXPECT_TRUE(game.b.players.contains(3));
  EXPECT_TRUE(game.a.changes.empty());
}

TEST(SetByPath, NamesTheNearestKeyOfAPlayer) {
  EXPECT_NE(refusal_of_value("b.players.3.handicup", "1").find("'b.players.3.handicap'"),
            std::string::npos);
  EXPECT_NE(refusal_of_value("b.robot.speed", "1").find("'b.robot.speed_mps'"), std::string::npos);
  EXPECT_NE(refusal_of_value("b.players.3", "1").find("unknown key"), std::string::npos);
  EXPECT_NE(refusal_of_value("b.players", "1").find("unknown key"), std::string::npos);
  EXPECT_EQ(refusal_of_value("b.players.16.handicap", "1"),
            "expected a robot's number from 0 to 15, found '16'");
  EXPECT_EQ(refusal_of_value("b.robot.mass_kg", "0"),
            "expected a number from 0.001 to 100 kg, found '0'");
}

TEST(SetByPath, SaysWhatWasExpected) {
  EXPECT_EQ(refusal_of_value("a.robots", "17"), "expected a whole number from 1 to 16, found '17'");
  EXPECT_EQ(refusal_of_value("a.robots", "0"), "expected a whole number from 1 to 16, found '0'");
  EXPECT_EQ(refusal_of_value("b.speed_factor", "-1"),
            "expected a number above 0 and at most 2, found '-1'");
  EXPECT_EQ(refusal_of_value("match.a_plays", "north"),
            "expected one of west, east, found 'north'");
}

TEST(SetByPath, LeavesTheGameUnchangedIfItThrows) {
  GameSettings game;
  EXPECT_THROW(set_by_path(game, "b.handicap", "3"), std::invalid_argument);
  EXPECT_EQ(game.b.speed_factor, 1.0);
}

TEST(Settings, HaveUniquePathsAndDefaultsWithinTheirRanges) {
  GameSettings game;
  std::set<std::string> paths;
  for (const Setting& setting : settings_of(game)) {
    EXPECT_TRUE(paths.insert(setting.path).second) << setting.path;
    EXPECT_FALSE(setting.about.empty()) << setting.path;
    if (holds_others(setting)) continue;
    EXPECT_NO_THROW(assign(setting, value_of(setting))) << setting.path;
  }
}

TEST(Settings, AcceptTheirDefaultsAsAWhole) { EXPECT_NO_THROW(check_game(GameSettings{})); }

TEST(CheckGame, RefusesParametersThatTheStrategyDoesNotHave) {
  GameSettings game;
  game.a.params["shot_mpss"] = 1;
  try {
    check_game(game);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("'shot_mps'"), std::string::npos);
  }
}

// Box2D moves a body at most 0.2 m per step, so 30 steps per second cannot carry 8 m/s.
TEST(CheckGame, RefusesTooFewSubstepsForAKick) {
  GameSettings game;
  game.sim.frame_rate_hz = 30;
  game.sim.substeps = 2;
  EXPECT_NO_THROW(check_game(game));
  game.sim.substeps = 1;
  try {
    check_game(game);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_TRUE(std::string_view(error.what()).starts_with("sim.substeps: ")) << error.what();
  }
}

TEST(ConfigurationHash, ChangesWithSettingsOfEachBranch) {
  const std::uint64_t plain = configuration_hash(GameSettings{});
  for (const auto& [path, text] :
       std::map<std::string, std::string>{{"a.robots", "5"},
                                          {"b.robots", "5"},
                                          {"match.half_s", "599"},
                                          {"match.a_plays", "east"},
                                          {"match.first_kickoff", "east"},
                                          {"field.goal_width_m", "0.71"},
                                          {"sim.robot.mass_kg", "2.6"},
                                          {"sim.dribbler.preset", "perfect"},
                                          {"b.robot.mass_kg", "2.6"},
                                          {"b.players.3.robot.mass_kg", "2.6"},
                                          {"b.players.3.handicap", "0.9"},
                                          {"a.players.0.dribbler.preset", "perfect"},
                                          {"a.params.shot_mps", "0"},
                                          {"b.params.shot_mps", "0"},
                                          {"seed", "43"}}) {
    GameSettings game;
    set_by_path(game, path, text);
    EXPECT_NE(configuration_hash(game), plain) << path;
  }
}

TEST(ConfigurationHash, DistinguishesTeamsFromPlayers) {
  std::set<std::uint64_t> hashes;
  for (const char* branch : {"a.", "b.", "a.players.1.", "a.players.2.", "b.players.1."}) {
    GameSettings game;
    set_by_path(game, std::string(branch) + "kicker.reach_m", "0.02");
    hashes.insert(configuration_hash(game));
  }
  EXPECT_EQ(hashes.size(), 5U);
}

TEST(ConfigurationHash, DistinguishesTheTeams) {
  GameSettings left;
  left.a.params["shot_mps"] = 5;
  GameSettings right;
  right.b.params["shot_mps"] = 5;
  EXPECT_NE(configuration_hash(left), configuration_hash(right));
}

// The world accepts both ends of the ranges documented for users, and refuses values below them.
TEST(Settings, OfTheWorldAreValidAtBothEndsOfTheirRanges) {
  GameSettings game;
  int checked = 0;
  for (const Setting& setting : settings_of(game)) {
    auto* const* number = std::get_if<double*>(&setting.target);
    if (number == nullptr || !setting.path.starts_with("sim.")) continue;
    const double usual = **number;
    **number = setting.range.high;
    EXPECT_NO_THROW(check_game(game)) << setting.path << " at " << **number;
    **number = setting.range.above_low ? setting.range.low : setting.range.low - 1e-6;
    EXPECT_THROW(check_game(game), std::invalid_argument) << setting.path << " at " << **number;
    if (!setting.range.above_low) {
      **number = setting.range.low;
      EXPECT_NO_THROW(check_game(game)) << setting.path << " at " << **number;
    }
    **number = usual;
    ++checked;
  }
  EXPECT_GT(checked, 30);
}

}  // namespace
}  // namespace autoref::game
