// The man page and completion are written from the program's own verbs and options.
#include "runner/cli/described_verb.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "runner/io/errors.hpp"
#include "tests/runner/cli/answer.hpp"
#include "tests/runner/support/temporary_folder.hpp"

namespace autoref::runner {
namespace {

TEST(ManPage, HasEveryVerbWithItsOptionsAndExample) {
  const Answer page = answer_to({"man"});
  ASSERT_EQ(page.code, kDone);
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

// Runs the script in bash, which completes the last of `words`, and returns the proposals.
std::string completed_in_bash(const std::string& words) {
  const TemporaryFolder folder;
  write_content(folder / "completion", answer_to({"completion", "bash"}).out);
  write_content(
      folder / "try",
      ". " + (folder / "completion").string() + "\nCOMP_WORDS=(" + words +
          ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_autoref\necho \"${COMPREPLY[*]}\" > " +
          (folder / "answer").string() + "\n");
  EXPECT_EQ(std::system(("bash " + (folder / "try").string()).c_str()), 0);
  return content_of(folder / "answer");
}

TEST(Completion, InBashProposesVerbsAndOptions) {
  EXPECT_EQ(completed_in_bash("autoref pl"), "play\n");
  EXPECT_EQ(completed_in_bash("autoref team n"), "new\n");
  EXPECT_EQ(completed_in_bash("autoref play --ev"), "--events\n");
  EXPECT_EQ(completed_in_bash("autoref view game.log.gz --fr"), "--from\n");
  EXPECT_EQ(completed_in_bash("autoref play scen"), "\n") << "bash completes files itself";
}

TEST(Completion, ForOtherShellsHasVerbsAndOptions) {
  const std::string zsh = answer_to({"completion", "zsh"}).out;
  EXPECT_TRUE(zsh.starts_with("#compdef autoref\n"));
  EXPECT_NE(zsh.find("'view:Turn a recorded game into an HTML page.'"), std::string::npos);
  EXPECT_NE(zsh.find("'--sqlite[The database, a SQLite file.]:FILE:_files'"), std::string::npos);
  const std::string fish = answer_to({"completion", "fish"}).out;
  EXPECT_NE(fish.find(" -f -a view -d 'Turn a recorded game into an HTML page.'\n"),
            std::string::npos);
  EXPECT_NE(fish.find("__fish_seen_subcommand_from export' -l sqlite -r -d 'The database, a "
                      "SQLite file.'\n"),
            std::string::npos);
  EXPECT_EQ(answer_to({"completion", "tcsh"}).code, kBadInput);
}

// A quote in a description must not end the word.
TEST(Completion, KeepsQuotesInDescriptions) {
  const DescribedVerb program{
      "autoref", "", {{{"--team"}, "T", "The team's [a: b] name."}}, "", {}};
  EXPECT_NE(fish_completion(program).find("'The team'\\''s [a: b] name.'"), std::string::npos);
  EXPECT_NE(zsh_completion(program).find("'--team[The team'\\''s \\[a\\: b\\] name.]:T:_files'"),
            std::string::npos)
      << zsh_completion(program);
}

}  // namespace
}  // namespace autoref::runner
