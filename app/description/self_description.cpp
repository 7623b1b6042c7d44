// The verbs that describe the program to other programs: man and completion.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/command_line.hpp"
#include "app/description/described_verb.hpp"
#include "app/one_of.hpp"
#include "io/build_id.hpp"
#include "io/errors.hpp"

namespace autoref::app {
namespace {

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
