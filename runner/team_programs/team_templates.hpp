// The beginners' teams of runner/team_programs/templates/, embedded by cmake/embedded_files.cmake.
#pragma once

#include <string_view>
#include <vector>

namespace autoref::runner {

struct TemplateFile {
  std::string_view language;  // "python"
  std::string_view name;      // "my_team.py"
  std::string_view content;
};

// All files of all languages; those of one language are adjacent.
std::vector<TemplateFile> template_files();

}  // namespace autoref::runner
