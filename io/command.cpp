#include "io/command.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>

#include "io/errors.hpp"

namespace autoref::io {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPause{2};

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

// The time left, for poll(): -1 if it is unlimited.
int left_ms(Clock::time_point start, double longest_s) {
  if (std::isinf(longest_s)) return -1;
  const double left_s = longest_s - std::chrono::duration<double>(Clock::now() - start).count();
  return static_cast<int>(std::clamp(1000 * left_s, 0.0, 1e9));
}

// Returns false if the time runs out before the other end is closed.
bool read_to_end(int descriptor, Clock::time_point start, double longest_s, std::string& text) {
  std::array<char, 4096> buffer{};
  while (true) {
    pollfd watched{descriptor, POLLIN, 0};
    const int ready = poll(&watched, 1, left_ms(start, longest_s));
    if (ready == 0) return false;
    const ssize_t count = ready < 0 ? -1 : read(descriptor, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return true;
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

// Waits for the end of a process, which may already have closed its output. Returns false if the
// time runs out.
bool wait_for_end(pid_t pid, Clock::time_point start, double longest_s, int& status,
                  rusage& usage) {
  const int options = std::isinf(longest_s) ? 0 : WNOHANG;
  while (true) {
    const pid_t ended = wait4(pid, &status, options, &usage);
    if (ended == pid || (ended < 0 && errno != EINTR)) return true;
    if (left_ms(start, longest_s) == 0) return false;
    if (ended == 0) std::this_thread::sleep_for(kPause);
  }
}

// Reads before waiting for the process to end, since a child blocks while the pipe is full.
CommandResult result_of(pid_t pid, int out, double longest_s) {
  const Clock::time_point start = Clock::now();
  CommandResult result;
  int status = 0;
  rusage usage{};
  result.is_late = !read_to_end(out, start, longest_s, result.out) ||
                   !wait_for_end(pid, start, longest_s, status, usage);
  if (result.is_late) {
    kill(pid, SIGKILL);
    wait_for_end(pid, start, kUnlimited_s, status, usage);
  }
  result.code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  result.processor_s = processor_s(usage);
  return result;
}

}  // namespace

std::optional<CommandResult> run_command(const std::vector<std::string>& words, double longest_s) {
  std::array<int, 2> ends{};
  // The program inherits only its standard output: dup2() clears the close-on-exec flag on the
  // copy.
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw io_error("cannot open a pipe", errno);
  pid_t pid = -1;
  const int error = start(words, ends[1], pid);
  close(ends[1]);
  CommandResult result;
  if (error == 0) result = result_of(pid, ends[0], longest_s);
  close(ends[0]);
  if (error == ENOENT) return std::nullopt;
  if (error != 0) throw io_error(fmt::format("cannot start {}", words[0]), error);
  return result;
}

}  // namespace autoref::io
