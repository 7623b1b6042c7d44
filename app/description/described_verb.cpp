#include "app/description/described_verb.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/shared_options.hpp"

namespace autoref::app {
namespace {

std::vector<std::string> dashed_names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

// Adds the option as an argument without dashes, as an option with dashes, or as both.
void add_described(const CLI::Option& option, std::vector<DescribedOption>& options) {
  DescribedOption described;
  described.description = option.get_description();
  described.allowed_words = words_in_type(option.get_type_name());
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
}  // namespace

DescribedVerb described(const CLI::App& app) {
  DescribedVerb verb;
  verb.name = app.get_name();
  verb.description = app.get_description();
  for (const CLI::Option* option : app.get_options()) add_described(*option, verb.options);
  verb.footer = app.get_footer();
  const auto is_listed = [](const CLI::App* nested) { return !nested->get_group().empty(); };
  for (const CLI::App* nested : app.get_subcommands(is_listed))
    verb.verbs.push_back(described(*nested));
  return verb;
}

}  // namespace autoref::app
