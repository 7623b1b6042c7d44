// The verb that prints the manual's reference pages, and its pages of verbs and teams.
#include "app/description/reference_pages.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <memory>
#include <stdexcept>

#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "io/errors.hpp"
#include "soccer/parameters.hpp"
#include "strategies/registry.hpp"

namespace autoref::app {
namespace {

// A cell on one line, with everything escaped that Markdown or HTML would read as markup.
std::string cell_text(const std::string& text) {
  std::string cell;
  bool is_code = false;
  for (const char c : text) {
    if (c == '`') is_code = !is_code;
    if (c == '|') {
      cell += "\\|";
    } else if (c == '<' && !is_code) {
      cell += "&lt;";
    } else if (c == '*' && !is_code) {
      cell += "\\*";
    } else {
      cell += c == '\n' ? ' ' : c;
    }
  }
  return cell;
}

std::string row_text(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& cell : cells) row += fmt::format(" {} |", cell_text(cell));
  return row + "\n";
}

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

std::string parameters_table(const strategies::Entry& team) {
  if (team.params.empty()) return "This team has no parameters.\n\n";
  std::vector<std::vector<std::string>> rows = {{"parameter", "default", "range", "meaning"}};
  for (const strategies::Tunable& tunable : team.params) {
    const std::string_view unit = unit_of(tunable.name);
    rows.push_back({code_span(std::string(tunable.name)),
                    fmt::format("{}{}{}", tunable.standard, unit.empty() ? "" : " ", unit),
                    fmt::format("{} to {}", tunable.range.low, tunable.range.high),
                    std::string(tunable.about)});
  }
  return reference_table(rows);
}

}  // namespace

std::string code_span(const std::string& text) { return "`" + text + "`"; }

std::string reference_head(const std::string& title, const std::string& name) {
  return fmt::format(
      "# {0}\n\nThis page is printed by the program, `autoref reference {1}`; a test compares the "
      "two.\n\n",
      title, name);
}

std::string reference_table(const std::vector<std::vector<std::string>>& rows) {
  if (rows.size() < 2) return "";
  std::string text = row_text(rows.front()) + "|";
  for (std::size_t i = 0; i < rows.front().size(); ++i) text += "---|";
  text += "\n";
  for (std::size_t i = 1; i < rows.size(); ++i) text += row_text(rows[i]);
  return text + "\n";
}

std::vector<std::string> reference_page_names() {
  return {"settings", "verbs", "rules", "teams", "scenario-files"};
}

std::string reference_page(const std::string& name, const DescribedVerb& program) {
  if (name == "settings") return settings_page();
  if (name == "verbs") return verbs_page(program);
  if (name == "rules") return rules_page();
  if (name == "teams") return team_parameters_page();
  if (name == "scenario-files") return scenario_files_page();
  throw std::invalid_argument(fmt::format("unknown reference page '{}'", name));
}

void add_reference_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("reference", "Print a page of the manual's reference.");
  verb->group("");  // help does not list it: it is for those who write the manual
  auto page = std::make_shared<std::string>();
  verb->add_option("PAGE", *page,
                   fmt::format("One of {}.", fmt::join(reference_page_names(), ", ")))
      ->required()
      ->check(one_of(reference_page_names()));
  verb->footer("Example:\n  autoref reference settings > docs/reference/settings.md");
  verb->callback([&app, page, &chosen] {
    chosen = [&app, page] {
      fmt::print("{}", reference_page(*page, described(app)));
      return static_cast<int>(io::kDone);
    };
  });
}

std::string verbs_page(const DescribedVerb& program) {
  std::string page = reference_head("Verbs and options", "verbs") + program.description + "\n\n" +
                     options_table(program) + fmt::format("```\n{}\n```\n\n", program.footer);
  for (const DescribedVerb& verb : program.verbs) page += verb_section(verb, program.name);
  page.pop_back();
  return page;
}

std::string team_parameters_page() {
  std::string page = reference_head("Teams and their parameters", "teams") +
                     "The teams that are compiled in. `--set a.params.NAME=NUMBER` sets a "
                     "parameter of team a; in a scenario it is "
                     "`a: { strategy: basic, params: { NAME: NUMBER } }`.\n\n";
  for (const strategies::Entry& team : strategies::all_strategies())
    page += fmt::format("## {}\n\n{}\n\n", team.name, team.about) + parameters_table(team);
  page.pop_back();
  return page;
}

}  // namespace autoref::app
