// Every scene of scenarios/lab can be read and played, and shows what it claims.
#include "game/lab/lab.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "io/csv.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"
#include "tests/checkout.hpp"
#include "tests/game/lab/lab_claims.hpp"

namespace autoref::game {
namespace {

std::set<std::string> scenes() {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(in_checkout("scenarios/lab"))) {
    if (entry.path().extension() == ".yaml") names.insert(entry.path().stem());
  }
  return names;
}

class LabClaim : public testing::TestWithParam<Claim> {};

TEST_P(LabClaim, IsWhatItsSceneShows) {
  EXPECT_NEAR(measured(GetParam()), GetParam().claimed, GetParam().tolerance);
}

INSTANTIATE_TEST_SUITE_P(Lab, LabClaim, testing::ValuesIn(lab_claims()),
                         [](const auto& test) { return test.param.name; });

TEST(LabTable, InTheReadmeIsWhatTheScenesShow) {
  const std::string table = lab_table();
  const std::string readme = io::read_file(in_checkout("sim/README.md")).value_or("");
  EXPECT_NE(readme.find(table), std::string::npos) << "sim/README.md should show this table:\n\n"
                                                   << table;
}

TEST(LabPlots, InTheReadmeShowEveryScene) {
  const std::string readme = io::read_file(in_checkout("sim/README.md")).value_or("");
  for (const std::string& name : scenes()) {
    const std::string file = "lab/" + name + ".svg";
    EXPECT_NE(readme.find(file), std::string::npos) << name;
    EXPECT_TRUE(std::filesystem::exists(in_checkout("sim/" + file))) << name;
  }
}

TEST(LabClaims, CoverEveryScene) {
  std::set<std::string> claimed;
  for (const Claim& claim : lab_claims()) claimed.insert(claim.scene);
  EXPECT_EQ(claimed, scenes());
}

TEST(LabCsv, HasARowPerFrameWithEveryObject) {
  for (const std::string& name : scenes()) {
    const LabScene scene = read_lab_scene(lab_file(name));
    const LabRecord record = play_lab_scene(scene);
    const std::string text = csv_of(scene, record);
    const auto lines = io::complete_lines(text);
    ASSERT_EQ(lines.size(), 1 + record.states.size()) << name;
    EXPECT_EQ(record.states.size(), 1 + std::lround(scene.duration_s * 60)) << name;
    for (const auto line : lines) {
      EXPECT_EQ(io::csv_cells(line)->size(), 9 + 7 * scene.robots.size()) << name;
    }
  }
}

const std::string kLab = "schema: 1\nkind: lab\nduration_s: 1\n";

TEST(LabScene, IsExactAndWithoutDelayUnlessItSaysOtherwise) {
  const LabScene scene = read_lab_scene_text(kLab, "x.yaml");
  EXPECT_EQ(scene.sim.latency_s, 0.0);
  EXPECT_EQ(scene.robot.body.speed_noise, 0.0);
  EXPECT_EQ(scene.robot.kicker.direction_noise_deg, 0.0);
  EXPECT_EQ(read_lab_scene_text(kLab + "sim: { latency_s: 0.04 }\n", "x").sim.latency_s, 0.04);
}

TEST(LabScene, ReadsRobotsWithTheirCommands) {
  const LabScene scene = read_lab_scene_text(
      kLab +
          "sim: { substeps: 8 }\n"
          "robots:\n"
          "  - { side: east, x_m: 1, heading_deg: 90, commands: [{ at_s: 0.5, kick_mps: 3 }] }\n"
          "  - { side: west }\n  - { side: east, vy_mps: 2 }\n",
      "x.yaml");
  ASSERT_EQ(scene.robots.size(), 3U);
  EXPECT_EQ(scene.sim.substeps, 8);
  EXPECT_NEAR(scene.robots[0].start.heading.y(), 1.0, 1e-12);
  EXPECT_EQ(scene.robots[0].commands.at(0).command.kick_mps, 3.0);
  EXPECT_EQ(scene.robots[2].id, (RobotId{Side::kEast, 1}));
}

TEST(LabScene, ChangesSpeedsLinearlyOverTheTimeOfACommand) {
  const LabScene scene = read_lab_scene_text(
      kLab +
          "sim: { robot: { acceleration_mps2: 20, wheel_acceleration_mps2: 20 } }\n"
          "robots:\n"
          "  - side: west\n"
          "    x_m: -2\n"
          "    commands:\n"
          "      - { at_s: 0, forward_mps: 1 }\n"
          "      - { at_s: 0.2, over_s: 0.5, forward_mps: 2 }\n"
          "  - { side: east, x_m: 2, y_m: 1, commands: [{ at_s: 0.2, over_s: 0.5, turn_radps: 4 }] "
          "}\n",
      "x.yaml");
  const LabRecord record = play_lab_scene(scene);
  const auto speed_mps = [&](std::size_t frame) {
    return record.states.at(frame).robots[Side::kWest][0].velocity_mps.norm();
  };
  EXPECT_NEAR(speed_mps(12), 1.0, 0.01);
  EXPECT_NEAR(speed_mps(28), 1.5, 0.01);  // commanded halfway in frame 27
  EXPECT_NEAR(speed_mps(60), 2.0, 0.01);
  EXPECT_NEAR(record.states[28].robots[Side::kEast][0].angular_velocity_radps, 2.0, 0.02);
}

TEST(LabScene, ReadsRobotTypesRelativeToItself) {
  const LabScene scene = read_lab_scene_text(
      kLab +
          "sim: { robot: { mass_kg: 3 } }\n"
          "robots: [{ side: east, type: ../robots/slow.yaml }, { side: east }]\n",
      in_checkout("scenarios/lab/x.yaml"));
  EXPECT_EQ(scene.robots[0].spec.body.speed_mps, 2.2);
  EXPECT_EQ(scene.robots[0].spec.body.mass_kg, 3.0);
  EXPECT_EQ(scene.robots[1].spec.body.speed_mps, 3.0);
}

struct Mistake {
  const char* name;
  std::string text;
  const char* start;
  const char* fragment;
};

class WrongLabScene : public testing::TestWithParam<Mistake> {};

TEST_P(WrongLabScene, IsRefusedWithItsLocationAndARemedy) {
  try {
    read_lab_scene_text(GetParam().text, "x.yaml");
    FAIL() << "was accepted";
  } catch (const io::InputError& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with(GetParam().start)) << message;
    EXPECT_NE(message.find(GetParam().fragment), std::string::npos) << message;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Files, WrongLabScene,
    testing::Values(
        Mistake{"OtherKind", "schema: 1\nkind: game\n", "x.yaml:2:7: kind: ", "expected lab"},
        Mistake{"NoDuration", "schema: 1\nkind: lab\n", "x.yaml:1:1: ", "'duration_s' is missing"},
        Mistake{"NoTime", "schema: 1\nkind: lab\nduration_s: 0\n",
                "x.yaml:3:13: duration_s: ", "above 0"},
        Mistake{"UnknownTopKey", kLab + "balls: {}\n", "x.yaml:4:1: ", "did you mean 'ball'"},
        Mistake{"UnknownBallKey", kLab + "ball: { x: 1 }\n", "x.yaml:4:9: ball: ", "'x_m'"},
        Mistake{"OffTheField", kLab + "ball: { x_m: 9 }\n", "x.yaml:4:14: ball.x_m: ", "found '9'"},
        Mistake{"UnknownSetting", kLab + "sim: { substep: 2 }\n",
                "x.yaml:4:8: sim: ", "'substeps'"},
        Mistake{"NoRoomForGoals", kLab + "field: { goal_width_m: 4, width_m: 4.2 }\n",
                "x.yaml:4:10: field.goal_width_m is 4", "at most 3.8"},
        Mistake{"NoList", kLab + "robots: { side: west }\n", "x.yaml:4:9: robots: ", "a list"},
        Mistake{"NoSide", kLab + "robots: [{ x_m: 1 }]\n", "x.yaml:4:10: robots[0]: ", "'side'"},
        Mistake{"NoSuchSide", kLab + "robots: [{ side: north }]\n",
                "x.yaml:4:18: robots[0].side: ", "west, east"},
        Mistake{"NoOrderTime", kLab + "robots: [{ side: west, commands: [{ chip: true }] }]\n",
                "x.yaml:4:35: robots[0].commands[0]: ", "'at_s' is missing"},
        Mistake{"OrdersBackwards",
                kLab + "robots: [{ side: west, commands: [{ at_s: 1 }, { at_s: 1 }] }]\n",
                "x.yaml:4:48: robots[0].commands[1]: ", "after"},
        Mistake{"NoSuchType", kLab + "robots: [{ side: west, type: slow }]\n",
                "x.yaml:4:30: robots[0].type: ", "a file such as"},
        Mistake{"NoSuchFile", kLab + "robots: [{ side: west, type: lost/slow.yaml }]\n",
                "x.yaml:4:30: robots[0].type: ", "lost/slow.yaml: the file cannot be read"},
        Mistake{"NoTruth", kLab + "ball: { rolls: 1 }\n",
                "x.yaml:4:16: ball.rolls: ", "true, false"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace autoref::game
