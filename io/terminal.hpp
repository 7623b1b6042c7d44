// The terminal behind a stream.
#pragma once

#include <cstddef>
#include <cstdio>

namespace autoref::io {

bool is_terminal(std::FILE* stream);

// Width of text written to the stream, in characters. For a terminal, this is the environment's
// COLUMNS, or else the terminal's width, or else 80, and at least 40. For anything else it is
// kTextWidth, so that files are the same on every machine.
std::size_t text_width(std::FILE* stream);

}  // namespace autoref::io
