// The manual's reference pages as Markdown, made from the lists that the program itself uses.
// `autoref reference` prints the pages under docs/reference/, and a test compares its output with
// these files.
#pragma once

#include <string>
#include <vector>

#include "app/description/described_verb.hpp"

namespace autoref::app {

// Names of the pages; each page is docs/reference/NAME.md.
std::vector<std::string> reference_page_names();

// The page with this name. `program` is described on the page of verbs. Throws
// std::invalid_argument for an unknown name.
std::string reference_page(const std::string& name, const DescribedVerb& program);

// Each of these functions returns one page.
std::string settings_page();
std::string verbs_page(const DescribedVerb& program);
std::string rules_page();
std::string team_parameters_page();
std::string scenario_files_page();

// A page's first lines: its title and the command that prints it.
std::string reference_head(const std::string& title, const std::string& name);

// A Markdown table; the first row is the header. Cells are escaped except between backticks.
// Returns an empty table if there is only a header.
std::string reference_table(const std::vector<std::vector<std::string>>& rows);

// `text` as a code span.
std::string code_span(const std::string& text);

}  // namespace autoref::app
