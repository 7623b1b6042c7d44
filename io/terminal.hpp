// The terminal behind a stream.
#pragma once

#include <cstddef>
#include <cstdio>

namespace autoref::io {

bool is_terminal(std::FILE* stream);

// Width of text written to the stream, in characters: of a terminal the environment's COLUMNS, else
// its own width, else 80, and at least 40; of anything else kTextWidth, so that files are the same
// on every machine.
std::size_t text_width(std::FILE* stream);

}  // namespace autoref::io
