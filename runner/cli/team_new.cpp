#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>

#include "runner/cli/command_line.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/files.hpp"
#include "runner/io/words.hpp"
#include "runner/team_programs/team_templates.hpp"

namespace autoref::runner {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> languages() {
  std::vector<std::string> languages;
  for (const TemplateFile& file : template_files()) {
    if (languages.empty() || languages.back() != file.language)
      languages.emplace_back(file.language);
  }
  return languages;
}

void check_language(const std::string& language) {
  const std::vector<std::string> known = languages();
  if (std::find(known.begin(), known.end(), language) != known.end()) return;
  throw InputError(
      {"--language"}, "",
      fmt::format("there is no team in '{}' yet; expected one of {}", language, listed(known)));
}

void refuse_full_folder(const fs::path& folder) {
  std::error_code none;  // a folder that does not exist is not full
  if (!fs::exists(folder, none)) return;
  if (fs::is_directory(folder, none) && fs::is_empty(folder, none)) return;
  throw InputError({folder.string()}, "", "exists and is not an empty folder; choose a new one");
}

}  // namespace

int team_new_verb(const TeamNewArguments& arguments) {
  const fs::path folder = arguments.folder;
  check_language(arguments.language);
  refuse_full_folder(folder);
  create_folder(folder);
  for (const TemplateFile& file : template_files()) {
    if (file.language == arguments.language) replace_file(folder / file.name, file.content);
  }
  fmt::print("A team in {} is in {}; how to play it:\n  cd {}\n  cat README.md\n",
             arguments.language, folder.string(), folder.string());
  return kDone;
}

void add_team_new_verb(CLI::App& team, Chosen& chosen) {
  CLI::App* verb = team.add_subcommand("new", "Write a beginner's team of one page.");
  auto arguments = std::make_shared<TeamNewArguments>();
  verb->add_option("--language", arguments->language,
                   fmt::format("One of {}.", listed(languages())))
      ->required();
  verb->add_option("DIR", arguments->folder, "A new or empty folder.")->required();
  verb->footer("Example:\n  autoref team new --language python my_team");
  verb->callback(
      [arguments, &chosen] { chosen = [arguments] { return team_new_verb(*arguments); }; });
}

}  // namespace autoref::runner
