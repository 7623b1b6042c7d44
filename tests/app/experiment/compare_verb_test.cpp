// Tests `autoref compare` with games of a few seconds: how it names teams, what it prints, and its
// exit codes.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/experiment/comparison_arguments.hpp"
#include "app/experiment/team_argument.hpp"
#include "experiments/kinds/compare/comparison.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "io/errors.hpp"
#include "io/json.hpp"
#include "tests/app/answer.hpp"
#include "tests/support/has_part.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

namespace fs = std::filesystem;

// What the error says about the team; empty if there is none.
std::string fault_of(const std::string& team) {
  try {
    team_argument(team, "OLD");
  } catch (const io::InputError& error) {
    return error.what();
  }
  return {};
}

std::string setting_of(const TeamArgument& team, const std::string& path) {
  for (const game::Assignment& setting : team.settings)
    if (setting.path == path) return setting.value;
  return {};
}

TEST(TeamArgument, IsTheNameOfATeam) {
  EXPECT_EQ(setting_of(team_argument("cobalt", "OLD"), "strategy"), "cobalt");
  EXPECT_EQ(team_argument("cobalt", "OLD").name, "cobalt");
}

TEST(TeamArgument, IsACommand) {
  const TeamArgument team = team_argument("sh teams/my-team.sh --fast x", "OLD");
  EXPECT_EQ(setting_of(team, "command"), "sh teams/my-team.sh --fast x");
  EXPECT_EQ(team_argument("sh teams/my-team.sh --fast", "OLD").name, "my_team");
  EXPECT_FALSE(fault_of("sh 'my_team.sh").empty());
  EXPECT_EQ(setting_of(team_argument("./missing --fast", "OLD"), "command"), "./missing --fast");
  EXPECT_TRUE(has(fault_of("piton3 my_team.py"),
                  "OLD: cannot find the program 'piton3' of the command 'piton3 my_team.py' in"))
      << fault_of("piton3 my_team.py");
}

TEST(TeamArgument, IsAProgramThatCanBeExecutedOrAPythonFile) {
  const TemporaryFolder folder;
  const std::string python = (folder / "mine.py").string();
  const std::string other = (folder / "my team.js").string();
  write_content(python, "");
  write_content(other, "");
  EXPECT_EQ(setting_of(team_argument(python, "OLD"), "command"), "python3 " + python);
  EXPECT_TRUE(has(fault_of(other), "is not executable; give the command")) << fault_of(other);
  fs::permissions(other, fs::perms::owner_all);
  EXPECT_EQ(setting_of(team_argument(other, "OLD"), "command"), "'" + other + "'");
}

TEST(TeamArgument, IsAFileWithTheTeamsSettings) {
  const TemporaryFolder folder;
  const std::string file = (folder / "tuned.yaml").string();
  for (const char* text : {"strategy: cobalt\nrobots: 5\nparams: { shot_mps: 6.1 }\n",
                           "# as in result.yaml\ntuned:\n  strategy: cobalt\n  robots: 5\n  "
                           "params:\n    shot_mps: 6.1\n"}) {
    write_content(file, text);
    const TeamArgument team = team_argument(file, "OLD");
    EXPECT_EQ(setting_of(team, "strategy"), "cobalt");
    EXPECT_EQ(setting_of(team, "robots"), "5");
    EXPECT_EQ(setting_of(team, "params.shot_mps"), "6.1");
  }
  write_content(file, "command: [python3, 'my team.py']\n");
  EXPECT_EQ(setting_of(team_argument(file, "OLD"), "command"), "python3 'my team.py'");
  write_content(file, "prams: { shot_mps: 5 }\n");
  EXPECT_EQ(setting_of(team_argument(file, "OLD"), "prams.shot_mps"), "5");  // refused later
  write_content(file, "tuned: {}\n");
  EXPECT_TRUE(has(fault_of(file), "expected settings of a team")) << fault_of(file);
  write_content(file, "schema: 1\nkind: game\n");
  EXPECT_TRUE(has(fault_of(file), "this is a scenario")) << fault_of(file);
}

TEST(TeamArgument, RefusesWhatItDoesNotKnow) {
  EXPECT_TRUE(has(fault_of("cobald"), "OLD: unknown team 'cobald'")) << fault_of("cobald");
  EXPECT_TRUE(has(fault_of("cobald"), "did you mean 'cobalt'?")) << fault_of("cobald");
  EXPECT_FALSE(fault_of(" ").empty());
  EXPECT_TRUE(has(fault_of("missing/team.js"), "cannot find the file 'missing/team.js'"));
  EXPECT_FALSE(fault_of("missing.yaml").empty());
}

// The scenario that compare prints is the one that it plays.
void expect_same_scenario(const CompareArguments& arguments) {
  const experiments::Scenario printed =
      experiments::read_scenario_text(scenario_text(arguments), "printed.yaml");
  EXPECT_EQ(experiments::effective_text(printed),
            experiments::effective_text(comparison_in(arguments)))
      << scenario_text(arguments);
}

TEST(CompareScenario, IsTheOneThatIsPlayed) {
  CompareArguments arguments;
  arguments.old_team = "basic";
  arguments.sets = {"new.params.kick_caution=0.7", "old.robots=5", "match.half_s=60",
                    "new.players.2.speed_factor=0.5"};
  expect_same_scenario(arguments);
  arguments.new_team = "sh 'my team.sh'";
  arguments.sets = {};
  arguments.against = {"cobalt, counter", "cobalt"};
  arguments.camera = "realistic";
  arguments.rules = "2014";
  arguments.least = 0.1;
  arguments.seed = "18446744073709551615";
  expect_same_scenario(arguments);
}

TEST(CompareScenario, HasAFolderOfItsOwn) {
  CompareArguments arguments;
  arguments.old_team = "basic";
  arguments.new_team = "counter";
  const std::string name = results_name(arguments, comparison_in(arguments));
  EXPECT_TRUE(name.starts_with("compare-basic-counter-")) << name;
  // It can be continued with more games or for a smaller difference.
  arguments.games = 1000;
  arguments.least = 0.1;
  EXPECT_EQ(results_name(arguments, comparison_in(arguments)), name);
  arguments.sets = {"new.robots=5"};
  EXPECT_NE(results_name(arguments, comparison_in(arguments)), name);
}

class CompareVerb : public testing::Test {
 protected:
  Answer compare(const std::vector<const char*>& more) const {
    std::vector<const char*> words = {"--set", "match.half_s=2"};
    words.insert(words.end(), more.begin(), more.end());
    return compare_in(folder_, words);
  }
  static Answer compare_in(const std::string& folder, const std::vector<const char*>& more) {
    std::vector<const char*> words = {"compare", "-o",         folder.c_str(), "-j",
                                      "1",       "--progress", "none"};
    words.insert(words.end(), more.begin(), more.end());
    return answer_to(words);
  }

  TemporaryFolder parent_;
  std::string folder_ = (parent_ / "results").string();
};

TEST_F(CompareVerb, PrintsTheAnswerFirst) {
  const Answer answer = compare({"dummy", "basic", "--games", "4"});
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  EXPECT_TRUE(answer.out.starts_with("undecided after 4 games whether new is better than old: "))
      << answer.out;
  EXPECT_TRUE(has(answer.out, "old: dummy; new: basic")) << answer.out;
  EXPECT_TRUE(has(answer.out, "each other")) << answer.out;
  EXPECT_TRUE(fs::exists(fs::path(folder_) / "comparison.csv"));
}

TEST_F(CompareVerb, AnswersWithItsExitCode) {
  const auto code = [this](const char* required) {
    return compare({"dummy", "dummy", "--games", "4", "--require", required}).code;
  };
  EXPECT_EQ(code("not-worse"), io::kDone);
  EXPECT_EQ(code("equal"), io::kNotMet);
  EXPECT_EQ(code("better"), io::kNotMet);
}

// Short games without goals: after some pairs, a difference of five goals is out of the question.
TEST_F(CompareVerb, KnowsWhenNoDifferenceMatters) {
  const Answer answer =
      compare({"dummy", "dummy", "--games", "100", "--least", "5", "--require", "equal"});
  EXPECT_EQ(answer.code, io::kDone) << answer.out;
  EXPECT_TRUE(answer.out.starts_with("new and old differ by less than 5 goals per game: "))
      << answer.out;
}

TEST_F(CompareVerb, KnowsABetterTeamAndAWorseOne) {
  const auto code = [this](const char* one, const char* other, const char* required) {
    const std::string folder = (parent_ / one).string();
    return compare_in(folder, {one, other, "--games", "40", "--set", "match.half_s=60", "--require",
                               required})
        .code;
  };
  EXPECT_EQ(code("dummy", "chaser", "better"), io::kDone);
  EXPECT_EQ(code("dummy", "chaser", "equal"), io::kDone);
  EXPECT_EQ(code("chaser", "dummy", "not-worse"), io::kNotMet);
  EXPECT_EQ(code("chaser", "dummy", "equal"), io::kNotMet);
}

TEST(CompareScenario, HasOpponentsWithNamesOfTheirOwn) {
  CompareArguments arguments;
  arguments.old_team = "basic";
  arguments.new_team = "counter";
  arguments.against = {"cobalt, cobalt", "sh new.js --list '1,2'", "sh all.js"};
  const experiments::Scenario scenario = comparison_in(arguments);
  std::vector<std::string> names;
  for (const auto& [name, team] : scenario.get<experiments::Comparison>().against)
    names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"all_2", "cobalt", "cobalt_2", "new_2"}));
}

TEST_F(CompareVerb, PrintsOneJsonObject) {
  const Answer answer =
      compare({"dummy", "basic", "--games", "12", "--against", "chaser", "--json"});
  const io::Json json = io::Json::parse(answer.out);
  EXPECT_EQ(json["comparison"]["games"], 12);
  EXPECT_EQ(json["comparison"]["opponents"].size(), 2U);
  EXPECT_EQ(json["about"],
            "Is new better than old? old: dummy; new: basic; both also against chaser.");
}

TEST_F(CompareVerb, PrintsItsScenarioWithoutPlaying) {
  const Answer answer = compare({"basic", "--set", "new.params.kick_caution=0.7", "--scenario"});
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  EXPECT_TRUE(has(answer.out, "kind: compare")) << answer.out;
  EXPECT_TRUE(has(answer.out, "kick_caution: 0.7")) << answer.out;
  EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(CompareVerb, WritesFilesForContinuousIntegration) {
  const std::string ci = (parent_ / "ci" / "deep").string();
  const Answer answer = compare(
      {"dummy", "basic", "--games", "4", "--seed", "9", "--require", "better", "--ci", ci.c_str()});
  EXPECT_EQ(answer.code, io::kNotMet) << answer.err;
  EXPECT_TRUE(has(answer.out, ci + "/comparison.md   ")) << answer.out;
  const std::string markdown = content_of(ci + "/comparison.md");
  EXPECT_TRUE(markdown.starts_with("# autoref compare dummy basic\n")) << markdown;
  EXPECT_TRUE(has(markdown, "**Failed: undecided after 4 games")) << markdown;
  EXPECT_TRUE(has(markdown,
                  "\nautoref compare dummy basic --games 4 --seed 9 --set match.half_s=2 "
                  "--require better\n"))
      << markdown;
  EXPECT_TRUE(has(content_of(ci + "/junit.xml"), "<failure message=\"undecided after 4 games"));
}

TEST_F(CompareVerb, ChecksTheFolderForContinuousIntegrationBeforePlaying) {
  const std::string ci = (parent_ / "ci").string();
  write_content(ci, "a file");
  const Answer answer = compare({"dummy", "basic", "--ci", ci.c_str()});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_TRUE(has(answer.err, "--ci: ")) << answer.err;
  EXPECT_FALSE(fs::exists(folder_));
}

// Otherwise, a server would take them for the answer of this comparison.
TEST_F(CompareVerb, RemovesFilesOfAnEarlierComparisonIfItHasNoAnswer) {
  const std::string ci = (parent_ / "ci").string();
  fs::create_directory(ci);
  write_content(ci + "/junit.xml", "old");
  const Answer answer =
      compare({"dummy", "basic", "--games", "4", "--ci", ci.c_str(), "--shard", "0/2"});
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  EXPECT_TRUE(fs::is_empty(ci));
}

TEST_F(CompareVerb, TakesOverGamesOfAnEarlierComparison) {
  const auto play = [](const std::string& folder, const char* new_team, const std::string& reused) {
    return answer_to({"compare", "dummy", new_team, "--against", "basic", "--games", "6", "-o",
                      folder.c_str(), "-j", "1", "--set", "match.half_s=2", "--reuse",
                      reused.c_str()});
  };
  const std::string first = (parent_ / "first").string();
  EXPECT_TRUE(has(play(first, "chaser", "missing").err, "missing does not exist yet; all games"));
  const Answer answer = play(folder_, "zone", first);
  EXPECT_TRUE(has(answer.err, "2 of 6 games are taken over from " + first)) << answer.err;
}

TEST_F(CompareVerb, RefusesWhatItCannotCompare) {
  struct Refused {
    std::vector<const char*> words;
    const char* part;
  };
  const std::vector<Refused> all = {
      {{"basic"}, "NEW: give a second team"},
      {{"basic", "--set", "a.robots=5"}, "a setting of one of the teams old and new"},
      {{"basic", "counter", "--set", "new.params.nothing=1"}, "no parameter 'nothing'"},
      {{"basic", "counter", "--games", "2", "--against", "zone"}, "--games: expected 6 games"},
      {{"basic", "counter", "--rules", "2025"}, "--rules 2025: expected one of"},
      {{"basic", "counter", "--camera", "x"},
       "--camera x: expected a file such as measured.yaml, or one of"},
      {{"basic", "counter", "--games", "1000000"}, "--games: expected 2 games"},
      {{"basic", "--set", "teams.new=cobalt"}, "such as new.robots=5 or new.strategy=cobalt"},
      {{"basic", "--set", "new=cobalt"}, "such as new.robots=5 or new.strategy=cobalt"},
      {{"basic", "counter", "--set", "against=3"}, "expected a setting of one of the teams"},
      {{"basic", "counter", "--least", "nan"}, "--least: expected a number above 0"},
      {{"basic", "counter", "--against", "zone,"}, "--against: unknown team ''"},
      {{"basic", "counter", "--seed", "x"}, "--seed: expected a whole number"},
      {{"basic", "counter", "--least", "0"},
       "--least: expected a number above 0 and at most 50, found 0"},
      {{"basic", "counter", "--require", "good"}, "expected one of"}};
  for (const Refused& refused : all) {
    const Answer answer = compare(refused.words);
    EXPECT_EQ(answer.code, io::kBadInput) << refused.part;
    EXPECT_TRUE(has(answer.err, refused.part)) << answer.err;
  }
}

}  // namespace
}  // namespace autoref::app
