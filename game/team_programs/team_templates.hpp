// The beginners' teams of game/team_programs/templates/, embedded by cmake/embedded_files.cmake.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace autoref::game {

struct TemplateFile {
  std::string_view language;  // "python"
  std::string_view name;      // "my_team.py"
  std::string_view content;
};

// All files of all languages; those of one language are adjacent.
std::vector<TemplateFile> template_files();

// Their languages, in this order.
std::vector<std::string> template_languages();

// The commands that the README of a language's team begins with, one a line: how to compile it if
// it must be compiled, how to check it, how to play with it. Empty for an unknown language.
std::vector<std::string> first_commands(std::string_view language);

}  // namespace autoref::game
