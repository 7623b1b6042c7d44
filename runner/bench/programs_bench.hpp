// Measures what a frame of a game between two programs costs, relative to bare pipes.
#pragma once

namespace autoref::runner {

struct ProgramsBench {
  double us_per_frame = 0;  // of whole games between two programs, median of the rounds
  double echo_us_per_frame =
      0;                   // of the same bytes to and from the same two programs, without a game
  double ratio = 0;        // median of the rounds' ratios
  double x_real_time = 0;  // simulated seconds per wall second of those games
};

// Each round plays a game between two programs, which do nothing but answer, and immediately
// afterwards sends as many frames through bare pipes, so a slowdown of the machine affects both.
// `program` is the path of AutoRef, which plays the teams (answering_program.hpp). Throws
// InputOutputError, and std::logic_error if a game is void.
ProgramsBench bench_programs(int rounds, const char* program);

// Runs the verb: prints the result to stdout, with `json` as one JSON object. Returns the exit
// code.
int run_programs_bench(bool json);

}  // namespace autoref::runner
