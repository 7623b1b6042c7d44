#include "runner/io/command.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "runner/io/errors.hpp"

namespace autoref::runner {
namespace {

// Starts the program. Returns 0 and sets `pid`, or returns the error number.
int start(const std::vector<std::string>& words, int out, pid_t& pid) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
  const int error = posix_spawnp(&pid, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

// Call this before waiting for the process to end: a child blocks while the pipe is full.
std::string read_to_end(int descriptor) {
  std::string text;
  std::array<char, 4096> buffer{};
  ssize_t count = 0;
  while ((count = read(descriptor, buffer.data(), buffer.size())) > 0 ||
         (count < 0 && errno == EINTR)) {
    if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return text;
}

int code_of(pid_t pid) {
  int status = 0;
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

std::optional<CommandResult> run_command(const std::vector<std::string>& words) {
  std::array<int, 2> ends{};
  // The program inherits only its standard output: dup2() clears the close-on-exec flag on the
  // copy.
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw io_error("cannot open a pipe", errno);
  pid_t pid = -1;
  const int error = start(words, ends[1], pid);
  close(ends[1]);
  CommandResult result;
  if (error == 0) {
    result.out = read_to_end(ends[0]);
    result.code = code_of(pid);
  }
  close(ends[0]);
  if (error == ENOENT) return std::nullopt;
  if (error != 0) throw io_error(fmt::format("cannot start {}", words[0]), error);
  return result;
}

}  // namespace autoref::runner
