// Mistyped verbs, options and arguments.
#include "app/mistyped.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <utility>

#include "game/team_programs/team_templates.hpp"
#include "io/errors.hpp"
#include "io/words.hpp"
#include "tests/app/answer.hpp"
#include "tests/checkout.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

const std::string kMistypedGame = in_checkout("scenarios/paper-game.yaml");

bool says(const Answer& answer, const std::string& part) {
  return answer.err.find(part) != std::string::npos;
}

TEST(MistypedVerb, IsAnsweredWithTheClosestOne) {
  const Answer answer = answer_to({"plya"});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_EQ(answer.err,
            "autoref: unknown verb 'plya'; did you mean 'play'? `autoref help` lists them\n");
}

TEST(MistypedVerb, GetsNoSuggestionIfNoneIsClose) {
  const Answer answer = answer_to({"nonsense"});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_FALSE(says(answer, "did you mean")) << answer.err;
}

TEST(MistypedVerb, MayBeInAGroupOrAFormerName) {
  EXPECT_TRUE(says(answer_to({"statu"}), "unknown verb 'statu'; did you mean 'results status'?"));
  EXPECT_TRUE(says(answer_to({"benhc"}), "did you mean 'show speed'?"));
  EXPECT_TRUE(says(answer_to({"help", "replya"}), "did you mean 'results replay'?"));
}

TEST(MistypedVerb, OfAGroupMayBeAVerbElsewhere) {
  EXPECT_TRUE(says(answer_to({"results", "stauts"}),
                   "'results' has no verb 'stauts'; did you mean 'status'?"));
  EXPECT_TRUE(says(answer_to({"results", "report", "x"}), "did you mean 'autoref report'?"));
  EXPECT_TRUE(says(answer_to({"help", "show", "lab"}), "did you mean 'autoref experiment lab'?"));
  EXPECT_EQ(answer_to({"log", "x.log"}).err,
            "autoref: 'log' has no verb 'x.log'; `autoref help log` lists its verbs\n");
  EXPECT_TRUE(says(answer_to({"referee", "liev"}), "did you mean 'live'?"));
  EXPECT_TRUE(says(answer_to({"help", "referee", "liev"}), "did you mean 'live'?"));
}

TEST(Help, IsPrintedWithoutArguments) {
  const Answer bare = answer_to({});
  EXPECT_EQ(bare.code, io::kDone);
  EXPECT_EQ(bare.err, "");
  EXPECT_EQ(bare.out, answer_to({"--help"}).out);
  EXPECT_EQ(bare.out, answer_to({"help"}).out);
}

TEST(Help, ForAVerbEqualsItsHelpFlag) {
  const Answer answer = answer_to({"help", "run"});
  EXPECT_EQ(answer.code, io::kDone);
  EXPECT_EQ(answer.out, answer_to({"run", "--help"}).out);
}

TEST(Help, SuggestsTheClosestVerb) {
  const Answer answer = answer_to({"help", "repotr"});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_TRUE(says(answer, "unknown verb 'repotr'; did you mean 'report'?")) << answer.err;
  EXPECT_EQ(answer_to({"help", "nonsense"}).code, io::kBadInput);
}

TEST(Help, ExplainsAVerbOfAVerb) {
  for (const char* nested : {"new", "play", "check"}) {
    const Answer answer = answer_to({"help", "team", nested});
    EXPECT_EQ(answer.code, io::kDone) << answer.err;
    EXPECT_EQ(answer.out, answer_to({"team", nested, "--help"}).out);
  }
}

TEST(Help, SuggestsTheClosestVerbOfAVerb) {
  const Answer answer = answer_to({"help", "team", "nwe"});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_EQ(answer.err,
            "autoref: help: 'team' has no verb 'nwe'; did you mean 'new'? `autoref help team` "
            "lists its verbs\n");
  EXPECT_TRUE(says(answer_to({"team", "nwe"}), "'team' has no verb 'nwe'; did you mean 'new'?"));
  EXPECT_TRUE(
      says(answer_to({"help", "run", "fast"}), "'run' does not take a verb such as 'fast'"));
}

TEST(VerbOfAVerb, IsNamedInItsMessages) {
  const Answer option = answer_to({"team", "new", "--langauge", "python", "x"});
  EXPECT_EQ(option.err,
            "autoref: team new: unknown option '--langauge'; did you mean '--language'? `autoref "
            "help team new` lists its options\n");
  EXPECT_TRUE(says(answer_to({"team"}), "team: expected one of its verbs: new, play, check;"));
}

// CLI11 would begin with what help calls the argument, such as "BOOK: ".
TEST(Messages, DoNotBeginWithTheNameOfAnArgument) {
  const auto message = [](std::vector<const char*> arguments) {
    const Answer answer = answer_to(std::move(arguments));
    EXPECT_EQ(answer.code, io::kBadInput);
    return answer.err;
  };
  EXPECT_EQ(message({"show", "rules", "nosuch"}).find("autoref: unknown rule book 'nosuch'. Known"),
            0U);
  EXPECT_EQ(message({"show", "teams", "nosuch"}).find("autoref: unknown team 'nosuch'. Known"), 0U);
  EXPECT_EQ(message({"reference", "verb"}),
            "autoref: reference: expected one of settings, verbs, rules, teams, scenario-files, "
            "found 'verb'; did you mean 'verbs'? `autoref help reference` lists its options\n");
  EXPECT_EQ(message({"team", "check", "'"}),
            "autoref: the command of the team: a quote (') is not closed\n");
  EXPECT_EQ(message({"view"}),
            "autoref: view: an argument is missing: LOG (A .log or .log.gz file); `autoref help "
            "view` lists its options\n");
  EXPECT_TRUE(message({"referee", "log"})
                  .starts_with("autoref: referee log: an argument is missing: LOG (A .log"));
  EXPECT_TRUE(message({"show", "situation", kMistypedGame.c_str()})
                  .starts_with("autoref: show situation: an argument is missing: SITUATION ("));
  EXPECT_TRUE(message({"referee", "live", "--seconds", "x"})
                  .starts_with("autoref: referee live: --seconds: expected a number from 0 to "
                               "1e+09, found 'x';"));
  EXPECT_TRUE(message({"view", "x.log", "-o", "x.html", "--from", "x"})
                  .starts_with("autoref: view: --from: expected a number, found 'x';"));
  EXPECT_TRUE(message({"run", "x.yaml", "--progress", "jason"})
                  .starts_with("autoref: run: --progress: expected one of plain, json, none, found "
                               "'jason'; did you mean 'json'?"));
}

TEST(Messages, HaveNoLimit) {
  const std::string word(200'000, 'x');
  const Answer number = answer_to({"referee", "live", "--seconds", word.c_str()});
  EXPECT_EQ(number.code, io::kBadInput);
  EXPECT_TRUE(says(number, "expected a number from 0 to 1e+09, found 'xxx"));
  for (const std::vector<const char*>& words : std::vector<std::vector<const char*>>{
           {word.c_str()}, {"referee", word.c_str()}, {"help", "referee", word.c_str()}})
    EXPECT_EQ(answer_to(words).code, io::kBadInput);
}

TEST(UnknownRuleBook, IsAnsweredWithThoseThatBeginSo) {
  EXPECT_TRUE(
      says(answer_to({"show", "rules", "2026"}), "did you mean '2026-b' or '2026-a'? Known here:"));
}

TEST(UnknownOption, IsAnsweredWithThoseThatBeginSo) {
  EXPECT_TRUE(says(answer_to({"live", kMistypedGame.c_str(), "--gr"}),
                   "unknown option '--gr'; did you mean '--grsim-port'?"));
}

TEST(TeamNew, ListsTheLanguagesIfNoneIsGiven) {
  const Answer bare = answer_to({"team", "new"});
  EXPECT_EQ(bare.code, io::kBadInput);
  EXPECT_EQ(bare.err,
            "autoref: team new: choose a language: " + io::listed(game::template_languages()) +
                "; for example: autoref team new --language python my_team\n");
  EXPECT_EQ(answer_to({"team", "new", "somewhere"}).err, bare.err);
  EXPECT_FALSE(std::filesystem::exists("somewhere"));
  EXPECT_TRUE(says(answer_to({"team", "new", "--language", "python"}), "name a new folder"));
  EXPECT_TRUE(says(answer_to({"team", "new", "--language", "pyton", "x"}),
                   "found 'pyton'; did you mean 'python'?"));
}

TEST(TeamNew, PrintsTheCommandsToGoOnWith) {
  const TemporaryFolder folder;
  for (const std::string& language : game::template_languages()) {
    const std::string place = folder / language;
    const Answer answer = answer_to({"team", "new", "--language", language.c_str(), place.c_str()});
    EXPECT_EQ(answer.code, io::kDone) << answer.err;
    for (const std::string& command :
         {"\n  cd " + place + "\n", std::string("\n  autoref team check '"),
          std::string("\n  autoref team play '")})
      EXPECT_NE(answer.out.find(command), std::string::npos) << answer.out;
  }
}

TEST(UnexpectedArguments, AreNamedInTheOrderGiven) {
  const Answer answer = answer_to({"play", kMistypedGame.c_str(), "one", "two", "three"});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_TRUE(says(answer, "play: unexpected arguments 'one', 'two', 'three';")) << answer.err;
}

TEST(UnknownOption, IsAnsweredWithTheClosestOne) {
  const Answer play = answer_to({"play", kMistypedGame.c_str(), "--sed", "1"});
  EXPECT_EQ(play.code, io::kBadInput);
  EXPECT_TRUE(says(play, "unknown option '--sed'; did you mean '--seed'?")) << play.err;
  const Answer verify = answer_to({"results", "verify", "--sampel=5"});
  EXPECT_TRUE(says(verify, "unknown option '--sampel'; did you mean '--sample'?")) << verify.err;
  const Answer version = answer_to({"--verison"});
  EXPECT_TRUE(says(version, "did you mean '--version'?")) << version.err;
}

}  // namespace
}  // namespace autoref::app
