#include "app/description/reference_pages.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace autoref::app {
namespace {

// A cell on one line, without what Markdown or HTML would read as markup.
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
  throw std::invalid_argument(fmt::format("there is no reference page '{}'", name));
}

}  // namespace autoref::app
