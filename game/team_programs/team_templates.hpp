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

// The languages of template_files(), in the same order.
std::vector<std::string> template_languages();

// The commands at the beginning of the README of a language's team, one per line. These commands
// compile the team (if necessary), check it, and play with it. Empty for an unknown language.
std::vector<std::string> first_commands(std::string_view language);

}  // namespace autoref::game
