// Mistyped verbs, options and arguments.
#include "runner/cli/mistyped.hpp"

#include <gtest/gtest.h>

#include "runner/io/errors.hpp"
#include "tests/checkout.hpp"
#include "tests/runner/cli/answer.hpp"

namespace autoref::runner {
namespace {

const std::string kMistypedGame = in_checkout("scenarios/paper-game.yaml");

bool says(const Answer& answer, const std::string& part) {
  return answer.err.find(part) != std::string::npos;
}

TEST(MistypedVerb, IsAnsweredWithTheClosestOne) {
  const Answer answer = answer_to({"plya"});
  EXPECT_EQ(answer.code, kBadInput);
  EXPECT_EQ(answer.err,
            "autoref: there is no verb 'plya'; did you mean 'play'? `autoref help` lists them\n");
}

TEST(MistypedVerb, GetsNoSuggestionIfNoneIsClose) {
  const Answer answer = answer_to({"nonsense"});
  EXPECT_EQ(answer.code, kBadInput);
  EXPECT_FALSE(says(answer, "did you mean")) << answer.err;
}

TEST(Help, IsPrintedWithoutArguments) {
  const Answer bare = answer_to({});
  EXPECT_EQ(bare.code, kDone);
  EXPECT_EQ(bare.err, "");
  EXPECT_EQ(bare.out, answer_to({"--help"}).out);
  EXPECT_EQ(bare.out, answer_to({"help"}).out);
}

TEST(Help, ForAVerbEqualsItsHelpFlag) {
  const Answer answer = answer_to({"help", "run"});
  EXPECT_EQ(answer.code, kDone);
  EXPECT_EQ(answer.out, answer_to({"run", "--help"}).out);
}

TEST(Help, SuggestsTheClosestVerb) {
  const Answer answer = answer_to({"help", "repotr"});
  EXPECT_EQ(answer.code, kBadInput);
  EXPECT_TRUE(says(answer, "no verb 'repotr'; did you mean 'report'?")) << answer.err;
  EXPECT_EQ(answer_to({"help", "nonsense"}).code, kBadInput);
}

TEST(UnexpectedArguments, AreNamedInTheOrderGiven) {
  const Answer answer = answer_to({"play", kMistypedGame.c_str(), "one", "two", "three"});
  EXPECT_EQ(answer.code, kBadInput);
  EXPECT_TRUE(says(answer, "play: unexpected arguments 'one', 'two', 'three';")) << answer.err;
}

TEST(UnknownOption, IsAnsweredWithTheClosestOne) {
  const Answer play = answer_to({"play", kMistypedGame.c_str(), "--sed", "1"});
  EXPECT_EQ(play.code, kBadInput);
  EXPECT_TRUE(says(play, "unknown option '--sed'; did you mean '--seed'?")) << play.err;
  const Answer verify = answer_to({"verify", "--sampel=5"});
  EXPECT_TRUE(says(verify, "unknown option '--sampel'; did you mean '--sample'?")) << verify.err;
  const Answer version = answer_to({"--verison"});
  EXPECT_TRUE(says(version, "did you mean '--version'?")) << version.err;
}

}  // namespace
}  // namespace autoref::runner
