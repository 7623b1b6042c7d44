// The files of view/page/, embedded into the program by cmake/page_parts.cmake.
#pragma once

#include <string_view>

namespace autoref::view {

// The HTML of a page. @ALLOWED@ (further sources of the content security policy), @STYLE@, @GAME@,
// @FRAMES@ and @SCRIPT@ must be replaced.
std::string_view page_frame();
std::string_view page_style();
std::string_view page_script();
std::string_view page_start();  // the end of the script for a recorded game

// Additions for a live page: the end of its style, and the end of its script in place of
// page_start().
std::string_view page_live_style();
std::string_view page_live_script();

std::string_view page_bracket_style();  // for experiments/report/bracket_drawing.hpp

// The page of a run: its HTML, in which @TITLE@ (twice), @STYLE@ and @SCRIPT@ must be replaced; the
// end of its style; and its script.
std::string_view page_run();
std::string_view page_run_style();
std::string_view page_run_script();

}  // namespace autoref::view
