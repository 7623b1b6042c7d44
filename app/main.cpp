// The program `autoref`.
#include <fcntl.h>
#include <unistd.h>

#include <csignal>

#include "app/command_line.hpp"

namespace {

// A shell may start a program with its standard streams closed. The files opened next would then
// get the descriptors of these streams, and progress lines could end up in a table of results.
bool fill_standard_streams() {
  int descriptor = open("/dev/null", O_RDWR);
  while (descriptor >= 0 && descriptor <= STDERR_FILENO) descriptor = dup(descriptor);
  return descriptor >= 0 && close(descriptor) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (!fill_standard_streams()) return 74;
  // Report reaching the file size limit as an error instead of letting the signal kill the program.
  std::signal(SIGXFSZ, SIG_IGN);
  return autoref::app::run_command_line(argc, argv);
}
