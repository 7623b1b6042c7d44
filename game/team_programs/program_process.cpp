#include "game/team_programs/program_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <utility>

#include "io/errors.hpp"
#include "io/files.hpp"

namespace autoref::game {
namespace {

using ProgramClock = ProgramProcess::Clock;

constexpr std::size_t kOutput_bytes = 64 * 1024;
constexpr double kLongestEnd_s = 5.0;  // until the kernel has ended everything
// Longest time from a closed output to the status, on a busy machine.
constexpr double kStatus_s = 5.0;

ProgramClock::time_point after(double seconds) {
  return ProgramClock::now() +
         std::chrono::duration_cast<ProgramClock::duration>(std::chrono::duration<double>(seconds));
}

int milliseconds_until(ProgramClock::time_point deadline) {
  const std::chrono::duration<double, std::milli> left = deadline - ProgramClock::now();
  return static_cast<int>(std::ceil(std::clamp(left.count(), 0.0, 1e9)));
}

void close_once(int& descriptor) {
  if (descriptor >= 0) close(descriptor);
  descriptor = -1;
}

// A pipe that closes its ends unless they are released. There are six pipes, and opening any of
// them may fail.
class Pipe {
 public:
  Pipe() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) throw io::io_error("cannot open a pipe", errno);
    // The program must not get AutoRef's standard streams, even if AutoRef has closed its own.
    for (int& end : ends_) {
      if (end > STDERR_FILENO) continue;
      const int higher = fcntl(end, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
      close_once(end);
      end = higher;
    }
  }
  ~Pipe() {
    for (int& end : ends_) close_once(end);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int reader() const { return ends_[0]; }
  int writer() const { return ends_[1]; }
  void close_writer() { close_once(ends_[1]); }
  int release(std::size_t end) {
    fcntl(ends_.at(end), F_SETFL, O_NONBLOCK);
    return std::exchange(ends_.at(end), -1);
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

std::string start_failure(const ProgramSpec& spec, const SupervisorReport& report) {
  const char* reason = strerror(report.value);
  switch (report.kind) {
    case SupervisorReport::kNoUser:
      return fmt::format("cannot start {} as an unprivileged user: {}", spec.command[0], reason);
    case SupervisorReport::kNoDirectory:
      return fmt::format("cannot enter the directory {}: {}", spec.directory, reason);
    case SupervisorReport::kUnreadable:
      return fmt::format("{} may not use {}: {}", spec.command[0],
                         spec.command.at(static_cast<std::size_t>(report.argument)), reason);
    case SupervisorReport::kNoProgram:
      return fmt::format("cannot start {}: {}", spec.command[0], reason);
    default:
      return fmt::format("cannot start a process for {}: {}", spec.command[0], reason);
  }
}

// Added to the error message if the program that fails has fewer rights than AutoRef.
constexpr const char* kMayDoLess =
    "AutoRef is running as root, so it starts programs as an unprivileged user, which can only "
    "read files that everybody can read";
constexpr const char* kHowToLetIt =
    "start AutoRef as an ordinary user, or move the program to a folder that everybody can read";

// The specification's own variables take precedence over the added ones.
ProgramSpec with_environment(ProgramSpec spec, const std::vector<std::string>& added) {
  for (const std::string& entry : added) {
    const std::string name = entry.substr(0, entry.find('=') + 1);
    const bool is_given =
        std::any_of(spec.environment.begin(), spec.environment.end(),
                    [&name](const std::string& given) { return given.starts_with(name); });
    if (!is_given) spec.environment.push_back(entry);
  }
  return spec;
}

// The number of processes that the system has killed since boot because it ran out of memory.
std::uint64_t kills_for_memory() {
  std::ifstream counters("/proc/vmstat");
  std::string name;
  std::uint64_t count = 0;
  while (counters >> name >> count) {
    if (name == "oom_kill") return count;
  }
  return 0;
}

}  // namespace

ProgramProcess::ProgramProcess(ProgramSpec spec) : spec_(std::move(spec)) {
  if (spec_.command.empty()) throw ProgramError("no program is given");
  kills_before_ = kills_for_memory();
  Pipe in;
  Pipe out;
  Pipe err;
  Pipe life;
  Pipe reports;
  Pipe started;
  stderr_.emplace(err.release(0), spec_);
  if (runs_as_root()) {
    user_.emplace();
    // Programs open /dev/stderr and the like by name, which is allowed only for a pipe's owner.
    for (const int end : {in.reader(), out.writer(), err.writer()}) user_->give(end);
  }
  supervisor_ = start_supervisor(
      user_ ? with_environment(spec_, user_->environment()) : spec_,
      {in.reader(), out.writer(), err.writer(), life.reader(), reports.writer(), started.writer()},
      user_ ? user_->id() : kSameUser);
  in_ = in.release(1);
  out_ = out.release(0);
  life_ = life.release(1);
  reports_ = reports.release(0);
  received_.resize(kOutput_bytes);
  started.close_writer();
  wait_for_start(started.reader());
}

// If the program starts, the pipe is closed without a report, because exec() replaces the process
// that would report a failure.
void ProgramProcess::wait_for_start(int started) {
  SupervisorReport failure;
  ssize_t size = 0;
  while ((size = ::read(started, &failure, sizeof failure)) < 0 && errno == EINTR) {
  }
  if (size != sizeof failure) return;
  end(0.0);
  const std::string what = start_failure(spec_, failure);
  if (user_ && (failure.value == EACCES || failure.kind == SupervisorReport::kNoUser))
    throw io::InputOutputError(fmt::format("{}; {}: {}", what, kMayDoLess, kHowToLetIt));
  if (io::is_shortage(failure.value)) throw io::InputOutputError(what);
  throw ProgramError(what);
}

void ProgramProcess::write(std::string_view bytes) {
  if (in_ < 0) return;
  pending_ += bytes;
  send_pending();
}

void ProgramProcess::send_pending() {
  const ssize_t written = io::write_without_signal(in_, pending_);
  if (written > 0) pending_.erase(0, static_cast<std::size_t>(written));
  if (written < 0 && errno != EAGAIN && errno != EINTR) close_input();
}

void ProgramProcess::close_input() {
  close_once(in_);
  pending_.clear();
}

ProgramClock::time_point ProgramProcess::answer_deadline() const {
  return after(spec_.limits.answer_s);
}

// Serves the program's input and standard error until its output or, without `for_output`, a report
// has arrived. Returns false at the deadline.
bool ProgramProcess::wait(Clock::time_point deadline, bool for_output) {
  for (;;) {
    const int writing = pending_.empty() ? -1 : in_;
    std::array<pollfd, 3> watched{pollfd{for_output ? out_ : reports_, POLLIN, 0},
                                  pollfd{stderr_->descriptor(), POLLIN, 0},
                                  pollfd{writing, POLLOUT, 0}};
    const int ready = poll(watched.data(), watched.size(), milliseconds_until(deadline));
    if (watched[1].revents != 0) stderr_->drain();
    if (watched[2].revents != 0) send_pending();
    if (ready > 0 && watched[0].revents != 0) return true;
    if (Clock::now() >= deadline) return false;
  }
}

std::string_view ProgramProcess::read(Clock::time_point deadline) {
  for (;;) {
    if (out_ < 0) report_closed_output();
    if (!wait(deadline, true)) {
      throw fault(fmt::format("did not answer within {:g} s", spec_.limits.answer_s));
    }
    const ssize_t size = ::read(out_, received_.data(), received_.size());
    has_output_begun_ = has_output_begun_ || size > 0;
    if (size > 0) return std::string_view(received_).substr(0, static_cast<std::size_t>(size));
    if (size == 0) close_once(out_);
  }
}

bool ProgramProcess::has_output() const {
  pollfd watched{out_, POLLIN, 0};
  return poll(&watched, 1, 0) > 0 && (watched.revents & POLLIN) != 0;
}

void ProgramProcess::report_closed_output() {
  const bool has_ended = take_report(after(kStatus_s));
  for (int i = 0; i < 64 && stderr_->drain(); ++i) {
  }
  if (lacked_memory())
    throw io::InputOutputError(
        fmt::format("the system did not have enough memory for {}", spec_.command[0]));
  throw fault(has_ended ? how_it_ended() : "closed its output");
}

bool ProgramProcess::take_report(Clock::time_point deadline) {
  if (report_) return true;
  if (reports_ < 0 || !wait(deadline, false)) return false;
  SupervisorReport report;
  if (::read(reports_, &report, sizeof report) == sizeof report) report_ = report;
  has_reports_ended_ = !report_;
  return true;
}

// If there is no report, the supervisor was killed. In its own namespace, a program can kill itself
// but not its supervisor.
bool ProgramProcess::was_killed_from_outside() const {
  return out_ < 0 && !report_ && has_reports_ended_ && supervisor_.has_namespace;
}

// The system kills processes that use much memory, but only counts them.
bool ProgramProcess::lacked_memory() const {
  const bool is_killed = report_ && report_->kind == SupervisorReport::kEnded &&
                         WIFSIGNALED(report_->value) && WTERMSIG(report_->value) == SIGKILL;
  return is_killed && kills_for_memory() > kills_before_;
}

std::string ProgramProcess::how_it_ended() const {
  if (!report_) return has_reports_ended_ ? "was killed together with its supervisor" : "was ended";
  if (report_->kind == SupervisorReport::kTooManyProcesses) {
    return fmt::format("started more than {} processes", spec_.limits.processes);
  }
  const int status = report_->value;
  if (!WIFSIGNALED(status)) return fmt::format("ended with status {}", WEXITSTATUS(status));
  const int signal = WTERMSIG(status);
  return fmt::format("was killed by signal {} ({})", signal, strsignal(signal));
}

ProgramError ProgramProcess::fault(std::string_view what) const {
  const std::string lines = stderr_->last_lines();
  const std::string heading = lines.empty() ? "" : "; its last lines on standard error:\n";
  const bool lacked_rights =
      user_ && !has_output_begun_ && lines.find(strerror(EACCES)) != std::string::npos;
  const std::string hint = lacked_rights ? fmt::format(" ({})", kMayDoLess) : std::string();
  return ProgramError(fmt::format("{} {}{}{}{}", spec_.command[0], what, hint, heading, lines),
                      was_killed_from_outside());
}

std::string ProgramProcess::end(double grace_s) {
  if (supervisor_.pid <= 0) return how_it_ended();
  close_input();
  // Unread output must not keep the program from ending.
  close_once(out_);
  if (!take_report(after(grace_s)) && grace_s > 0.0) {
    io::write_without_signal(life_, "T");
    take_report(after(grace_s));
  }
  close_once(life_);
  // The supervisor closes its end of the reports when all processes have ended.
  const Clock::time_point deadline = after(kLongestEnd_s);
  while (waitpid(supervisor_.pid, nullptr, WNOHANG) == 0) {
    if (Clock::now() >= deadline) kill(supervisor_.pid, SIGKILL);
    stderr_->drain();
    poll(nullptr, 0, 1);
  }
  for (int i = 0; i < 64 && stderr_->drain(); ++i) {
  }
  close_once(reports_);
  supervisor_.pid = -1;
  return how_it_ended();
}

}  // namespace autoref::game
