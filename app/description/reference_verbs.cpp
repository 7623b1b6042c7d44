// The reference page of verbs and their options.
#include <fmt/format.h>

#include "app/description/reference_pages.hpp"

namespace autoref::app {
namespace {

std::string option_text(const DescribedOption& option) {
  std::string text;
  for (const std::string& name : option.names) text += (text.empty() ? "" : ", ") + code_span(name);
  return option.value.empty() ? text : text + " " + option.value;
}

std::string options_table(const DescribedVerb& verb) {
  std::vector<std::vector<std::string>> rows = {{"option", "meaning"}};
  for (const DescribedOption& option : verb.options)
    rows.push_back({option_text(option), option.description});
  return reference_table(rows);
}

std::string verb_section(const DescribedVerb& verb, const std::string& before) {
  const std::string name = before + " " + verb.name;
  std::string text = fmt::format("## {}\n\n{}\n\n", name, verb.description);
  text += options_table(verb);
  if (!verb.footer.empty()) text += fmt::format("```\n{}\n```\n\n", verb.footer);
  for (const DescribedVerb& nested : verb.verbs) text += verb_section(nested, name);
  return text;
}

}  // namespace

std::string verbs_page(const DescribedVerb& program) {
  std::string page = reference_head("Verbs and options", "verbs") + program.description + "\n\n" +
                     options_table(program) + fmt::format("```\n{}\n```\n\n", program.footer);
  for (const DescribedVerb& verb : program.verbs) page += verb_section(verb, program.name);
  page.pop_back();
  return page;
}

}  // namespace autoref::app
