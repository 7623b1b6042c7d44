// Measures the cost of a frame in a game between two programs, relative to bare pipes.
#pragma once

#include <string>
#include <vector>

namespace autoref::benchmarks {

struct ProgramCosts {
  double us_per_frame = 0;  // for whole games between two programs, median of the rounds
  double echo_us_per_frame =
      0;                   // for the same bytes to and from the same two programs, without a game
  double ratio = 0;        // median of the rounds' ratios
  double x_real_time = 0;  // simulated seconds per wall second of those games
};

// Each round plays a game between two programs that do nothing but answer, and immediately
// afterwards sends the same number of frames through bare pipes, so that a slowdown of the machine
// affects both. `command` starts such a program: answer_frames(). Throws InputOutputError, and
// std::logic_error if a game is void.
ProgramCosts measure_programs(int rounds, const std::vector<std::string>& command);

void print_program_costs(const std::vector<std::string>& command);

// The team's program that does nothing but answer: it greets in flat records and answers each FRAME
// with a command for each of its robots, until END. Runs on standard input and output. Returns the
// exit code.
int answer_frames();

}  // namespace autoref::benchmarks
