// A report as content, without a word of Markdown or HTML: each renderer knows how it looks.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace autoref::runner {

struct Heading {
  std::string text;
};

struct Paragraph {
  std::string text;
};

struct List {
  std::vector<std::string> items;
};

// The first row is the head; all rows are as long. The first `names` columns are words and stand to
// the left, the others are numbers.
struct Table {
  std::vector<std::vector<std::string>> rows;
  std::size_t names = 1;
};

// Lines that keep their spaces: commands, tables of the terminal.
struct Verbatim {
  std::string text;
};

// A file beside the report: a link in Markdown, its name in HTML, which is sent alone.
struct Link {
  std::string file;
  std::string text;
};

// A drawn plot: FOLDER/NAME.svg with its .gp and .csv.
struct Figure {
  std::string folder;
  std::string name;
  std::string caption;
  std::string svg;  // the drawing itself
};

using Block = std::variant<Heading, Paragraph, List, Table, Verbatim, Link, Figure>;

struct Document {
  std::string title;
  std::vector<Block> blocks;
};

// Any text may hold any characters: they are shown as they are and never taken for markup. Line
// ends within a text become spaces, but in Verbatim.
std::string markdown_of(const Document& document);

// One page that needs no other file and no network, and links to none: files beside it are named.
std::string html_of(const Document& document);

}  // namespace autoref::runner
