// The content of a report, independent of Markdown and HTML; the renderers decide how it looks.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "experiments/kinds/results.hpp"

namespace autoref::experiments {

struct Heading {
  std::string text;
};

struct Paragraph {
  std::string text;
};

// A paragraph that stands out.
struct Strong {
  std::string text;
};

struct List {
  std::vector<std::string> items;
};

// A table. Its first row is the header, and all rows have the same length. The first `names`
// columns contain left-aligned words, the others numbers.
struct Table {
  std::vector<std::vector<std::string>> rows;
  std::size_t names = 1;
};

// Preformatted lines, such as commands and tables of the terminal.
struct Verbatim {
  std::string text;
};

// A file next to the report. It becomes a link in Markdown, but only a name in HTML, since the HTML
// file may be sent alone.
struct Link {
  std::string file;
  std::string text;
};

// A drawn plot: FOLDER/NAME.svg with its .gp and .csv.
struct Figure {
  std::string folder;
  std::string name;
  std::string caption;
  std::string svg;  // SVG source
};

// A bracket with the results so far, as a drawing in HTML and a table in Markdown. At least one tie
// must have a place in the bracket.
struct CupBracket {
  std::vector<TieResult> ties;
};

// The blocks up to the next FoldEnd are hidden until the reader clicks on the summary.
struct FoldStart {
  std::string summary;
};
struct FoldEnd {};

using Block = std::variant<Heading, Paragraph, Strong, List, Table, Verbatim, Link, Figure,
                           ResultDrawing, CupBracket, FoldStart, FoldEnd>;

struct Document {
  std::string title;
  std::vector<Block> blocks;
};

// Texts may contain any characters: they are shown literally and never interpreted as markup. Line
// breaks become spaces, except in Verbatim.
std::string markdown_of(const Document& document);

// A self-contained page: it needs neither other files nor a network, and it names neighbouring
// files without linking to them.
std::string html_of(const Document& document);

// The blocks as HTML for another page, which needs its own style and page_bracket_style().
std::string html_fragment(const std::vector<Block>& blocks);

}  // namespace autoref::experiments
