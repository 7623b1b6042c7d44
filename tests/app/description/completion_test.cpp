// What `autoref complete` proposes.
#include "app/description/completion.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "game/team_programs/team_templates.hpp"
#include "io/errors.hpp"
#include "sim/presets.hpp"
#include "soccer/rules/rule_book.hpp"
#include "strategies/registry.hpp"
#include "tests/app/answer.hpp"
#include "tests/checkout.hpp"
#include "tests/experiments/kinds/situations/small_situations.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

using Words = std::vector<std::string>;

// The words proposed for the last of `words`.
Words proposed(std::vector<const char*> words) {
  words.insert(words.begin(), "complete");
  const Answer answer = answer_to(words);
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  Words proposed;
  std::istringstream lines(answer.out);
  for (std::string line; std::getline(lines, line);)
    proposed.push_back(line.substr(0, line.find('\t')));
  return proposed;
}

bool contains(const Words& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

TEST(Complete, ProposesVerbsAndOptions) {
  EXPECT_EQ(proposed({"pl"}), Words{"play"});
  EXPECT_EQ(proposed({"team", "n"}), Words{"new"});
  EXPECT_EQ(proposed({"play", "--ev"}), Words{"--events"});
  EXPECT_EQ(proposed({"view", "game.log.gz", "--fr"}), Words{"--from"});
  EXPECT_FALSE(contains(proposed({""}), "complete")) << "it is not for people";
}

TEST(Complete, AddsDescriptions) {
  EXPECT_EQ(answer_to({"complete", "vie"}).out, "view\tTurn a recorded game into an HTML page.\n");
}

TEST(Complete, ProposesVerbsAfterHelp) {
  EXPECT_EQ(proposed({"help", "pl"}), Words{"play"});
  EXPECT_EQ(proposed({"help", "team", ""}), (Words{"new", "play", "check"}));
  EXPECT_EQ(proposed({"help", "play", ""}), Words{});
}

TEST(Complete, ProposesSettingsStepByStep) {
  EXPECT_EQ(proposed({"play", "x.yaml", "--set", "ma"}), Words{"match."});
  EXPECT_EQ(proposed({"play", "x.yaml", "--set", "match.half_"}), Words{"match.half_s="});
  EXPECT_EQ(proposed({"play", "x.yaml", "--set=match.half_"}), Words{"--set=match.half_s="});
  EXPECT_EQ(proposed({"run", "--set", "teams.b.handi"}), Words{"teams.b.handicap="});
  EXPECT_EQ(proposed({"run", "--set", "b.players.3.handi"}), Words{"b.players.3.handicap="});
  EXPECT_EQ(proposed({"run", "--set", "a.params.shot_m"}), Words{"a.params.shot_mps="});
  EXPECT_TRUE(contains(proposed({"run", "--set", ""}), "sim."));
}

TEST(Complete, ProposesTheWordsThatASettingAllows) {
  EXPECT_EQ(proposed({"run", "--set", "match.rules=2026"}),
            (Words{"match.rules=2026-b", "match.rules=2026-a"}));
  EXPECT_EQ(proposed({"run", "--set", "match.knockout=t"}), Words{"match.knockout=true"});
  EXPECT_EQ(proposed({"run", "--set", "match.half_s="}), Words{});
  EXPECT_EQ(proposed({"run", "--set", "nosuch="}), Words{});
}

TEST(Complete, ProposesWhatTheRegistriesHold) {
  Words teams;
  for (const strategies::Entry& team : strategies::all_strategies()) teams.emplace_back(team.name);
  EXPECT_EQ(proposed({"show", "teams", ""}), teams);
  EXPECT_EQ(proposed({"team", "play", "--opponent", ""}), teams);
  EXPECT_EQ(proposed({"show", "rules", ""}), rule_book_names());
  EXPECT_EQ(proposed({"view", "x.log", "--rules", ""}), rule_book_names());
  EXPECT_EQ(proposed({"referee", "log", "--camera", ""}), sim::camera_preset_names());
  EXPECT_EQ(proposed({"team", "new", "--language", ""}), game::template_languages());
  EXPECT_EQ(proposed({"show", "completion", ""}), (Words{"bash", "zsh", "fish"}));
  EXPECT_EQ(proposed({"referee", "log", "--first-kickoff", ""}), (Words{"west", "east"}));
  EXPECT_EQ(proposed({"live", "x.yaml", "--speed", ""}), (Words{"max", "lockstep"}));
}

// In a folder of its own.
class CompleteHere : public testing::Test {
 protected:
  CompleteHere() { std::filesystem::current_path(folder_.path()); }
  ~CompleteHere() override { std::filesystem::current_path(before_); }

  std::filesystem::path before_ = std::filesystem::current_path();
  TemporaryFolder folder_;
};

TEST_F(CompleteHere, ProposesScenarios) {
  std::filesystem::create_directories(folder_ / "scenarios/lab");
  for (const char* file : {"mine.yaml", "notes.txt", "scenarios/cup.yaml", "scenarios/lab/a.yaml"})
    write_content(folder_ / file, "");
  for (const char* verb : {"play", "run", "judge", "check", "live"}) {
    EXPECT_EQ(proposed({verb, ""}),
              (Words{"mine.yaml", "scenarios/cup.yaml", "scenarios/lab/a.yaml"}))
        << verb;
  }
  for (const char* former : {"lab", "submit", "tune"})
    EXPECT_EQ(proposed({former, ""}), proposed({"play", ""})) << former;
  for (const char* verb : {"lab", "submit"})
    EXPECT_EQ(proposed({"experiment", verb, ""}), proposed({"play", ""})) << verb;
  EXPECT_EQ(proposed({"show", "situation", "m"}), Words{"mine.yaml"});
  EXPECT_EQ(proposed({"play", "cu"}), Words{"cup.yaml"}) << "play finds it in scenarios";
  EXPECT_EQ(proposed({"play", "nowhere/"}), Words{});
}

TEST_F(CompleteHere, ProposesTheSituationsOfAScenario) {
  write_content(folder_ / "few.yaml", experiments::kSmallSituations);
  EXPECT_EQ(proposed({"show", "situation", "few.yaml", "g"}), Words{"goal"});
  EXPECT_EQ(proposed({"show", "situation", "nowhere.yaml", ""}), Words{});
}

TEST_F(CompleteHere, ProposesTheGamesOfAFolder) {
  std::filesystem::create_directories(folder_ / "cup/games");
  write_content(folder_ / "cup/games/shard-0-of-1.csv", "game_id,seed\na~b-p0002-1,1\nc~d-1,2\n");
  EXPECT_EQ(proposed({"results", "replay", "cup", ""}), (Words{"a~b-p0002-1", "c~d-1"}));
  write_content(folder_ / "cup/results.csv", "game_id,seed\na~b-p0001-1,1\n");
  EXPECT_EQ(proposed({"replay", "cup", ""}), Words{"a~b-p0001-1"});
  EXPECT_EQ(proposed({"results", "replay", "cup", "a"}), Words{"a~b-p0001-1"});
  EXPECT_EQ(proposed({"results", "replay", "nowhere", ""}), Words{});
}

TEST_F(CompleteHere, LimitsHowManyGamesItProposes) {
  std::string rows = "game_id,seed\n";
  for (int i = 0; i < 1000; ++i) rows += fmt::format("a~b-p{:04}-1,1\n", i);
  write_content(folder_ / "results.csv", rows);
  EXPECT_EQ(proposed({"results", "replay", ".", ""}).size(), 200U);
  EXPECT_EQ(proposed({"results", "replay", ".", "a~b-p0999"}), Words{"a~b-p0999-1"});
}

TEST_F(CompleteHere, IsSilentAboutLinesThatMakeNoSense) {
  for (const auto& words :
       std::vector<std::vector<const char*>>{{"complete"},
                                             {"complete", "nosuch", ""},
                                             {"complete", "play", "--nosuch", "a", "b", ""},
                                             {"complete", "--"},
                                             {"complete", "play", "--set", "a.players.99.x"},
                                             {"complete", "play", "--nosuch="},
                                             {"complete", "help", "nosuch", ""}}) {
    const Answer answer = answer_to(words);
    EXPECT_EQ(answer.code, io::kDone);
    EXPECT_EQ(answer.err, "");
  }
}

}  // namespace
}  // namespace autoref::app
