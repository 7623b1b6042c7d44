// The reference pages of the manual are what the program prints.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/description/reference_pages.hpp"
#include "io/errors.hpp"
#include "tests/app/answer.hpp"
#include "tests/checkout.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

std::string printed(const std::string& page) {
  const Answer answer = answer_to({"reference", page.c_str()});
  EXPECT_EQ(answer.code, io::kDone) << answer.err;
  return answer.out;
}

// The page's line that begins with this cell.
std::string page_line_of(const std::string& page, const std::string& cell) {
  const std::size_t begin = page.find("\n| " + cell + " |");
  return begin == std::string::npos ? "" : page.substr(begin, page.find('\n', begin + 1) - begin);
}

class ReferencePage : public testing::TestWithParam<std::string> {};

TEST_P(ReferencePage, IsTheOneInTheManual) {
  const std::string file = "docs/reference/" + GetParam() + ".md";
  EXPECT_TRUE(content_of(in_checkout(file)) == printed(GetParam()))
      << file << " is out of date; run: build/release/bin/autoref reference " << GetParam() << " > "
      << file;
}

INSTANTIATE_TEST_SUITE_P(Of, ReferencePage, testing::ValuesIn(reference_page_names()),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(ReferencePages, GiveEachSettingItsDefaultRangeAndMeaning) {
  const std::string line = page_line_of(printed("settings"), "`half_s`");
  EXPECT_NE(line.find("`600.0`"), std::string::npos) << line;
  EXPECT_NE(line.find("at most 36000 s"), std::string::npos) << line;
  EXPECT_NE(line.find("length of a half"), std::string::npos) << line;
}

// Rules of 2026: 12 x 9 m and 11 robots in Division A.
TEST(ReferencePages, SayWhatARuleBookSets) {
  const std::string page = printed("settings");
  const std::string sets = page.substr(page.find("## What `match.rules` sets"));
  EXPECT_NE(page_line_of(sets, "`field.length_m`").find(" 12"), std::string::npos);
  EXPECT_NE(page_line_of(sets, "`a.robots`").find(" 11"), std::string::npos);
}

TEST(ReferencePages, NameEveryVerbAndItsOptions) {
  const std::string page = printed("verbs");
  EXPECT_NE(page.find("\n## autoref play\n"), std::string::npos);
  EXPECT_NE(page.find("\n## autoref team new\n"), std::string::npos);
  EXPECT_NE(page.find("| `-o`, `--output`"), std::string::npos);
}

// Laws 2014, law 12: 8 m/s; the rules of 2026: 6.5 m/s.
TEST(ReferencePages, ShowThresholdsOfEachRuleBook) {
  const std::string line = page_line_of(printed("rules"), "`bot_kicked_ball_too_fast`");
  EXPECT_NE(line.find("8 m/s"), std::string::npos) << line;
  EXPECT_NE(line.find("6.5 m/s"), std::string::npos) << line;
}

TEST(ReferencePages, KeepPipesAndAnglesInTablesAsText) {
  const std::string table = reference_table({{"a"}, {"x|y <z> `<w>` 2*3"}});
  EXPECT_NE(table.find("| x\\|y &lt;z> `<w>` 2\\*3 |"), std::string::npos) << table;
}

TEST(ReferencePages, RefuseAnUnknownName) {
  EXPECT_EQ(answer_to({"reference", "nothing"}).code, io::kBadInput);
}

}  // namespace
}  // namespace autoref::app
