// A team's program as a process: bytes in, bytes out.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "game/team_programs/program_spec.hpp"
#include "game/team_programs/program_stderr.hpp"
#include "game/team_programs/supervisor.hpp"

namespace autoref::game {

// Owns the program and every process that it starts, in a session of their own; they end with this
// object, or with AutoRef. Knows nothing of messages. Nothing here blocks beyond its deadline,
// whatever the program does.
class ProgramProcess {
 public:
  using Clock = std::chrono::steady_clock;

  // Starts the program, under a user of its own if this process runs as root. Throws ProgramError
  // if it cannot be started, InputOutputError if AutoRef has no process, descriptor or file for it,
  // or that user may not read it.
  explicit ProgramProcess(ProgramSpec spec);
  ~ProgramProcess() { end(0.0); }
  ProgramProcess(const ProgramProcess&) = delete;
  ProgramProcess& operator=(const ProgramProcess&) = delete;

  // Sends bytes without waiting. What the program does not take yet goes out during read(). A
  // closed input is not an error: read() reports what became of the program.
  void write(std::string_view bytes);

  // When an answer that is asked for now is late.
  Clock::time_point answer_deadline() const;

  // Waits for output and returns what has arrived, at least one byte; valid until the next call.
  // Throws ProgramError if there is none by the deadline, or the program has closed its output or
  // ended, and InputOutputError if the system has killed it for lack of memory.
  std::string_view read(Clock::time_point deadline);

  // Whether there is output that has not been read. Does not wait.
  bool has_output() const;

  // A ProgramError that says what the program did, "sent ..." for example.
  ProgramError fault(std::string_view what) const;

  // Closes the program's input, gives it the time to end by itself, then SIGTERM and as much time
  // again, then SIGKILL to all of its processes. Returns how it ended, "ended with status 0".
  std::string end(double grace_s);

  bool has_namespace() const { return supervisor_.has_namespace; }
  pid_t supervisor() const { return supervisor_.pid; }  // -1 after end()

 private:
  void wait_for_start(int started);
  void send_pending();
  bool wait(Clock::time_point deadline, bool for_output);
  bool take_report(Clock::time_point deadline);
  void close_input();
  std::string how_it_ended() const;
  bool was_killed_from_outside() const;
  bool lacked_memory() const;
  [[noreturn]] void report_closed_output();

  ProgramSpec spec_;
  int in_ = -1;
  int out_ = -1;
  int life_ = -1;
  int reports_ = -1;
  std::uint64_t kills_before_ = 0;   // by the system, for lack of memory
  std::optional<ProgramUser> user_;  // unless the program runs under this process's
  std::optional<ProgramStderr> stderr_;
  Supervisor supervisor_;
  std::optional<SupervisorReport> report_;
  bool has_reports_ended_ = false;  // without a report
  bool has_output_begun_ = false;
  std::string pending_;
  std::string received_;
};

}  // namespace autoref::game
