#include "runner/cli/described_verb.hpp"

#include <CLI/CLI.hpp>

namespace autoref::runner {
namespace {

DescribedOption described(const CLI::Option& option) {
  DescribedOption described;
  described.is_positional = option.get_positional();
  for (const std::string& name : option.get_snames()) described.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) described.names.push_back("--" + name);
  if (described.is_positional) described.names = {option.get_name(true)};
  if (!described.is_positional && option.get_items_expected_max() > 0)
    described.value = option.get_type_name();
  described.description = option.get_description();
  return described;
}

}  // namespace

DescribedVerb described(const CLI::App& app) {
  DescribedVerb verb;
  verb.name = app.get_name();
  verb.description = app.get_description();
  for (const CLI::Option* option : app.get_options()) verb.options.push_back(described(*option));
  verb.footer = app.get_footer();
  for (const CLI::App* nested : app.get_subcommands([](const CLI::App*) { return true; }))
    verb.verbs.push_back(described(*nested));
  return verb;
}

}  // namespace autoref::runner
