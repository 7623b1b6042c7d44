// Documents as one HTML page.
#include <fmt/format.h>

#include "runner/report/document.hpp"

namespace autoref::runner {
namespace {

constexpr const char* kStyle =
    "body{font:16px/1.5 system-ui,sans-serif;color:#222;max-width:60em;margin:2em auto;"
    "padding:0 1em}\n"
    "h1{font-size:1.5em}h2{font-size:1.15em;margin-top:2em;border-bottom:1px solid #ddd}\n"
    "pre{background:#f6f6f6;padding:.8em;overflow-x:auto;font-size:13px;line-height:1.4}\n"
    "div.wide{overflow-x:auto}\n"
    "table{border-collapse:collapse;font-size:14px;font-variant-numeric:tabular-nums}\n"
    "th,td{padding:.25em .7em;text-align:right;border-bottom:1px solid "
    "#e4e4e4;white-space:nowrap}\n"
    ".name{text-align:left}\n"
    "figure{margin:2em 0}figcaption{font-size:14px;color:#555}\n"
    "svg{max-width:100%;height:auto}\n";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string row_of(const std::vector<std::string>& cells, const char* tag, std::size_t names) {
  std::string row = "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    row += fmt::format("<{0}{1}>{2}</{0}>", tag, i < names ? " class=\"name\"" : "",
                       escaped(cells[i]));
  }
  return row + "</tr>\n";
}

// Without what stands before the element, which has no place within a page.
std::string_view element_of(const std::string& svg) {
  const std::size_t begin = svg.find("<svg");
  return begin == std::string::npos ? std::string_view() : std::string_view(svg).substr(begin);
}

std::string html_of(const Heading& heading) {
  return fmt::format("<h2>{}</h2>\n", escaped(heading.text));
}

std::string html_of(const Paragraph& paragraph) {
  return fmt::format("<p>{}</p>\n", escaped(paragraph.text));
}

std::string html_of(const List& list) {
  std::string text = "<ul>\n";
  for (const std::string& item : list.items) text += fmt::format("<li>{}</li>\n", escaped(item));
  return text + "</ul>\n";
}

std::string html_of(const Table& table) {
  std::string text =
      "<div class=\"wide\"><table>\n" + row_of(table.rows.front(), "th", table.names);
  for (std::size_t i = 1; i < table.rows.size(); ++i) {
    text += row_of(table.rows[i], "td", table.names);
  }
  return text + "</table></div>\n";
}

std::string html_of(const Verbatim& verbatim) {
  return fmt::format("<pre>{}</pre>\n", escaped(verbatim.text));
}

std::string html_of(const Link& link) {
  return fmt::format("<p><a href=\"{}\">{}</a></p>\n", escaped(link.file), escaped(link.text));
}

std::string html_of(const Figure& figure) {
  return fmt::format(
      "<figure>\n{0}<figcaption>{1} (<a href=\"{2}/{3}.csv\">data</a>, <a "
      "href=\"{2}/{3}.gp\">script</a>)</figcaption>\n</figure>\n",
      element_of(figure.svg), escaped(figure.caption), figure.folder, figure.name);
}

}  // namespace

std::string html_of(const Document& document) {
  const std::string title = escaped(document.title);
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>{0}</title>\n"
      "<style>\n{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n",
      title, kStyle);
  for (const Block& block : document.blocks) {
    text += std::visit([](const auto& content) { return html_of(content); }, block);
  }
  return text + "</body>\n</html>\n";
}

}  // namespace autoref::runner
