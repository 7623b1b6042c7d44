// Tables that verbs print fit their width: 100 characters if standard output is not a terminal.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sstream>

#include "io/errors.hpp"
#include "io/table.hpp"
#include "tests/app/answer.hpp"
#include "tests/checkout.hpp"
#include "tests/support/has_part.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

void expect_fits(const Answer& answer) {
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  std::istringstream lines(answer.out);
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(io::width_of(line), io::kTextWidth) << line;
}

TEST(OutputWidth, OfTeamsAndRulesFits) {
  expect_fits(answer_to({"show", "teams"}));
  expect_fits(answer_to({"show", "teams", "cobalt"}));
  expect_fits(answer_to({"show", "rules", "2026-b"}));
  expect_fits(answer_to({"show", "rules", "paper"}));
}

TEST(OutputWidth, OfAnExperimentsTablesFits) {
  const TemporaryFolder folder;
  const std::string file = (folder / "short.yaml").string();
  const std::string results = (folder / "results").string();
  write_content(file,
                "schema: 1\nkind: roundrobin\n"
                "base: { match: { rules: paper, half_s: 1 } }\n"
                "teams:\n  a_team_with_a_rather_long_name: { strategy: dummy }\n"
                "  another_team_with_a_long_name: { strategy: dummy }\n"
                "  zone: { strategy: zone }\nseed: 1\npairs: 2\n");
  const Answer run = answer_to({"run", file.c_str(), "-o", results.c_str(), "-j", "1"});
  expect_fits(run);
  EXPECT_FALSE(has(run.out, "transitions")) << run.out;
  EXPECT_TRUE(has(run.out, "a_team_with_a_rather_long_name")) << run.out;
  expect_fits(answer_to({"check", file.c_str()}));
  expect_fits(answer_to({"results", "status", results.c_str()}));
  expect_fits(answer_to({"report", results.c_str()}));
}

}  // namespace
}  // namespace autoref::app
