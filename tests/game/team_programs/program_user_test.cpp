// What a team's program cannot do to files, to AutoRef and to another program, above all as root.
#include "game/team_programs/program_spec.hpp"

#include <gtest/gtest.h>
#include <linux/capability.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>

#include "game/team_programs/program_process.hpp"
#include "io/errors.hpp"
#include "tests/game/team_programs/marked_processes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::game {
namespace {

namespace fs = std::filesystem;

ProgramSpec program(std::vector<std::string> command) {
  ProgramSpec spec;
  spec.command = std::move(command);
  spec.environment = {marker()};
  spec.limits.answer_s = 60;
  return spec;
}

ProgramSpec script(const std::string& text) { return program({"/bin/sh", "-c", text}); }

// All that a script writes until it ends.
std::string output_of(const ProgramSpec& spec) {
  std::string text;
  try {
    ProgramProcess process(spec);
    for (;;) text += process.read(process.answer_deadline());
  } catch (const ProgramError& error) {
    EXPECT_NE(std::string(error.what()).find("ended with status 0"), std::string::npos)
        << error.what();
  }
  return text;
}

// What AutoRef says instead of starting a program.
std::string refusal_of(const ProgramSpec& spec) {
  try {
    ProgramProcess process(spec);
  } catch (const io::InputOutputError& error) {
    return error.what();
  } catch (const ProgramError& error) {
    ADD_FAILURE() << "the team is blamed: " << error.what();
    return "";
  }
  ADD_FAILURE() << "it has started";
  return "";
}

pid_t only_child_of(pid_t parent) {
  const std::string number = std::to_string(parent);
  std::ifstream children("/proc/" + number + "/task/" + number + "/children");
  pid_t child = 0;
  EXPECT_TRUE(children >> child);
  return child;
}

class ProgramsOfRoot : public testing::Test {
 protected:
  void SetUp() override {
    if (!runs_as_root()) GTEST_SKIP() << "skipped: only root can start programs under other users";
  }
};

TEST_F(ProgramsOfRoot, HaveNeitherItsUserNorItsRights) {
  const std::string text = output_of(script(
      "id -u; id -G; grep -E '^(CapPrm|CapEff|CapInh|CapAmb|NoNewPrivs)' /proc/self/status"));
  int user = 0;
  int group = 0;
  ASSERT_EQ(std::sscanf(text.c_str(), "%d\n%d\n", &user, &group), 2) << text;
  EXPECT_GT(user, 1000);
  EXPECT_EQ(group, user);
  const std::string none = ":\t0000000000000000\n";
  EXPECT_EQ(text.substr(text.find("Cap")), "CapInh" + none + "CapPrm" + none + "CapEff" + none +
                                               "CapAmb" + none + "NoNewPrivs:\t1\n");
}

TEST_F(ProgramsOfRoot, CannotChangeItsFilesOrReadItsSecrets) {
  const TemporaryFolder folder;
  for (const std::string name : {"results", "secret"}) write_content(folder / name, name);
  fs::permissions(folder / "secret", fs::perms::owner_read);
  const std::string results = (folder / "results").string();
  const std::string secret = (folder / "secret").string();
  EXPECT_EQ(output_of(script("cat " + results + "; cat " + secret + " 2>/dev/null; (echo 99:0 >" +
                             results + ") 2>/dev/null || echo ' unchanged'")),
            "results unchanged\n");
  EXPECT_EQ(content_of(folder / "results"), "results");
}

TEST_F(ProgramsOfRoot, HaveAFolderOfTheirOwnWhileTheyRun) {
  const std::string text =
      output_of(script("cd && echo note >\"$TMPDIR/note\" && cat note && [ \"$HOME\" = "
                       "\"$TMPDIR\" ] && pwd && stat -c %a ."));
  ASSERT_TRUE(text.starts_with("note\n/")) << text;
  EXPECT_TRUE(text.ends_with("\n700\n")) << text;
  EXPECT_FALSE(fs::exists(text.substr(5, text.size() - 5 - 5)));
}

TEST_F(ProgramsOfRoot, CanOpenTheirStreamsByName) {
  EXPECT_EQ(output_of(script("echo a >/dev/stdout && echo b >/dev/stderr && : </dev/stdin && echo "
                             "c >/proc/self/fd/1")),
            "a\nc\n");
}

TEST_F(ProgramsOfRoot, KeepTheFolderThatTheirTeamHasGiven) {
  ProgramSpec spec = script("echo $HOME");
  spec.environment.emplace_back("HOME=/given");
  EXPECT_EQ(output_of(spec), "/given\n");
}

TEST_F(ProgramsOfRoot, AreRefusedWithAnExplanationIfTheyCouldNotReadTheirFiles) {
  const TemporaryFolder folder;
  const fs::path file = folder / "team.sh";
  write_content(file, "echo started");
  fs::permissions(file, fs::perms::owner_read);
  const std::string hint =
      ": Permission denied; AutoRef is running as root, so it starts programs as an unprivileged "
      "user, which can only read files that everybody can read: start AutoRef as an ordinary user, "
      "or move the program to a folder that everybody can read";
  EXPECT_EQ(refusal_of(program({"/bin/sh", file.string()})),
            "/bin/sh may not use " + file.string() + hint);
  ProgramSpec relative = program({"/bin/sh", "team.sh"});
  relative.directory = folder.path().string();
  EXPECT_EQ(refusal_of(relative), "/bin/sh may not use team.sh" + hint);
  fs::create_directory(folder / "inside");
  fs::permissions(file, fs::perms::all);
  ProgramSpec below = program({"/bin/sh", "inside/../team.sh"});
  fs::permissions(folder / "inside", fs::perms::none);
  below.directory = folder.path().string();
  EXPECT_EQ(refusal_of(below), "/bin/sh may not use inside/../team.sh" + hint);
  fs::permissions(folder.path(), fs::perms::owner_all);
  EXPECT_EQ(refusal_of(relative), "cannot enter the directory " + folder.path().string() + hint);
  EXPECT_EQ(refusal_of(program({file.string()})),
            file.string() + " may not use " + file.string() + hint);
}

TEST_F(ProgramsOfRoot, ThatEndForLackOfRightsAreExplained) {
  const TemporaryFolder folder;
  const std::string file = (folder / "weights").string();
  write_content(file, "1");
  fs::permissions(file, fs::perms::owner_read);
  std::string fault;
  try {
    ProgramProcess process(script("read weights <" + file + " || exit 1"));
    process.read(process.answer_deadline());
  } catch (const ProgramError& error) {
    fault = error.what();
  }
  EXPECT_NE(
      fault.find(
          " (AutoRef is running as root, so it starts programs as an unprivileged user, which can "
          "only read files that everybody can read); its last lines on standard error:\n"),
      std::string::npos)
      << fault;
}

void give_up_changing_the_user() {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> rights{};
  ASSERT_EQ(syscall(SYS_capget, &header, rights.data()), 0);
  rights[0].effective &= ~(1U << CAP_SETUID);
  rights[0].permitted = rights[0].effective;
  ASSERT_EQ(syscall(SYS_capset, &header, rights.data()), 0);
}

TEST_F(ProgramsOfRoot, AreRefusedWithAnExplanationWhereItCannotGiveUpItsRights) {
  const pid_t child = fork();
  if (child == 0) {
    give_up_changing_the_user();
    const std::string message = refusal_of(script("echo started"));
    const bool is_explained = message.starts_with(
        "cannot start /bin/sh as an unprivileged user: Operation not permitted; AutoRef is running "
        "as root");
    _exit(is_explained && !HasFailure() ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
}

TEST_F(ProgramsOfRoot, HaveDifferentUsersInAllProcesses) {
  const ProgramUser here;
  const ProgramUser also_here;
  EXPECT_NE(here.id(), also_here.id());
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  const pid_t child = fork();
  if (child == 0) {
    std::array<int, 2> ids{};
    for (int& id : ids) id = ProgramUser().id();
    _exit(write(ends[1], ids.data(), sizeof ids) == sizeof ids ? 0 : 1);
  }
  ASSERT_EQ(waitpid(child, nullptr, 0), child);
  std::array<int, 2> ids{};
  ASSERT_EQ(read(ends[0], ids.data(), sizeof ids), static_cast<ssize_t>(sizeof ids));
  for (const int id : ids) {
    EXPECT_NE(id, here.id());
    EXPECT_NE(id, also_here.id());
  }
  EXPECT_EQ(ids[0], ids[1]) << "it is free again afterwards";
}

TEST(TeamPrograms, ReachNeitherEachOtherNorAutoRef) {
  ProgramProcess victim(script("cat"));
  if (!runs_as_root() && !victim.has_namespace())
    GTEST_SKIP() << "skipped: without user namespaces, programs run under the same user";
  const std::string other = "/proc/" + std::to_string(only_child_of(victim.supervisor()));
  const std::string autoref = "/proc/" + std::to_string(getpid());
  EXPECT_EQ(
      output_of(script("for place in " + other + " " + autoref +
                       "; do for fd in 0 1 2; do (echo lost >$place/fd/$fd) 2>/dev/null && "
                       "echo writes $place/fd/$fd; done; head -c 1 $place/environ 2>/dev/null "
                       "&& echo reads $place; head -c 1 $place/mem 2>&1 | grep -v denied; "
                       "done; kill -KILL " +
                       std::to_string(getpid()) + " 2>/dev/null; echo done")),
      "done\n");
  victim.write("frame\n");
  EXPECT_EQ(victim.read(victim.answer_deadline()), "frame\n");
}

}  // namespace
}  // namespace autoref::game
