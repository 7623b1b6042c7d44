#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/description/described_verb.hpp"
#include "app/verbs.hpp"
#include "io/build_id.hpp"
#include "io/errors.hpp"

namespace autoref::app {
namespace {

// Escapes a text so that roff shows it unchanged.
std::string roff(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    const bool begins_line = escaped.empty() || escaped.back() == '\n';
    if (begins_line && (c == '.' || c == '\'')) escaped += "\\&";
    if (c == '\\') {
      escaped += "\\e";
    } else if (c == '-') {
      escaped += "\\-";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string words_of(const DescribedOption& option) {
  std::string words;
  for (const std::string& name : option.names)
    words += (words.empty() ? "\\fB" : ", \\fB") + roff(name) + "\\fR";
  return option.value.empty() ? words : words + " \\fI" + roff(option.value) + "\\fR";
}

std::string options_text(const DescribedVerb& verb) {
  std::string text;
  for (const DescribedOption& option : verb.options)
    text += ".TP\n" + words_of(option) + "\n" + roff(option.description) + "\n";
  return text;
}

// The lines of the text, unchanged but indented.
std::string verbatim(const std::string& lines) {
  return lines.empty() ? "" : ".PP\n.nf\n" + roff(lines) + "\n.fi\n";
}

std::string verb_text(const DescribedVerb& verb, const std::string& before) {
  const std::string name = before + " " + verb.name;
  std::string text = ".SS \"" + roff(name) + "\"\n" + roff(verb.description) + "\n";
  text += options_text(verb) + verbatim(verb.footer);
  for (const DescribedVerb& nested : verb.verbs) text += verb_text(nested, name);
  return text;
}

int man_verb(const CLI::App& verb) {
  const CLI::App* program = &verb;
  while (program->get_parent() != nullptr) program = program->get_parent();
  fmt::print("{}", man_page(described(*program), fmt::format("autoref {}", io::build_id())));
  return io::kDone;
}

}  // namespace

std::string man_page(const DescribedVerb& program, const std::string& version) {
  std::string page =
      fmt::format(".TH AUTOREF 1 \"\" \"{}\" \"User Commands\"\n", roff(version)) +
      ".SH NAME\nautoref \\- simulate and referee robot soccer games of the Small Size League\n" +
      ".SH SYNOPSIS\n\\fBautoref\\fR \\fIVERB\\fR [\\fIARGUMENT\\fR ...]\n" + ".SH DESCRIPTION\n" +
      roff(program.description) + "\n" + ".SH OPTIONS\n" + options_text(program) + ".SH VERBS\n";
  for (const DescribedVerb& verb : program.verbs) page += verb_text(verb, program.name);
  return page + ".SH EXAMPLE AND EXIT STATUS\n" + verbatim(program.footer);
}

void add_man_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("man", "Print the man page.");
  verb->footer("Example:\n  autoref show man > autoref.1 && man ./autoref.1");
  verb->callback([verb, &chosen] { chosen = [verb] { return man_verb(*verb); }; });
}

}  // namespace autoref::app
