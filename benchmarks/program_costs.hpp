// Measures the cost of a frame in a game between two programs, relative to bare pipes.
#pragma once

#include <string>
#include <vector>

namespace autoref::benchmarks {

struct ProgramCosts {
  // Time per frame of whole games between two programs, median of the rounds.
  double us_per_frame = 0;
  double echo_us_per_frame = 0;  // time per frame for sending the same bytes to and from the same
                                 // two programs, without a game
  double ratio = 0;              // median of the rounds' ratios
  double x_real_time = 0;        // simulated seconds per wall second in those games
};

// Each round plays a game between two programs that do nothing but answer, and immediately
// afterwards sends the same number of frames through bare pipes, so that a slowdown of the machine
// affects both. `command` starts a program that runs answer_frames(). Throws InputOutputError, and
// std::logic_error if a game is void.
ProgramCosts measure_programs(int rounds, const std::vector<std::string>& command);

void print_program_costs(const std::vector<std::string>& command);

// A team's program that does nothing but answer. It greets with the flat encoding and answers each
// FRAME with a command for each of its robots, until END. Runs on standard input and output.
// Returns the exit code.
int answer_frames();

}  // namespace autoref::benchmarks
