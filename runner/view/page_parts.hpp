// The files of runner/view/page/, embedded into the program by cmake/page_parts.cmake.
#pragma once

#include <string_view>

namespace autoref::runner {

// The HTML template, with the placeholders @STYLE@, @GAME@, @FRAMES@ and @SCRIPT@.
std::string_view page_frame();
std::string_view page_style();
std::string_view page_script();

}  // namespace autoref::runner
