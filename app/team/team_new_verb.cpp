#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>

#include "app/verbs.hpp"
#include "experiments/run/slurm.hpp"
#include "game/team_programs/team_templates.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/words.hpp"

namespace autoref::app {
namespace {

struct TeamNewArguments {
  std::string language;
  std::string folder;
};

namespace fs = std::filesystem;

constexpr const char* kExample = "autoref team new --language python my_team";

void check_language(const std::string& language) {
  const std::vector<std::string> known = game::template_languages();
  if (std::find(known.begin(), known.end(), language) != known.end()) return;
  if (language.empty()) {
    throw io::InputError(
        {"team new"}, "",
        fmt::format("choose a language: {}; for example: {}", io::listed(known), kExample));
  }
  throw io::InputError({"--language"}, "",
                       fmt::format("expected one of {}, found '{}'{}", io::listed(known), language,
                                   io::suggestion(language, known)));
}

void refuse_full_folder(const fs::path& folder) {
  std::error_code none;  // a folder that does not exist counts as empty
  if (!fs::exists(folder, none)) return;
  if (fs::is_directory(folder, none) && fs::is_empty(folder, none)) return;
  throw io::InputError({folder.string()}, "",
                       "exists and is not an empty folder; choose a new one");
}

void print_next_commands(const std::string& language, const fs::path& folder) {
  const std::string name = folder.string();
  fmt::print("Wrote a team in {} to {}; {} explains it. To check it and to play a game:\n  cd {}\n",
             language, name, (folder / "README.md").string(), experiments::plain_shell_word(name));
  for (const std::string& command : game::first_commands(language)) fmt::print("  {}\n", command);
}

int team_new_verb(const TeamNewArguments& arguments) {
  const fs::path folder = arguments.folder;
  check_language(arguments.language);
  if (folder.empty())
    throw io::InputError({"team new"}, "",
                         fmt::format("name a new folder; for example: {}", kExample));
  refuse_full_folder(folder);
  io::create_folder(folder);
  for (const game::TemplateFile& file : game::template_files()) {
    if (file.language == arguments.language) io::replace_file(folder / file.name, file.content);
  }
  print_next_commands(arguments.language, folder);
  return io::kDone;
}

}  // namespace

void add_team_new_verb(CLI::App& team, Chosen& chosen) {
  CLI::App* verb = team.add_subcommand("new", "Write a one-page team for beginners.");
  auto arguments = std::make_shared<TeamNewArguments>();
  verb->add_option("--language", arguments->language,
                   fmt::format("One of {}.", io::listed(game::template_languages())))
      ->type_name("LANGUAGE");
  verb->add_option("DIR", arguments->folder, "A new or empty folder.");
  verb->footer(fmt::format("Without a language, lists the languages.\n\nExample:\n  {}", kExample));
  choose(*verb, chosen, arguments, team_new_verb);
}

}  // namespace autoref::app
