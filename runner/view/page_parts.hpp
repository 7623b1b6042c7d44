// The files of runner/view/page/, as cmake/page_parts.cmake puts them into the program.
#pragma once

#include <string_view>

namespace autoref::runner {

// The page with a line "@NAME@" for each of STYLE, SCRIPT, GAME and PICTURES.
std::string_view page_frame();
std::string_view page_style();
std::string_view page_script();

}  // namespace autoref::runner
