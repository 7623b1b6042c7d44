#include "experiments/report/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <system_error>
#include <thread>

#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/working_folder.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPause{2};
constexpr std::size_t kLongestTrouble = 300;  // characters
constexpr const char* kMessages = "messages.txt";

// Runs gnuplot in the temporary folder and redirects its output to a file there.
class SpawnActions {
 public:
  explicit SpawnActions(const io::WorkingFolder& workplace) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addchdir_np(&actions_, workplace.path().c_str());
    // gnuplot must never wait for input.
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, kMessages,
                                     O_WRONLY | O_CREAT | O_APPEND, 0600);
    posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
  }
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;

  const posix_spawn_file_actions_t* actions() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

// Returns 0 or the error number; ENOENT if gnuplot is not installed.
int start(const io::WorkingFolder& workplace, std::string script, pid_t& process) {
  const SpawnActions actions(workplace);
  std::string program = "gnuplot";
  std::string without_user_settings = "-d";
  const std::array<char*, 4> arguments = {program.data(), without_user_settings.data(),
                                          script.data(), nullptr};
  return posix_spawnp(&process, program.c_str(), actions.actions(), nullptr, arguments.data(),
                      environ);
}

// Waits for the process. Returns why it failed, or an empty string.
std::string end_of(pid_t process, double longest_s) {
  const auto deadline = Clock::now() + std::chrono::duration<double>(longest_s);
  int status = 0;
  pid_t ended = 0;
  while (ended == 0 && Clock::now() < deadline) {
    // Polls, because waitpid() has no timeout.
    ended = waitpid(process, &status, WNOHANG);
    if (ended == 0) std::this_thread::sleep_for(kPause);
  }
  if (ended == 0) {
    kill(process, SIGKILL);
    waitpid(process, &status, 0);
    return fmt::format("gnuplot took longer than {} s", longest_s);
  }
  if (ended == process && WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  return "gnuplot failed";
}

std::string one_line(std::string text) {
  for (char& c : text) c = c == '\n' || c == '\r' || c == '\t' ? ' ' : c;
  const std::size_t begin = text.find_first_not_of(' ');
  return begin == std::string::npos ? "" : text.substr(begin, kLongestTrouble);
}

}  // namespace

Drawing draw(const Plot& plot, double longest_s) {
  const io::WorkingFolder workplace;
  io::replace_file(workplace / (plot.name + ".csv"), plot.csv);
  io::replace_file(workplace / (plot.name + ".gp"), plot.script);
  pid_t process = 0;
  const int error_number = start(workplace, plot.name + ".gp", process);
  if (error_number != 0) {
    return {"", "gnuplot cannot be started: " + std::generic_category().message(error_number),
            error_number == ENOENT};
  }
  const std::string trouble = end_of(process, longest_s);
  const std::string svg = io::read_file(workplace / (plot.name + ".svg")).value_or("");
  // A complete drawing ends with this tag, which exit code 0 alone does not guarantee.
  if (trouble.empty() && svg.find("</svg>") != std::string::npos) return {svg, "", false};
  const std::string messages = one_line(io::read_file(workplace / kMessages).value_or(""));
  return {"", fmt::format("{}: {}", trouble.empty() ? "gnuplot drew nothing" : trouble, messages),
          false};
}

}  // namespace autoref::experiments
