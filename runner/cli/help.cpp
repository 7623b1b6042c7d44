#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "runner/cli/command_line.hpp"
#include "runner/cli/mistyped.hpp"
#include "runner/io/errors.hpp"

namespace autoref::runner {

// Not named help(): that would describe the verb just parsed, which is `help` itself.
int help_verb(const CLI::App& app, const std::string& word) {
  if (!word.empty() && !is_verb(app, word)) {
    throw InputError({"help"}, "", unknown_verb_message(app, word));
  }
  const CLI::App& described = word.empty() ? app : *app.get_subcommand(word);
  const std::string name = word.empty() ? app.get_name() : app.get_name() + " " + word;
  fmt::print("{}", app.get_formatter()->make_help(&described, name, CLI::AppFormatMode::Normal));
  return kDone;
}

void add_help_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("help", "List the verbs, or explain one.");
  auto word = std::make_shared<std::string>();
  verb->add_option("VERB", *word, "Name of a verb. Default: list all verbs.");
  verb->footer("Example:\n  autoref help run");
  verb->callback(
      [&app, word, &chosen] { chosen = [&app, word] { return help_verb(app, *word); }; });
}

}  // namespace autoref::runner
