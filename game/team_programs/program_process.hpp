// A team's program as a process that receives and sends bytes.
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

// Owns the program and every process that it starts. These processes run in their own session and
// end with this object or with AutoRef. This class does not interpret the bytes as messages. No
// function blocks beyond its deadline, whatever the program does.
class ProgramProcess {
 public:
  using Clock = std::chrono::steady_clock;

  // Starts the program, under a separate user if this process runs as root. Throws ProgramError if
  // the program cannot be started, and InputOutputError if AutoRef runs out of processes,
  // descriptors or files, or if that user may not read the program.
  explicit ProgramProcess(ProgramSpec spec);
  ~ProgramProcess() { end(0.0); }
  ProgramProcess(const ProgramProcess&) = delete;
  ProgramProcess& operator=(const ProgramProcess&) = delete;

  // Sends bytes without waiting. Bytes that the program does not accept yet are sent during read().
  // A closed input is not an error here: read() reports what happened to the program.
  void write(std::string_view bytes);

  // The deadline for an answer to a request that is sent now.
  Clock::time_point answer_deadline() const;

  // Waits for output and returns what has arrived, at least one byte; valid until the next call.
  // Throws ProgramError if no output arrives by the deadline, or if the program has closed its
  // output or ended. Throws InputOutputError if the system has killed the program for lack of
  // memory.
  std::string_view read(Clock::time_point deadline);

  // Whether there is output that has not been read. Does not wait.
  bool has_output() const;

  // A ProgramError that describes what the program did, for example "sent ...".
  ProgramError fault(std::string_view what) const;

  // Closes the program's input and waits up to `grace_s` for the program to end by itself. Then
  // sends SIGTERM, waits up to `grace_s` again and sends SIGKILL to all of its processes. Returns
  // how the program ended, for example "ended with status 0".
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
  std::uint64_t kills_before_ = 0;   // kills for lack of memory before the program started
  std::optional<ProgramUser> user_;  // nullopt if the program runs under the user of this process
  std::optional<ProgramStderr> stderr_;
  Supervisor supervisor_;
  std::optional<SupervisorReport> report_;
  bool has_reports_ended_ = false;  // the pipe was closed without a report
  bool has_output_begun_ = false;
  std::string pending_;
  std::string received_;
};

}  // namespace autoref::game
