// The man page is written from the program's own verbs and options.
#include "app/description/described_verb.hpp"

#include <gtest/gtest.h>

#include "io/errors.hpp"
#include "tests/app/answer.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

TEST(ManPage, HasEveryVerbWithItsOptionsAndExample) {
  const Answer page = answer_to({"show", "man"});
  ASSERT_EQ(page.code, io::kDone);
  EXPECT_TRUE(page.out.starts_with(".TH AUTOREF 1 "));
  for (const char* text :
       {"\n.SS \"autoref play\"\n", "\n.SS \"autoref team new\"\n",
        "\\fB\\-\\-sqlite\\fR \\fIFILE\\fR", "\\fB\\-o\\fR, \\fB\\-\\-output\\fR",
        "\n  autoref run scenarios/first\\-look.yaml\n"})
    EXPECT_NE(page.out.find(text), std::string::npos) << text;
}

TEST(ManPage, ShowsTextsThatWouldBeCommandsOfRoff) {
  DescribedVerb program;
  program.name = "tool";
  program.description = ".SH no heading";
  program.footer = "'quoted\n\\back";
  const std::string page = man_page(program, "tool 1");
  EXPECT_NE(page.find("\n\\&.SH no heading\n"), std::string::npos) << page;
  EXPECT_NE(page.find("\n\\&'quoted\n\\eback\n"), std::string::npos) << page;
}

}  // namespace
}  // namespace autoref::app
