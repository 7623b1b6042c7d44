#include "io/processes/worker_process.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <exception>
#include <utility>

#include "io/errors.hpp"

namespace autoref::io {
namespace {

using Clock = std::chrono::steady_clock;

constexpr ssize_t kLongestMessage = 128 * 1024;
constexpr char kFailed = '\0';  // precedes the message if the environment has failed
constexpr std::size_t kLongestFailure = 10'000;

// A job on its way to a worker, without padding.
struct JobMessage {
  std::uint64_t number;
  std::int64_t attempt;
};

// Main loop of a worker: reads jobs and writes results until the other end closes. Ctrl-C reaches
// the whole process group; only the parent decides what to do about it.
[[noreturn]] void live_as_worker(int socket, pid_t parent, const sigset_t& former_mask,
                                 const WorkerProcess::Work& work) {
  // The kernel kills the worker when its parent dies, for whatever reason. If the parent died
  // before this call, the signal would never come, hence the check.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
  sigprocmask(SIG_SETMASK, &former_mask, nullptr);
  // The other descriptors belong to the parent: the lock on its rows and its ends of other sockets.
  if (socket > 3) close_range(3, static_cast<unsigned>(socket - 1), 0);
  close_range(static_cast<unsigned>(socket + 1), ~0U, 0);
  JobMessage job{};
  while (recv(socket, &job, sizeof job, 0) == sizeof job) {
    std::string payload;
    try {
      payload = work({static_cast<std::size_t>(job.number), static_cast<int>(job.attempt)});
    } catch (const std::exception& error) {
      const std::optional<std::string> failure = environment_failure(error);
      if (!failure) _exit(1);
      payload = kFailed + failure->substr(0, kLongestFailure);
    } catch (...) {
      _exit(1);
    }
    const auto size = static_cast<ssize_t>(payload.size());
    if (send(socket, payload.data(), payload.size(), MSG_NOSIGNAL) != size) _exit(1);
  }
  _exit(0);
}

constexpr std::string_view kEndedBySignal = "its process was ended by signal ";

std::string death_of(int status) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return fmt::format("{}{} ({})", kEndedBySignal, signal, strsignal(signal));
  }
  return fmt::format("its process ended with code {}", WEXITSTATUS(status));
}

}  // namespace

bool was_killed(std::string_view failure) {
  if (!failure.starts_with(kEndedBySignal)) return false;
  int signal = 0;
  failure.remove_prefix(kEndedBySignal.size());
  std::from_chars(failure.data(), failure.data() + failure.size(), signal);
  return signal == SIGKILL || signal == SIGTERM || signal == SIGHUP || signal == SIGINT;
}

EndSignals::EndSignals() {
  // Signals are blocked and read from a signalfd, so poll() waits for them together with the
  // workers' answers and no code has to be async-signal-safe.
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&set, signal);
  sigprocmask(SIG_BLOCK, &set, &former_);
  descriptor_ = signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK);
  if (descriptor_ < 0) throw io_error("cannot watch for signals", errno);
}

EndSignals::~EndSignals() {
  // Drains pending signals: unblocking them would terminate the process.
  count();
  close(descriptor_);
  sigprocmask(SIG_SETMASK, &former_, nullptr);
}

int EndSignals::count() {
  signalfd_siginfo info{};
  while (read(descriptor_, &info, sizeof info) == sizeof info) ++count_;
  return count_;
}

double WorkerProcess::busy_s() const {
  return std::chrono::duration<double>(Clock::now() - began_).count();
}

void WorkerProcess::start(const EndSignals& signals, const Work& work) {
  if (pid_ > 0) return;
  // SOCK_SEQPACKET keeps message boundaries, so one recv() returns one whole answer, and reports
  // the end of the connection when the worker dies. The jobs themselves need no transfer: fork()
  // has copied the parent's memory.
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw io_error("cannot open a socket to a worker", errno);
  }
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) live_as_worker(ends[1], parent, signals.former_mask(), work);
  const int error_number = errno;
  close(ends[1]);
  socket_ = ends[0];
  if (pid_ > 0) return;
  close(socket_);
  throw io_error("cannot start a worker process", error_number);
}

void WorkerProcess::give(const Job& job) {
  job_ = job;
  began_ = Clock::now();
  const JobMessage message{job.number, job.attempt};
  [[maybe_unused]] const ssize_t ignored = send(socket_, &message, sizeof message, MSG_NOSIGNAL);
}

std::optional<WorkerAnswer> WorkerProcess::answer() {
  // Asks for the size first: a buffer for the longest answer would take longer to clear than a row
  // takes to read.
  const ssize_t size = recv(socket_, nullptr, 0, MSG_PEEK | MSG_TRUNC);
  if (size <= 0 || size > kLongestMessage) return std::nullopt;
  std::string payload(static_cast<std::size_t>(size), '\0');
  if (recv(socket_, payload.data(), payload.size(), 0) != size) return std::nullopt;
  if (payload.front() == kFailed) return WorkerAnswer{"", payload.substr(1)};
  return WorkerAnswer{std::move(payload), ""};
}

std::string WorkerProcess::end() {
  job_.reset();
  if (pid_ <= 0) return {};
  kill(pid_, SIGKILL);
  close(socket_);
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  return death_of(status);
}

}  // namespace autoref::io
