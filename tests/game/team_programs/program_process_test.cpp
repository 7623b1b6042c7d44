#include "game/team_programs/program_process.hpp"

#include <dirent.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "tests/game/team_programs/marked_processes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace autoref::game {
namespace {

using std::chrono::milliseconds;

// Programs that answer or end have a minute for it, however busy the machine is.
ProgramSpec shell(const std::string& script) {
  ProgramSpec spec;
  spec.command = {"/bin/sh", "-c", script};
  spec.environment = {marker()};
  spec.limits.answer_s = 60;
  return spec;
}

// A script that never answers.
ProgramSpec silent_shell(const std::string& script) {
  ProgramSpec spec = shell(script);
  spec.limits.answer_s = 0.5;
  return spec;
}

std::string read_all(ProgramProcess& program, std::size_t bytes) {
  const auto deadline = ProgramProcess::Clock::now() + std::chrono::minutes(1);
  std::string text;
  while (text.size() < bytes) text += program.read(deadline);
  return text;
}

// What the first answer, or the end of the output, is reported as.
std::string fault_of(ProgramSpec spec) {
  std::string fault;
  try {
    ProgramProcess program(std::move(spec));
    program.write("frame\n");
    for (;;) program.read(program.answer_deadline());
  } catch (const ProgramError& error) {
    fault = error.what();
  }
  EXPECT_EQ(marked_processes(), 0);
  return fault;
}

TEST(ProgramProcess, PassesBytesThroughAndEndsWithItsInput) {
  ProgramProcess program(shell("cat"));
  program.write("one frame\n");
  EXPECT_EQ(read_all(program, 10), "one frame\n");
  EXPECT_GE(marked_processes(), 1);
  EXPECT_EQ(program.end(60.0), "ended with status 0");
  EXPECT_EQ(marked_processes(), 0);
}

TEST(ProgramProcess, SendsMoreThanPipesHold) {
  ProgramProcess program(shell("cat"));
  const std::string bytes(1 << 20, 'x');
  program.write(bytes);
  EXPECT_EQ(read_all(program, bytes.size()), bytes);
}

TEST(ProgramProcess, SaysThatThereIsNoSuchProgram) {
  ProgramSpec spec = shell("");
  spec.command = {"/no/such/program"};
  EXPECT_EQ(fault_of(spec), "cannot start /no/such/program: No such file or directory");
}

TEST(ProgramProcess, SaysThatThereIsNoSuchDirectory) {
  ProgramSpec spec = shell("cat");
  spec.directory = "/no/such/folder";
  EXPECT_EQ(fault_of(spec),
            "cannot enter the directory /no/such/folder: No such file or directory");
}

TEST(ProgramProcess, SaysThatAProgramHangs) {
  EXPECT_EQ(fault_of(silent_shell("sleep 1000")), "/bin/sh did not answer within 0.5 s");
}

TEST(ProgramProcess, SaysThatAProgramNeverReads) {
  ProgramProcess program(silent_shell("sleep 1000"));
  program.write(std::string(1 << 20, 'x'));
  EXPECT_THROW(program.read(program.answer_deadline()), ProgramError);
}

TEST(ProgramProcess, QuotesTheLastLinesOfAProgramThatEnds) {
  EXPECT_EQ(fault_of(shell("echo no ball >&2; exit 3")),
            "/bin/sh ended with status 3; its last lines on standard error:\nno ball");
}

TEST(ProgramProcess, SaysWhichSignalKilledAProgram) {
  EXPECT_EQ(fault_of(shell("kill -SEGV $$")),
            "/bin/sh was killed by signal 11 (Segmentation fault)");
}

TEST(ProgramProcess, SaysThatAProgramClosedItsOutput) {
  EXPECT_EQ(fault_of(shell("exec >&-; sleep 100")), "/bin/sh closed its output");
}

TEST(ProgramProcess, SurvivesAProgramThatClosedItsInput) {
  ProgramProcess program(silent_shell("exec <&-; echo early; sleep 1000"));
  EXPECT_EQ(read_all(program, 6), "early\n");
  program.write("frame\n");
  EXPECT_THROW(program.read(program.answer_deadline()), ProgramError);
}

TEST(ProgramProcess, EndsAProgramThatWritesEndlessly) {
  {
    ProgramProcess program(shell("yes"));
    EXPECT_GE(read_all(program, 1 << 20).size(), 1U << 20);
  }
  EXPECT_EQ(marked_processes(), 0);
}

TEST(ProgramProcess, CutsAFloodOnStandardError) {
  const TemporaryFolder folder;
  ProgramSpec spec = shell("yes | head -c 1000000 >&2; echo done; cat");
  spec.stderr_file = folder / "flood";
  spec.limits.stderr_bytes = 1000;
  ProgramProcess program(spec);
  EXPECT_EQ(read_all(program, 5), "done\n");  // so the whole flood was taken
  EXPECT_EQ(std::filesystem::file_size(spec.stderr_file), 1000U);
}

TEST(ProgramProcess, EndsAProgramWithTooManyProcesses) {
  ProgramSpec spec = shell("(while :; do sleep 1000 & done) 2>/dev/null; exec sleep 1000");
  spec.limits.processes = 20;
  spec.limits.answer_s = 600;
  EXPECT_EQ(fault_of(spec), "/bin/sh started more than 20 processes");
}

// A program that starts processes until it cannot, and says how many there were.
ProgramSpec multiplying_program(std::uint64_t tasks) {
  ProgramSpec spec = shell(
      "n=$( (n=0; while :; do sleep 1000 >&- & n=$((n+1)); echo $n; done) 2>/dev/null | tail -n 1);"
      "echo $n; exec sleep 1000");
  spec.limits.processes = 1000;
  spec.limits.tasks = tasks;
  spec.limits.answer_s = 600;
  return spec;
}

// Without a user namespace or a user of its own, a program is only counted (docs/team-programs.md).
TEST(ProgramProcess, CannotStartMoreTasksThanItsLimit) {
  ProgramProcess program(multiplying_program(40));
  if (!program.has_namespace()) GTEST_SKIP() << "skipped: namespaces are not allowed here";
  const int started = std::stoi(read_all(program, 3));
  EXPECT_LE(started, 40);
  EXPECT_GE(started, 30);
}

TEST(ProgramProcess, LeavesNothingOfAForkBomb) {
  ProgramSpec spec = shell("b() { b | b & }; b; exec sleep 1000");
  spec.limits.processes = 20;
  spec.limits.tasks = 60;
  fault_of(spec);
  EXPECT_EQ(marked_processes(), 0);
}

TEST(ProgramProcess, EndsAChildThatDetachedItself) {
  EXPECT_EQ(fault_of(shell("setsid sh -c 'sleep 100 & sleep 100' >/dev/null 2>&1 & exit 0")),
            "/bin/sh ended with status 0");
}

TEST(ProgramProcess, EndsAProgramThatIgnoresSigterm) {
  ProgramProcess program(shell("trap '' TERM; echo ready; while :; do sleep 1; done"));
  read_all(program, 6);
  EXPECT_EQ(program.end(0.1), "was ended");
  EXPECT_EQ(marked_processes(), 0);
}

TEST(ProgramProcess, LimitsMemoryFilesAndTime) {
  ProgramSpec spec = shell("ulimit -d; ulimit -n; ulimit -t; sleep 100");
  spec.limits.memory_bytes = 64 << 20;
  spec.limits.open_files = 12;
  spec.limits.cpu_s = 7;
  ProgramProcess program(spec);
  EXPECT_EQ(read_all(program, 11), "65536\n12\n7\n");
}

TEST(ProgramProcess, EndsAProgramThatSpins) {
  ProgramSpec spec = shell("while :; do :; done");
  spec.limits.cpu_s = 1;
  spec.limits.answer_s = 600;
  EXPECT_EQ(fault_of(spec), "/bin/sh was killed by signal 24 (CPU time limit exceeded)");
}

// A program with a detached child below a worker that is killed. Returns the supervisor.
pid_t killed_worker(bool with_supervisor) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return -1;
  marker();
  const pid_t worker = fork();
  if (worker == 0) {
    ProgramProcess program(shell("setsid sleep 100 & echo ready; cat"));
    read_all(program, 6);
    const pid_t number = program.has_namespace() ? program.supervisor() : -program.supervisor();
    if (write(ends[1], &number, sizeof number) == sizeof number) pause();
    _exit(1);
  }
  pid_t supervisor = 0;
  EXPECT_EQ(read(ends[0], &supervisor, sizeof supervisor), ssize_t{sizeof supervisor});
  for (const int end : ends) close(end);
  kill(worker, SIGKILL);
  if (with_supervisor && supervisor > 0) kill(supervisor, SIGKILL);
  waitpid(worker, nullptr, 0);
  for (int i = 0; i < 6000 && marked_processes() > 0; ++i) {
    std::this_thread::sleep_for(milliseconds(10));
  }
  return supervisor;
}

TEST(ProgramProcess, LeavesNothingWhenItsWorkerIsKilled) {
  killed_worker(false);
  EXPECT_EQ(marked_processes(), 0);
}

TEST(ProgramProcess, LeavesNothingWhenEverythingIsKilled) {
  if (killed_worker(true) < 0) GTEST_SKIP() << "PID namespaces are not allowed here";
  EXPECT_EQ(marked_processes(), 0);
}

}  // namespace
}  // namespace autoref::game
