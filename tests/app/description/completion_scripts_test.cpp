// The scripts of `autoref show completion`, in the shells themselves.
#include <gtest/gtest.h>

#include <cstdlib>

#include "io/errors.hpp"
#include "tests/app/answer.hpp"
#include "tests/checkout.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::app {
namespace {

// A folder with a program `autoref`, which is the one just built, and scripts that use it.
class CompletionScript : public testing::Test {
 protected:
  CompletionScript() {
    std::filesystem::create_symlink(AUTOREF_PROGRAM, folder_ / "autoref");
    std::filesystem::create_directories(folder_ / "cup/games");
    write_content(folder_ / "cup/results.csv", "game_id\nb.handicap=0.8-p0001-1\n");
    write_content(folder_ / "my cup.yaml", "");
  }

  // What the lines print, in the folder, after the script of the shell has been read.
  std::string printed(const std::string& shell, const std::string& lines) const {
    const Answer script = answer_to({"show", "completion", shell.c_str()});
    EXPECT_EQ(script.code, io::kDone);
    write_content(folder_ / "completion", script.out);
    write_content(folder_ / "try", lines);
    const std::string folder = folder_.path().string();
    const std::string command = "cd " + folder + " && PATH=" + folder + ":$PATH timeout 20 " +
                                shell + " ./try > answer 2> errors </dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0) << content_of(folder_ / "errors");
    EXPECT_EQ(content_of(folder_ / "errors"), "");
    return content_of(folder_ / "answer");
  }

  // The proposals for the last of `words`, which bash has split.
  std::string in_bash(const std::string& words) const {
    return printed("bash", ". ./completion\nCOMP_WORDS=(" + words +
                               ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_autoref\n"
                               "echo \"${COMPREPLY[*]}\"\n");
  }

  TemporaryFolder folder_;
};

bool has_shell(const std::string& shell) {
  return std::system(("command -v " + shell + " >/dev/null 2>&1").c_str()) == 0;
}

TEST_F(CompletionScript, InBashProposesVerbsAndOptions) {
  EXPECT_EQ(in_bash("autoref pl"), "play\n");
  EXPECT_EQ(in_bash("autoref team n"), "new\n");
  EXPECT_EQ(in_bash("autoref help team n"), "new\n");
  EXPECT_EQ(in_bash("./autoref play --ev"), "--events\n");
  EXPECT_EQ(in_bash("autoref view game.log.gz --fr"), "--from\n");
  EXPECT_EQ(in_bash("autoref play nowhere/"), "\n") << "bash completes files itself";
}

TEST_F(CompletionScript, InBashProposesValues) {
  EXPECT_EQ(in_bash("autoref show rules 2026"), "2026-b 2026-a\n");
  EXPECT_EQ(in_bash("autoref team play --opponent ba"), "basic\n");
  EXPECT_EQ(in_bash("autoref team new --language py"), "python\n");
  EXPECT_EQ(in_bash("autoref play --set match.half_"), "match.half_s=\n");
  EXPECT_EQ(in_bash("autoref play my"), "my\\ cup.yaml\n");
}

// bash splits words at '=' and ':', and replaces only the last piece.
TEST_F(CompletionScript, InBashCompletesTheLastPieceOfAWord) {
  EXPECT_EQ(in_bash("autoref play --set match.rules = 2026"), "2026-b 2026-a\n");
  EXPECT_EQ(in_bash("autoref play --set match.rules ="), "paper 2014 2014-double 2026-b 2026-a\n");
  EXPECT_EQ(in_bash("autoref view x --rules = 2026-b"), "2026-b\n");
  EXPECT_EQ(in_bash("autoref play --set match.rules=2026-b"), "match.rules=2026-b\n");
  EXPECT_EQ(in_bash("autoref results replay cup b.handicap = 0"), "0.8-p0001-1\n");
  EXPECT_EQ(in_bash("autoref results replay cup ''"), "b.handicap=0.8-p0001-1\n");
}

TEST_F(CompletionScript, InBashIsSilentWithoutTheProgram) {
  std::filesystem::remove(folder_ / "autoref");
  EXPECT_EQ(in_bash("./autoref pl"), "\n");
}

// As CMake says it for tests that need packages.
std::string missing(const std::string& package) {
  return "skipped: missing Debian packages: " + package + " (scripts/setup --checks installs them)";
}

TEST_F(CompletionScript, InZshProposesVerbsOptionsAndValues) {
  if (!has_shell("zsh")) GTEST_SKIP() << missing("zsh");
  const auto in_zsh = [this](const std::string& words) {
    // Prints what would be shown; zsh itself completes only on a terminal.
    return printed("zsh",
                   "compdef() { :; }\n_files() { print files }\n"
                   "_describe() { print -l -- ${(P)4%%:*} }\n"
                   ". ./completion\nwords=(" +
                       words + ")\nCURRENT=$#words\nPREFIX=$words[-1]\n_autoref\n");
  };
  EXPECT_EQ(in_zsh("autoref pl"), "play\n\n");
  EXPECT_EQ(in_zsh("autoref play --ev"), "--events\n\n");
  EXPECT_EQ(in_zsh("autoref play --set match.rules=2026"),
            "match.rules=2026-b\nmatch.rules=2026-a\n\n");
  EXPECT_EQ(in_zsh("autoref play nowhere/"), "files\n");
}

TEST_F(CompletionScript, InFishProposesVerbsOptionsAndValues) {
  if (!has_shell("fish")) GTEST_SKIP() << missing("fish");
  const auto in_fish = [this](const std::string& line) {
    return printed(
        "fish", "source ./completion\ncomplete -C '" + line + "' | string split -f1 \\t\nexit 0\n");
  };
  EXPECT_EQ(in_fish("autoref pl"), "play\n");
  EXPECT_EQ(in_fish("autoref play --ev"), "--events\n");
  EXPECT_EQ(in_fish("autoref play --set match.half_"), "match.half_s=\n");
  EXPECT_EQ(in_fish("autoref show rules 2026"), "2026-a\n2026-b\n");
}

TEST(Completion, IsRefusedForOtherShells) {
  const Answer answer = answer_to({"show", "completion", "fihs"});
  EXPECT_EQ(answer.code, io::kBadInput);
  EXPECT_EQ(answer.err,
            "autoref: show completion: expected one of bash, zsh, fish, found 'fihs'; did you mean "
            "'fish'? `autoref help show completion` lists its options\n");
}

}  // namespace
}  // namespace autoref::app
