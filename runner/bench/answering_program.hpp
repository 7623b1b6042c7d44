// The team's program that benchmarks and tests use: it does nothing but answer.
#pragma once

namespace autoref::runner {

// Greets in flat records, and answers each FRAME with a command for each of its robots, until END.
// Runs on standard input and output. Returns the exit code.
int answer_frames();

}  // namespace autoref::runner
