#include "app/description/described_verb.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <memory>

#include "app/command_line.hpp"
#include "app/one_of.hpp"
#include "io/build_id.hpp"
#include "io/errors.hpp"

namespace autoref::app {
namespace {

std::vector<std::string> dashed_names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

// As an argument without dashes, as an option, or as both.
void add_described(const CLI::Option& option, std::vector<DescribedOption>& options) {
  DescribedOption described;
  described.description = option.get_description();
  described.words = words_in_type(option.get_type_name());
  if (option.get_positional()) {
    described.names = {option.get_name(true)};
    described.is_positional = true;
    options.push_back(described);
  }
  described.names = dashed_names_of(option);
  described.is_positional = false;
  if (option.get_items_expected_max() > 0) described.value = option.get_type_name();
  if (!described.names.empty()) options.push_back(described);
}

int completion_verb(const std::string& shell) {
  fmt::print("{}", shell == "bash"  ? bash_completion()
                   : shell == "zsh" ? zsh_completion()
                                    : fish_completion());
  return io::kDone;
}

int man_verb(const CLI::App& app) {
  fmt::print("{}", man_page(described(app), fmt::format("autoref {}", io::build_id())));
  return io::kDone;
}

}  // namespace

DescribedVerb described(const CLI::App& app) {
  DescribedVerb verb;
  verb.name = app.get_name();
  verb.description = app.get_description();
  for (const CLI::Option* option : app.get_options()) add_described(*option, verb.options);
  verb.footer = app.get_footer();
  for (const CLI::App* nested : app.get_subcommands([](const CLI::App*) { return true; }))
    verb.verbs.push_back(described(*nested));
  return verb;
}

void add_completion_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand(
      "completion", "Print a script that completes verbs, options and their values in a shell.");
  auto shell = std::make_shared<std::string>();
  verb->add_option("SHELL", *shell, "bash, zsh or fish.")
      ->required()
      ->check(one_of({"bash", "zsh", "fish"}));
  verb->footer(
      "Completes, as far as they are known: settings, teams, rule books, cameras, languages of "
      "team\n"
      "programs, scenarios here and in the folder scenarios, and games of a results folder.\n\n"
      "Example, for the current shell:\n  autoref completion bash > autoref.bash && . "
      "./autoref.bash");
  verb->callback([shell, &chosen] { chosen = [shell] { return completion_verb(*shell); }; });
}

void add_man_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("man", "Print the man page.");
  verb->footer("Example:\n  autoref man > autoref.1 && man ./autoref.1");
  verb->callback([&app, &chosen] { chosen = [&app] { return man_verb(app); }; });
}

}  // namespace autoref::app
