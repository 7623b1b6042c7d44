#include "game/team_programs/supervisor.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/capability.h>
#include <linux/close_range.h>
#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>

#include "io/errors.hpp"

// Between fork and exec, only async-signal-safe functions may be called, so text is prepared
// before.
namespace autoref::game {
namespace {

constexpr int kCountEvery_ms = 50;
constexpr std::size_t kMostCounted = 4096;

// A word of the command that names a file or folder.
struct NamedFile {
  int argument;
  std::string path;  // absolute, since many programs open it
};

struct PreparedProgram {
  std::vector<char*> arguments;
  std::vector<char*> environment;
  std::vector<NamedFile> files;
  std::string uid_map;
  std::string gid_map;
  int user;  // kSameUser or the program's user
};

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> result;
  result.reserve(words.size() + 1);
  for (const std::string& word : words) result.push_back(const_cast<char*>(word.c_str()));
  result.push_back(nullptr);
  return result;
}

// A later entry replaces an earlier one of the same name.
std::vector<char*> environment_of(const ProgramSpec& spec) {
  std::vector<char*> result = pointers(spec.environment);
  result.pop_back();
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    const std::string_view name = text.substr(0, text.find('=') + 1);
    const bool is_replaced =
        std::any_of(spec.environment.begin(), spec.environment.end(),
                    [&](const std::string& added) { return added.starts_with(name); });
    if (!is_replaced) result.push_back(*entry);
  }
  result.push_back(nullptr);
  return result;
}

std::vector<NamedFile> files_of(const ProgramSpec& spec) {
  std::vector<NamedFile> files;
  std::error_code error;
  const auto directory =
      std::filesystem::absolute(spec.directory.empty() ? "." : spec.directory, error);
  for (std::size_t i = 0; i < spec.command.size(); ++i) {
    const std::string path = directory / spec.command[i];
    if (!spec.command[i].empty() && std::filesystem::exists(path, error))
      files.push_back({static_cast<int>(i), path});
  }
  return files;
}

[[noreturn]] void fail_to_start(int descriptor, SupervisorReport::Kind kind, int argument = -1) {
  const SupervisorReport report{kind, errno, argument};
  [[maybe_unused]] const ssize_t ignored = write(descriptor, &report, sizeof report);
  _exit(127);
}

void limit(__rlimit_resource resource, rlim_t soft, rlim_t hard) {
  rlimit former{};
  getrlimit(resource, &former);
  const rlimit wanted{std::min(soft, former.rlim_max), std::min(hard, former.rlim_max)};
  setrlimit(resource, &wanted);
}

// Permanently gives up root's user, groups and rights. Returns false if this process is not allowed
// to.
bool leave_root(int user) {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> none{};
  return syscall(SYS_setgroups, 0, nullptr) == 0 && syscall(SYS_setresgid, user, user, user) == 0 &&
         syscall(SYS_setresuid, user, user, user) == 0 &&
         syscall(SYS_capset, &header, none.data()) == 0 &&
         prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0;
}

void check_files(const ProgramEnds& ends, const PreparedProgram& prepared) {
  for (const NamedFile& file : prepared.files) {
    if (access(file.path.c_str(), file.argument == 0 ? X_OK : R_OK) != 0)
      fail_to_start(ends.started, SupervisorReport::kUnreadable, file.argument);
  }
}

void limit_all(const ProgramLimits& limits, bool has_own_user) {
  // If the program had no separate user, the limit would count all processes of AutoRef's user.
  if (has_own_user) limit(RLIMIT_NPROC, limits.tasks, limits.tasks);
  limit(RLIMIT_DATA, limits.memory_bytes, limits.memory_bytes);
  limit(RLIMIT_NOFILE, limits.open_files, limits.open_files);
  limit(RLIMIT_CPU, limits.cpu_s, limits.cpu_s + 1);
  limit(RLIMIT_CORE, 0, 0);
}

void default_signals() {
  for (int signal = 1; signal < NSIG; ++signal) std::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

[[noreturn]] void become_program(const ProgramSpec& spec, const ProgramEnds& ends,
                                 const PreparedProgram& prepared, unsigned long flags) {
  const bool leaves_root = prepared.user != kSameUser;
  if (leaves_root && !leave_root(prepared.user))
    fail_to_start(ends.started, SupervisorReport::kNoUser);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  setsid();
  default_signals();
  if (!spec.directory.empty() && chdir(spec.directory.c_str()) != 0) {
    fail_to_start(ends.started, SupervisorReport::kNoDirectory);
  }
  if (leaves_root) check_files(ends, prepared);
  dup2(ends.in, STDIN_FILENO);
  dup2(ends.out, STDOUT_FILENO);
  dup2(ends.err, STDERR_FILENO);
  close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);
  limit_all(spec.limits, leaves_root || (flags & CLONE_NEWUSER) != 0);
  execvpe(prepared.arguments[0], prepared.arguments.data(), prepared.environment.data());
  fail_to_start(ends.started, SupervisorReport::kNoProgram);
}

// Reads the children of a process from the kernel's list, such as "12 34 ". Returns how many were
// added.
std::size_t read_children(pid_t pid, pid_t* list, std::size_t room) {
  std::array<char, 64> path{};
  char digits[12];
  int length = 0;
  for (pid_t rest = pid; rest > 0; rest /= 10)
    digits[length++] = static_cast<char>('0' + rest % 10);
  std::size_t at = 0;
  const auto put = [&](const char* text) {
    while (*text != '\0') path[at++] = *text++;
  };
  const auto put_pid = [&] {
    for (int i = length; i > 0; --i) path[at++] = digits[i - 1];
  };
  put("/proc/");
  if (pid > 0)
    put_pid();
  else
    put("thread-self");
  if (pid > 0) {
    put("/task/");
    put_pid();
  }
  put("/children");
  const int file = open(path.data(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return 0;
  std::array<char, 4096> text{};
  std::size_t count = 0;
  pid_t number = 0;
  ssize_t size = 0;
  while ((size = read(file, text.data(), text.size())) > 0) {
    for (ssize_t i = 0; i < size; ++i) {
      const char c = text[static_cast<std::size_t>(i)];
      if (c >= '0' && c <= '9') {
        number = number * 10 + (c - '0');
      } else if (number > 0) {
        if (count < room) list[count++] = number;
        number = 0;
      }
    }
  }
  close(file);
  return count;
}

// Number of descendants of this process. Process ids are those in /proc, not in the namespace.
std::size_t count_descendants() {
  static std::array<pid_t, kMostCounted> found;
  std::size_t count = read_children(0, found.data(), found.size());
  for (std::size_t i = 0; i < count; ++i) {
    count += read_children(found[i], found.data() + count, found.size() - count);
  }
  return count;
}

// Orphans are reparented to this process (it is their subreaper), so all are found eventually.
void kill_all(bool has_namespace) {
  static std::array<pid_t, kMostCounted> children;
  for (int round = 0; round < 2000; ++round) {
    if (has_namespace) {
      kill(-1, SIGKILL);
    } else {
      const std::size_t count = read_children(0, children.data(), children.size());
      for (std::size_t i = 0; i < count; ++i) kill(children[i], SIGKILL);
    }
    pid_t ended = 0;
    while ((ended = waitpid(-1, nullptr, WNOHANG)) > 0) {
    }
    if (ended < 0 && errno == ECHILD) return;
    if (round > 20) poll(nullptr, 0, 1);
  }
}

[[noreturn]] void report_and_end(const ProgramEnds& ends, bool has_namespace,
                                 SupervisorReport report) {
  [[maybe_unused]] const ssize_t ignored = write(ends.reports, &report, sizeof report);
  kill_all(has_namespace);
  _exit(0);
}

// Reaps child processes; ends if the program itself has ended.
void reap(const ProgramEnds& ends, pid_t program, bool has_namespace) {
  int status = 0;
  pid_t ended = 0;
  while ((ended = waitpid(-1, &status, WNOHANG)) > 0) {
    if (ended == program) {
      report_and_end(ends, has_namespace, {SupervisorReport::kEnded, status});
    }
  }
}

[[noreturn]] void supervise(const ProgramSpec& spec, const ProgramEnds& ends, pid_t program,
                            int signals, bool has_namespace) {
  std::array<pollfd, 2> watched{pollfd{ends.life, POLLIN, 0}, pollfd{signals, POLLIN, 0}};
  for (;;) {
    poll(watched.data(), watched.size(), kCountEvery_ms);
    signalfd_siginfo info{};
    if (watched[1].revents != 0 && read(signals, &info, sizeof info) < 0) errno = 0;
    reap(ends, program, has_namespace);
    char byte = 0;
    if (watched[0].revents != 0 && read(ends.life, &byte, 1) <= 0) {
      kill_all(has_namespace);
      _exit(0);
    }
    if (byte != 0) kill(-program, SIGTERM);
    if (count_descendants() > static_cast<std::size_t>(spec.limits.processes)) {
      report_and_end(ends, has_namespace, {SupervisorReport::kTooManyProcesses, 0});
    }
  }
}

void write_map(const char* path, std::string_view text) {
  const int file = open(path, O_WRONLY | O_CLOEXEC);
  if (file < 0) return;
  [[maybe_unused]] const ssize_t ignored = write(file, text.data(), text.size());
  close(file);
}

void close_all_but(int a, int b) {
  if (a > b) std::swap(a, b);
  if (a > 0) close_range(0, static_cast<unsigned>(a - 1), 0);
  if (b > a + 1) close_range(static_cast<unsigned>(a + 1), static_cast<unsigned>(b - 1), 0);
  close_range(static_cast<unsigned>(b + 1), ~0U, 0);
}

[[noreturn]] void live_as_supervisor(const ProgramSpec& spec, const ProgramEnds& ends,
                                     const PreparedProgram& prepared, unsigned long flags) {
  if ((flags & CLONE_NEWUSER) != 0) {
    write_map("/proc/thread-self/setgroups", "deny");
    write_map("/proc/thread-self/uid_map", prepared.uid_map);
    write_map("/proc/thread-self/gid_map", prepared.gid_map);
  }
  setsid();
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, nullptr);
  std::signal(SIGCHLD, SIG_DFL);
  const pid_t program =
      static_cast<pid_t>(syscall(SYS_clone, SIGCHLD, nullptr, nullptr, nullptr, nullptr));
  if (program == 0) become_program(spec, ends, prepared, flags);
  if (program < 0) fail_to_start(ends.started, SupervisorReport::kNoProcess);
  close_all_but(ends.life, ends.reports);
  sigset_t child;
  sigemptyset(&child);
  sigaddset(&child, SIGCHLD);
  const int signals = signalfd(-1, &child, SFD_CLOEXEC | SFD_NONBLOCK);
  supervise(spec, ends, program, signals, (flags & CLONE_NEWPID) != 0);
}

}  // namespace

Supervisor start_supervisor(const ProgramSpec& spec, const ProgramEnds& ends, int user) {
  const PreparedProgram prepared{pointers(spec.command),
                                 environment_of(spec),
                                 files_of(spec),
                                 fmt::format("{0} {0} 1", geteuid()),
                                 fmt::format("{0} {0} 1", getegid()),
                                 user};
  // Root can create PID namespaces unless a container forbids it. Other users need a user
  // namespace.
  const unsigned long namespaces = user == kSameUser ? CLONE_NEWUSER | CLONE_NEWPID : CLONE_NEWPID;
  for (const unsigned long flags : {namespaces, 0UL}) {
    const auto pid =
        static_cast<pid_t>(syscall(SYS_clone, flags | SIGCHLD, nullptr, nullptr, nullptr, nullptr));
    if (pid == 0) live_as_supervisor(spec, ends, prepared, flags);
    if (pid > 0) return {pid, flags != 0};
  }
  throw io::io_error("cannot start a process for a team's program", errno);
}

}  // namespace autoref::game
