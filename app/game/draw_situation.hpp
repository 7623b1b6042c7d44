// Draws where a scene of a situation starts.
#pragma once

#include "app/command_line.hpp"

namespace autoref::app {

// Writes the SVG file. Returns the exit code. Throws InputError.
int draw_situation(const DrawArguments& arguments);

}  // namespace autoref::app
