#include "app/results/replay_verb.hpp"

#include <gtest/gtest.h>

#include "io/errors.hpp"
#include "tests/app/answer.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

TEST(TurnedId, HasItsTeamsExchanged) {
  EXPECT_EQ(turned_id("a~b-p0001-1"), "b~a-p0001-1");
  EXPECT_EQ(turned_id("2014+none+basic~team-plus-p0002-1-f3"),
            "2014+none+team-plus~basic-p0002-1-f3");
  EXPECT_EQ(turned_id("2014 none basic~zone 3"), "2014 none zone~basic 3");
  EXPECT_EQ(turned_id("zone~basic"), "basic~zone");
  EXPECT_EQ(turned_id("b.handicap=0.8-p0007-2"), "");
}

// The results of a round robin of two teams.
class NamedGame : public testing::Test {
 protected:
  void SetUp() override {
    write_content(folder_ / "two.yaml",
                  "schema: 1\nkind: roundrobin\nseed: 1\npairs: 1\n"
                  "base: { match: { rules: paper, half_s: 1 } }\n"
                  "teams: { anna: { strategy: dummy }, bert: { strategy: dummy } }\n");
    const std::string file = folder_ / "two.yaml";
    const Answer answer = answer_to({"run", file.c_str(), "-o", results_.c_str(), "-j", "1"});
    ASSERT_EQ(answer.code, io::kDone) << answer.err;
  }

  TemporaryFolder folder_;
  std::string results_ = (folder_ / "results").string();
};

TEST_F(NamedGame, IsFoundWithItsTeamsTheOtherWayRound) {
  const Answer answer = answer_to({"results", "replay", results_.c_str(), "bert~anna-p0001-2"});
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  EXPECT_NE(answer.err.find(
                "autoref: this folder lists the teams of 'bert~anna-p0001-2' in the other order: "
                "anna~bert-p0001-2\n"),
            std::string::npos)
      << answer.err;
  const std::string score = "a (dummy, east)  0 : 0  b (dummy, west)";
  EXPECT_EQ(answer.out.find(score), 0U) << answer.out;
}

TEST_F(NamedGame, IsSuggestedIfItsIdIsBegun) {
  for (const char* begun : {"bert~anna", "anna~bert"}) {
    const Answer answer = answer_to({"results", "replay", results_.c_str(), begun});
    EXPECT_EQ(answer.code, io::kBadInput);
    EXPECT_NE(answer.err.find("did you mean 'anna~bert-p0001-1' or 'anna~bert-p0001-2'?"),
              std::string::npos)
        << answer.err;
  }
}

}  // namespace
}  // namespace autoref::app
