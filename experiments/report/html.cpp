// Renders documents as a single HTML page.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "experiments/report/bracket_drawing.hpp"
#include "experiments/report/document.hpp"
#include "io/table.hpp"
#include "view/page.hpp"
#include "view/page_parts.hpp"

namespace autoref::experiments {
namespace {

// Wide tables scroll in their own box; plots are scaled to the page. On paper, where nothing
// scrolls, the font shrinks until they fit: `--letters` is the table's width in characters (0.62 em
// each), and 176 mm is the width between the margins of A4 and Letter.
constexpr const char* kStyle =
    "body{font:16px/1.5 system-ui,sans-serif;color:#222;background:#fff;max-width:60em;"
    "margin:2em auto;padding:0 1em;overflow-wrap:anywhere}\n"
    "h1{font-size:1.5em}h2{font-size:1.15em;margin-top:2em;border-bottom:1px solid #ddd}\n"
    "pre{background:#f6f6f6;padding:.8em;overflow-x:auto;overflow-wrap:normal;font-size:13px;"
    "line-height:1.4}\n"
    "code{font-size:.9em}\n"
    ".wide{overflow-x:auto;overflow-wrap:normal;margin:1em 0}\n"
    "table{border-collapse:collapse;font-size:14px;font-variant-numeric:tabular-nums}\n"
    "th,td{padding:.25em .7em;text-align:right;vertical-align:top;border-bottom:1px solid "
    "#e4e4e4;white-space:nowrap}\n"
    ".name{text-align:left}\n"
    ".words .name{white-space:normal;overflow-wrap:anywhere}\n"
    "figure{margin:2em 0}figcaption{font-size:14px;color:#555}\n"
    "svg{max-width:100%;height:auto}\n"
    "@media screen and (max-width:40em){\n"
    "body{margin:1em auto}h1{font-size:1.3em}ul{padding-left:1.2em}\n"
    "tr>.name:first-child{position:sticky;left:0;background:#fff;max-width:8em;"
    "white-space:normal;overflow-wrap:break-word}\n"
    ".words tr>.name:first-child{position:static;max-width:none}\n"
    "}\n"
    "@media print{\n"
    "body{max-width:none;margin:0;padding:0;font-size:11pt;color:#000}\n"
    "pre{background:none;border:1px solid #ddd;padding:1mm;overflow:visible;"
    "font-size:min(10pt,calc(174mm/(var(--letters)*.62)))}\n"
    ".wide{overflow:visible}\n"
    "table{font-size:min(10pt,calc(176mm/(var(--letters)*.62)))}\n"
    "thead{display:table-header-group}\n"
    "tr,figure,li{break-inside:avoid}\n"
    "h1,h2,p:has(+.wide){break-after:avoid}\n"
    "p,li{orphans:3;widows:3}\n"
    "figure{margin:1em 0}svg{max-height:220mm;width:auto}\n"
    "}\n";

std::string row_of(const std::vector<std::string>& cells, const char* tag, std::size_t names) {
  std::string row = "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    row += fmt::format("<{0}{1}>{2}</{0}>", tag, i < names ? " class=\"name\"" : "",
                       view::html_text(cells[i]));
  }
  return row + "</tr>\n";
}

// The <svg> element without the prolog before it, which is not allowed inside a page.
std::string_view element_of(const std::string& svg) {
  const std::size_t begin = svg.find("<svg");
  return begin == std::string::npos ? std::string_view() : std::string_view(svg).substr(begin);
}

std::string html_of(const Heading& heading) {
  return fmt::format("<h2>{}</h2>\n", view::html_text(heading.text));
}

std::string html_of(const Paragraph& paragraph) {
  return fmt::format("<p>{}</p>\n", view::html_text(paragraph.text));
}

std::string html_of(const Strong& strong) {
  return fmt::format("<p><strong>{}</strong></p>\n", view::html_text(strong.text));
}

std::string html_of(const FoldStart& fold) {
  return fmt::format("<details><summary>{}</summary>\n", view::html_text(fold.summary));
}
std::string html_of(const FoldEnd& /*fold*/) { return "</details>\n"; }

std::string html_of(const List& list) {
  std::string text = "<ul>\n";
  for (const std::string& item : list.items)
    text += fmt::format("<li>{}</li>\n", view::html_text(item));
  return text + "</ul>\n";
}

// Width of the table in characters, with `apart` characters between two cells.
std::size_t letters_of(const Table& table, std::size_t apart) {
  std::size_t letters = 0;
  for (std::size_t column = 0; column < table.rows.front().size(); ++column) {
    std::size_t widest = 0;
    for (const auto& row : table.rows) widest = std::max(widest, io::width_of(row[column]));
    letters += widest + apart;
  }
  return letters;
}

std::string html_of(const Table& table) {
  const bool is_words = table.names >= table.rows.front().size();
  std::string text = fmt::format("<div class=\"wide{}\"><table style=\"--letters:{}\">\n<thead>{}",
                                 is_words ? " words" : "", letters_of(table, 3),
                                 row_of(table.rows.front(), "th", table.names));
  text += "</thead>\n<tbody>\n";
  for (std::size_t i = 1; i < table.rows.size(); ++i) {
    text += row_of(table.rows[i], "td", table.names);
  }
  return text + "</tbody></table></div>\n";
}

std::string html_of(const Verbatim& verbatim) {
  std::size_t widest = 1;
  std::istringstream lines(verbatim.text);
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, io::width_of(line));
  return fmt::format("<pre style=\"--letters:{}\">{}</pre>\n", widest,
                     view::html_text(verbatim.text));
}

// Writes only the file's name: a link would be dead if the page is sent without its folder.
std::string html_of(const Link& link) {
  return fmt::format("<p>{}: <code>{}</code></p>\n", view::html_text(link.text),
                     view::html_text(link.file));
}

std::string html_of(const Figure& figure) {
  return fmt::format(
      "<figure>\n{0}<figcaption>{1} Data: <code>{2}/{3}.csv</code>, "
      "script: <code>{2}/{3}.gp</code>.</figcaption>\n</figure>\n",
      element_of(figure.svg), view::html_text(figure.caption), figure.folder, figure.name);
}

std::string html_of(const ResultDrawing& drawing) {
  return fmt::format("<figure>\n{}<figcaption>{}</figcaption>\n</figure>\n",
                     element_of(drawing.svg), view::html_text(drawing.caption));
}

std::string html_of(const CupBracket& bracket) { return bracket_html(bracket); }

std::string style_of(const Document& document) {
  const bool has_bracket =
      std::any_of(document.blocks.begin(), document.blocks.end(),
                  [](const Block& block) { return std::holds_alternative<CupBracket>(block); });
  return has_bracket ? std::string(kStyle).append(view::page_bracket_style()) : kStyle;
}

}  // namespace

std::string html_fragment(const std::vector<Block>& blocks) {
  std::string text;
  for (const Block& block : blocks) {
    text += std::visit([](const auto& content) { return html_of(content); }, block);
  }
  return text;
}

std::string html_of(const Document& document) {
  const std::string title = view::html_text(document.title);
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, "
      "initial-scale=1\">\n<title>{0}</title>\n"
      "<style>\n{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n",
      title, style_of(document));
  return text + html_fragment(document.blocks) + "</body>\n</html>\n";
}

}  // namespace autoref::experiments
