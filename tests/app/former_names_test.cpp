#include "app/former_names.hpp"

#include <gtest/gtest.h>

#include "io/errors.hpp"
#include "tests/app/answer.hpp"
#include "tests/checkout.hpp"

namespace autoref::app {
namespace {

using Words = std::vector<std::string>;

TEST(FormerNames, CallTheSameVerbs) {
  EXPECT_EQ(former_names().size(), 15U);
  for (const FormerName& name : former_names()) {
    const std::string former(name.former);
    const std::string present(name.present);
    const Answer answer = answer_to(former, {"--help"});
    EXPECT_EQ(answer.code, io::kDone) << former;
    EXPECT_EQ(answer.out, answer_to(present, {"--help"}).out);
    EXPECT_EQ(answer.out, answer_to("help " + former, {}).out);
    EXPECT_NE(answer.out.find("Usage: autoref " + present + " "), std::string::npos) << answer.out;
  }
}

TEST(FormerNames, AreNotListed) {
  const std::string help = answer_to({"--help"}).out;
  for (const FormerName& name : former_names())
    EXPECT_EQ(help.find("\n  " + std::string(name.former) + " "), std::string::npos) << name.former;
}

TEST(FormerNames, CountOnlyInFront) {
  EXPECT_EQ(with_present_names({}), Words{});
  EXPECT_EQ(with_present_names({"help"}), Words{"help"});
  EXPECT_EQ(with_present_names({"--version"}), Words{"--version"});
  EXPECT_EQ(with_present_names({"play", "status"}), (Words{"play", "status"}));
  EXPECT_EQ(with_present_names({"status", "status"}), (Words{"results", "status", "status"}));
  EXPECT_EQ(with_present_names({"results", "replay"}), (Words{"results", "replay"}));
}

TEST(FormerNames, LeadDrawToLogsAndToSituations) {
  EXPECT_EQ(with_present_names({"draw", "x.log", "--at", "1"}),
            (Words{"log", "draw", "x.log", "--at", "1"}));
  EXPECT_EQ(with_present_names({"draw", "x.yaml", "--situation", "corner"}),
            (Words{"show", "situation", "x.yaml", "--situation", "corner"}));
  EXPECT_EQ(with_present_names({"draw", "x.yaml", "--situation=corner"}),
            (Words{"show", "situation", "x.yaml", "--situation=corner"}));
}

TEST(FormerNames, LeadRefereeToLogsAndToTheNetwork) {
  EXPECT_EQ(with_present_names({"referee", "--log", "x.log"}),
            (Words{"referee", "log", "--log", "x.log"}));
  EXPECT_EQ(with_present_names({"referee", "x.log", "--json"}),
            (Words{"referee", "log", "x.log", "--json"}));
  EXPECT_EQ(with_present_names({"referee", "--seconds", "3", "--live"}),
            (Words{"referee", "live", "--seconds", "3"}));
  for (const Words& present :
       {Words{"referee"}, Words{"referee", "-h"}, Words{"referee", "liev"},
        Words{"referee", "log", "live"}, Words{"referee", "live", "--seconds", "3"}})
    EXPECT_EQ(with_present_names(present), present);
}

// Command lines of 1.0 that are split between two verbs now.
TEST(FormerNames, StillWorkWithTheirOptions) {
  const std::string situations = in_checkout("scenarios/situations-attack.yaml");
  EXPECT_EQ(
      answer_to({"draw", situations.c_str(), "--situation", "corner", "-o", "/dev/null"}).code,
      io::kDone);
  const Answer live = answer_to({"referee", "--live", "--seconds", "x"});
  EXPECT_EQ(live.err.find("autoref: referee live: --seconds: "), 0U) << live.err;
  const Answer log = answer_to({"referee", "--log", "nowhere.log"});
  EXPECT_EQ(log.code, io::kBadInput);
  EXPECT_NE(log.err.find("nowhere.log"), std::string::npos) << log.err;
}

}  // namespace
}  // namespace autoref::app
