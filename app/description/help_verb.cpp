#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/mistyped.hpp"
#include "app/verbs.hpp"
#include "io/errors.hpp"

namespace autoref::app {
namespace {

// Calls the formatter because CLI::App::help() would describe the verb just parsed: `help` itself.
int help_verb(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* described = &app;
  std::string name = app.get_name();
  for (const std::string& word : words) {
    if (!is_verb(*described, word))
      throw io::InputError({"help"}, "", unknown_verb_message(*described, word));
    described = described->get_subcommand(word);
    name += " " + word;
  }
  fmt::print("{}", app.get_formatter()->make_help(described, name, CLI::AppFormatMode::Normal));
  return io::kDone;
}

}  // namespace

void add_help_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("help", "List the verbs, or explain one.");
  auto words = std::make_shared<std::vector<std::string>>();
  verb->add_option("VERB", *words,
                   "Name of a verb or a group, such as run, team or team new. Default: list them.");
  verb->footer("Examples:\n  autoref help run\n  autoref help team new");
  verb->callback(
      [&app, words, &chosen] { chosen = [&app, words] { return help_verb(app, *words); }; });
}

}  // namespace autoref::app
