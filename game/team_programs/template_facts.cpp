// Facts read from the beginners' teams. Declared in team_templates.hpp.
#include <sstream>

#include "game/team_programs/team_templates.hpp"

namespace autoref::game {

std::vector<std::string> template_languages() {
  std::vector<std::string> languages;
  for (const TemplateFile& file : template_files()) {
    if (languages.empty() || languages.back() != file.language)
      languages.emplace_back(file.language);
  }
  return languages;
}

std::vector<std::string> first_commands(std::string_view language) {
  constexpr std::string_view kIndent = "    ";
  std::vector<std::string> commands;
  for (const TemplateFile& file : template_files()) {
    if (file.language != language || file.name != "README.md") continue;
    std::istringstream lines{std::string(file.content)};
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with(kIndent)) {
        commands.push_back(line.substr(kIndent.size()));
      } else if (!commands.empty()) {
        break;
      }
    }
  }
  return commands;
}

}  // namespace autoref::game
