#include "tests/referee/rules/case_reader.hpp"

#include <gtest/gtest.h>

namespace autoref::referee {
namespace {

// The error of a file with one case that has the given lines in addition to the required ones.
std::string error_of(const std::string& lines, const std::string& head = "") {
  const std::string text = "rule: goal\nrules: paper\nevents: [goal]\n" + head +
                           "cases:\n"
                           "  - case: A sentence\n"
                           "    source: the Laws\n"
                           "    play: running\n"
                           "    ball_m: [1, 0]\n" +
                           lines;
  const std::vector<Case> cases = cases_in(text, "goal.yaml");
  return cases.size() == 1 ? cases[0].error : "not one case";
}

const std::string kNothing = "    nothing: true\n    until_s: 1\n";

TEST(CaseReader, ReadsACase) { EXPECT_EQ(error_of(kNothing), ""); }

TEST(CaseReader, RefusesAnUnknownKeyWithItsLine) {
  EXPECT_EQ(error_of(kNothing + "    untill_s: 2\n"), "goal.yaml:11: unknown key untill_s");
  EXPECT_EQ(error_of(kNothing, "rulse: paper\n"), "goal.yaml:4: unknown key rulse");
}

TEST(CaseReader, RefusesAKeyGivenTwice) {
  EXPECT_EQ(error_of(kNothing + "    until_s: 2\n"), "goal.yaml:11: until_s is given twice");
}

TEST(CaseReader, RefusesACaseWithoutAnOutcome) {
  EXPECT_NE(error_of("    until_s: 1\n").find("a case needs `expect`"), std::string::npos);
}

TEST(CaseReader, RefusesAnUnknownEvent) {
  EXPECT_EQ(error_of("    never: [gaol]\n    until_s: 1\n"),
            "goal.yaml:9: never: 'gaol' is not an event");
}

TEST(CaseReader, RefusesACueThatLacksItsNumbers) {
  EXPECT_EQ(error_of("    script:\n      - { at_s: 1, kick: west 1 }\n" + kNothing),
            "goal.yaml:10: speed_mps is missing");
}

TEST(CaseReader, RefusesCuesOutOfOrder) {
  EXPECT_EQ(error_of("    script:\n      - { at_s: 2, ball_seen: false }\n"
                     "      - { at_s: 1, ball_seen: true }\n" +
                     kNothing),
            "goal.yaml:11: at_s: earlier than the previous cue");
}

}  // namespace
}  // namespace autoref::referee
