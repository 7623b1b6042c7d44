// Renders documents as Markdown; tables use GitHub's dialect.
#include <fmt/format.h>

#include <algorithm>

#include "experiments/report/bracket_drawing.hpp"
#include "experiments/report/document.hpp"
#include "io/words.hpp"
#include "view/page.hpp"

namespace autoref::experiments {
namespace {

bool is_markup(char c) { return std::string_view("\\`*_[]<>|#~$&").find(c) != std::string::npos; }

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

// Returns whether a line starting with this text would be a list or a rule.
bool begins_block(const std::string& text) {
  if (text.empty()) return false;
  if (text.front() == '-' || text.front() == '+' || text.front() == '=') return true;
  const std::size_t number = text.find_first_not_of("0123456789");
  return number != 0 && number != std::string::npos && (text[number] == '.' || text[number] == ')');
}

std::string inline_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (is_markup(c)) escaped += '\\';
    escaped += is_line_end(c) ? ' ' : c;
  }
  return escaped;
}

// Escapes text at the start of a line.
std::string escaped_line(const std::string& text) {
  std::string line = inline_text(text);
  line.erase(0, line.find_first_not_of(' '));
  if (!begins_block(line)) return line;
  // In a numbered list, the full stop after the number must be escaped, not the digits.
  const std::size_t mark = line.find_first_not_of("0123456789");
  return line.insert(mark, "\\");
}

std::string row_of(const std::vector<std::string>& cells) {
  std::vector<std::string> escaped;
  std::transform(cells.begin(), cells.end(), std::back_inserter(escaped), inline_text);
  return fmt::format("| {} |\n", fmt::join(escaped, " | "));
}

// A code fence that is longer than any run of backticks in the text.
std::string fence_for(const std::string& text) {
  std::size_t longest = 2;
  std::size_t run = 0;
  for (const char c : text) {
    run = c == '`' ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  return std::string(longest + 1, '`');
}

std::string markdown_of(const Heading& heading) { return "## " + inline_text(heading.text) + "\n"; }
std::string markdown_of(const Paragraph& paragraph) { return escaped_line(paragraph.text) + "\n"; }

std::string markdown_of(const Strong& strong) {
  return "**" + std::string(io::trimmed(inline_text(strong.text))) + "**\n";
}

std::string markdown_of(const FoldStart& fold) {
  return fmt::format("<details><summary>{}</summary>\n", view::html_text(fold.summary));
}
std::string markdown_of(const FoldEnd& /*fold*/) { return "</details>\n"; }

std::string markdown_of(const List& list) {
  std::string text;
  for (const std::string& item : list.items) text += "- " + escaped_line(item) + "\n";
  return text;
}

std::string markdown_of(const Table& table) {
  std::vector<std::string> rule(table.rows.front().size(), "--:");
  std::fill_n(rule.begin(), std::min(table.names, rule.size()), "---");
  std::string text = row_of(table.rows.front()) + fmt::format("|{}|\n", fmt::join(rule, "|"));
  for (std::size_t i = 1; i < table.rows.size(); ++i) text += row_of(table.rows[i]);
  return text;
}

std::string markdown_of(const Verbatim& verbatim) {
  const std::string fence = fence_for(verbatim.text);
  const bool is_ended = verbatim.text.empty() || verbatim.text.back() == '\n';
  return fmt::format("{}\n{}{}{}\n", fence, verbatim.text, is_ended ? "" : "\n", fence);
}

std::string markdown_of(const Link& link) {
  return fmt::format("[{}]({})\n", inline_text(link.text), link.file);
}

std::string markdown_of(const Figure& figure) {
  return fmt::format("![{0}]({1}/{0}.svg)\n\n{2} ([data]({1}/{0}.csv), [script]({1}/{0}.gp))\n",
                     figure.name, figure.folder, escaped_line(figure.caption));
}

std::string markdown_of(const ResultDrawing& drawing) {
  return fmt::format("![{0}]({0})\n\n{1}\n", drawing.name, escaped_line(drawing.caption));
}

std::string team_markdown(const TieTeam& team) {
  const std::string name = inline_text(team.name);
  return team.has_won ? "**" + name + "**" : name;
}

// "**zone** 3 : 1 basic"; without a result, "zone : basic".
std::string tie_markdown(const TieResult& tie) {
  const auto& [a, b] = tie.teams;
  std::string text =
      fmt::format("{} {} : {} {}", team_markdown(a), a.goals, b.goals, team_markdown(b));
  if (a.goals.empty()) text = fmt::format("{} : {}", team_markdown(a), team_markdown(b));
  if (tie.decision.empty() || tie.is_usual) return text;
  return text + ", " + inline_text(tie.decision);
}

// One line per position of the first round. Each tie is on the first of the lines that lead to it.
std::vector<std::vector<std::string>> bracket_lines(const CupBracket& bracket,
                                                    const std::vector<std::size_t>& rounds) {
  std::vector<std::vector<std::string>> lines(rounds.front(),
                                              std::vector<std::string>(rounds.size()));
  std::size_t used = 0;
  for (const TieResult& tie : bracket.ties) {
    if (!tie.place || tie.place->ties_in_round > rounds.front()) continue;
    const auto column = std::find(rounds.begin(), rounds.end(), tie.place->ties_in_round);
    const std::size_t line = tie.place->position * (rounds.front() / tie.place->ties_in_round);
    lines[line][static_cast<std::size_t>(column - rounds.begin())] = tie_markdown(tie);
    used = std::max(used, line + 1);
  }
  lines.resize(used);
  return lines;
}

// A column per round, then the tie for third place.
std::string markdown_of(const CupBracket& bracket) {
  const std::vector<std::size_t> rounds = rounds_of(bracket);
  std::vector<std::string> names(rounds.size());
  std::transform(rounds.begin(), rounds.end(), names.begin(), name_of_round);
  std::string text = fmt::format("| {} |\n|", fmt::join(names, " | "));
  for (std::size_t i = 0; i < rounds.size(); ++i) text += "---|";
  for (const auto& line : bracket_lines(bracket, rounds))
    text += fmt::format("\n| {} |", fmt::join(line, " | "));
  text += "\n";
  for (const TieResult& tie : bracket.ties) {
    if (!tie.place) text += fmt::format("\n{}: {}\n", inline_text(tie.name), tie_markdown(tie));
  }
  return text + "\nTeams in bold advance.\n";
}

}  // namespace

std::string markdown_of(const Document& document) {
  std::string text = "# " + inline_text(document.title) + "\n";
  for (const Block& block : document.blocks) {
    text += "\n" + std::visit([](const auto& content) { return markdown_of(content); }, block);
  }
  return text;
}

}  // namespace autoref::experiments
