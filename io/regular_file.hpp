// Opens files whose names another program can have given to something else.
#pragma once

#include <filesystem>

namespace autoref::io {

// Opens a file as open(2) does, with O_CLOEXEC, but never waits for another program and never
// touches a terminal or a device. `flags` are those of open(2); new files may be read and written
// by everybody whom the umask allows. Returns the descriptor, or -1 with errno if the file cannot
// be opened. Throws InputOutputError if the name leads to a FIFO, a device, a socket or a folder,
// or with O_NOFOLLOW to a symbolic link.
int open_regular_file(const std::filesystem::path& path, int flags);

}  // namespace autoref::io
