// Files that would make a careless reader loop forever or exhaust its memory: every YAML reader
// refuses them promptly and reports the location.
#include <gtest/gtest.h>

#include <functional>

#include "experiments/kinds/roundrobin/roundrobin.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "game/lab/lab.hpp"
#include "game/settings/measured_presets.hpp"
#include "game/settings/robot_types.hpp"
#include "io/command.hpp"
#include "io/errors.hpp"

namespace autoref::experiments {
namespace {

constexpr double kSoon_s = AUTOREF_LONGEST_REFUSAL_S;  // processor time; normally far below 1 s

std::string copies_of(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

std::string laughing_document() {
  std::string text = "a0: &a0 [ha, ha]\n";
  for (int i = 1; i < 30; ++i) {
    const std::string before = "*a" + std::to_string(i - 1);
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + before + ", " + before +
            ", " + before + "]\n";
  }
  return text;
}

// `count` keys "NAME0: {}", separated by commas.
std::string keys(const std::string& name, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += name + std::to_string(i) + ": {}, ";
  return text;
}

// The reader's error message, or "accepted".
std::string refusal_of(const std::function<void()>& read) {
  const double began_s = io::processor_s_of(RUSAGE_SELF);
  std::string refusal = "accepted";
  try {
    read();
  } catch (const io::InputError& error) {
    refusal = error.what();
  }
  EXPECT_LT(io::processor_s_of(RUSAGE_SELF) - began_s, kSoon_s);
  return refusal;
}

struct Hostile {
  const char* name;
  std::string text;   // after schema and kind
  const char* start;  // start of the message
  const char* remedy;
};

class HostileFile : public testing::TestWithParam<Hostile> {
 protected:
  static void expect_refused(const std::string& refusal) {
    EXPECT_TRUE(refusal.starts_with(GetParam().start)) << refusal;
    EXPECT_NE(refusal.find(GetParam().remedy), std::string::npos) << refusal;
    EXPECT_LT(refusal.size(), 300U);
  }
};

TEST_P(HostileFile, IsRefusedAsAScenario) {
  const std::string text = "schema: 1\nkind: game\n" + GetParam().text;
  expect_refused(refusal_of([&] { read_scenario_text(text, "x.yaml"); }));
}

TEST_P(HostileFile, IsRefusedAsARobotType) {
  const std::string text = "schema: 1\nkind: robot\n" + GetParam().text;
  expect_refused(refusal_of([&] { game::read_robot_type_text(text, "x.yaml"); }));
}

TEST_P(HostileFile, IsRefusedAsAMeasuredPreset) {
  const std::string text = "schema: 1\nkind: measured\n" + GetParam().text;
  expect_refused(refusal_of([&] { game::read_measured_text(text, "x.yaml"); }));
}

TEST_P(HostileFile, IsRefusedAsALabScene) {
  const std::string text = "schema: 1\nkind: lab\n" + GetParam().text;
  expect_refused(refusal_of([&] { game::read_lab_scene_text(text, "x.yaml"); }));
}

TEST(HostileScenario, IsRefusedIfItBeginsWithAComma) {
  const std::string refusal =
      refusal_of([] { read_scenario_text(", schema: 1\nkind: game\n", "x.yaml"); });
  EXPECT_TRUE(refusal.starts_with("x.yaml:1:1: no value begins like this")) << refusal;
}

INSTANTIATE_TEST_SUITE_P(
    Files, HostileFile,
    testing::Values(
        Hostile{"AliasInItsOwnList", "about: &x [*x]\n", "x.yaml:3:12: ", "write out"},
        Hostile{"AliasInItsOwnMapping", "a: &x { b: *x }\n", "x.yaml:3:12: ", "write out"},
        Hostile{"BillionLaughs", laughing_document(), "x.yaml:", "leave the aliases out"},
        Hostile{"Brackets", "about: " + std::string(200'000, '[') + "\n", "x.yaml:3:", "closed"},
        Hostile{"Braces", "about: " + copies_of("{a: ", 50'000) + "\n", "x.yaml:3:", "closed"},
        Hostile{"Dashes", "about:\n" + copies_of("- ", 50'000) + "1\n", "x.yaml:4:", "closed"},
        Hostile{"HugeText", "about: " + std::string(1'000'000, 'a') + "\n",
                "x.yaml:3:8: ", "at most"},
        Hostile{"HugeKey", std::string(1'000, 'k') + ": 1\n", "x.yaml:3:1: ", "kkk..."},
        Hostile{"HugeFile", std::string(5'000'000, '\n'), "x.yaml: ", "at most"},
        Hostile{"HugeList", "about: [" + copies_of("1,", 400'000) + "]\n",
                "x.yaml:3:", "write fewer"}),
    [](const auto& hostile) { return std::string(hostile.param.name); });

TEST(HostileScenario, IsRefusedIfItHasTooManyTypes) {
  const std::string text = "schema: 1\nkind: game\ntypes: { " + keys("t", 1500) + "}\n";
  EXPECT_NE(
      refusal_of([&] { read_scenario_text(text, "x.yaml"); }).find("more than 1000 robot types"),
      std::string::npos);
}

TEST(HostileScenario, IsRefusedIfItHasTooManyPresets) {
  const std::string text =
      "schema: 1\nkind: game\nmeasured: { ball: { " + keys("p", 1500) + "} }\n";
  EXPECT_NE(refusal_of([&] { read_scenario_text(text, "x.yaml"); }).find("more than 1000 presets"),
            std::string::npos);
}

TEST(HostileScenario, IsRefusedIfItHasTooManyTeamsBeforeTheirMatchupsAreListed) {
  const std::string head = "schema: 1\nkind: roundrobin\npairs: 1\nseed: 1\n";
  const std::string text = head + "teams: { " + keys("t", 20'000) + "}\n";
  EXPECT_NE(refusal_of([&] {
              read_scenario_text(text, "x.yaml");
            }).find("399980000 games; one experiment may have at most 100000"),
            std::string::npos);
}

TEST(HostileScenario, IsRefusedIfItHasTooManyJudgedGames) {
  const std::string text =
      "schema: 1\nkind: judge\ngames: 9999\nseed: 1\nrules: [paper, 2014, 2014-double, 2026-b, "
      "2026-a]\ncameras: [none, paper, realistic]\n";
  EXPECT_NE(refusal_of([&] { read_scenario_text(text, "x.yaml"); })
                .find("games: these settings amount to 149985 games; one experiment may have at "
                      "most 100000"),
            std::string::npos);
}

TEST(ManyTeams, AreReadBackFromTheEffectiveFile) {
  const std::string head = "schema: 1\nkind: gauntlet\npairs: 1\nseed: 1\nteams: { zone: {} }\n";
  const Scenario scenario =
      read_scenario_text(head + "challengers: { " + keys("t", 200) + "}\n", "x");
  const std::string effective = effective_text(scenario);
  EXPECT_GT(effective.size(), 64U * 1024);
  EXPECT_EQ(effective_text(read_scenario_text(effective, "effective.yaml")), effective);
}

TEST(ManyTeams, AreRefusedIfTheyCouldNotBeReadBack) {
  RoundRobin robin;
  for (int i = 0; i < 20'000; ++i) robin.teams["t" + std::to_string(i)] = {};
  EXPECT_NE(refusal_of([&] {
              effective_text({"", robin});
            }).find("use fewer teams"),
            std::string::npos);
}

}  // namespace
}  // namespace autoref::experiments
