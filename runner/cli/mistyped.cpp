#include "runner/cli/mistyped.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <vector>

#include "runner/io/words.hpp"
#include "runner/settings/renamed.hpp"

namespace autoref::runner {
namespace {

// Strips dashes and value: "seed" for "--seed=7". Empty if the word is not an option.
std::string option_name(const std::string& word) {
  const std::size_t begin = word.find_first_not_of('-');
  if (begin == 0 || begin == std::string::npos) return {};
  return word.substr(begin, word.find('=') - begin);
}

std::vector<std::string> long_options(const CLI::App& verb) {
  std::vector<std::string> names;
  for (const CLI::Option* option : verb.get_options()) {
    names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
  }
  return names;
}

// "; did you mean '--seed'?", or empty if none of the verb's options is close.
std::string option_suggestion(const CLI::App& verb, const std::string& word) {
  const std::string name = option_name(word);
  const std::vector<std::string> known = long_options(verb);
  if (name.size() < 2 || suggestion(name, known).empty()) return {};
  return fmt::format("; did you mean '--{}'?", nearest_word(name, known));
}

std::string quoted(const std::vector<std::string>& words) {
  return fmt::format("'{}'", fmt::join(words, "', '"));
}

// Replaces CLI11's own message, which lists the unexpected words in reverse order.
std::string extras_message(const CLI::App& verb, const std::vector<std::string>& extras) {
  const std::string& first = extras.front();
  if (!option_name(first).empty()) {
    return fmt::format("unknown option '{}'{}", first.substr(0, first.find('=')),
                       option_suggestion(verb, first));
  }
  std::string message =
      fmt::format("unexpected argument{} {}", extras.size() > 1 ? "s" : "", quoted(extras));
  for (const std::string& extra : extras) message += option_suggestion(verb, extra);
  return message;
}

// The punctuation that separates `message` from the next clause.
std::string_view end_of(std::string_view message) { return message.ends_with('?') ? "" : ";"; }

}  // namespace

bool is_verb(const CLI::App& app, const std::string& word) {
  return !app.get_subcommands([&word](const CLI::App* verb) { return verb->check_name(word); })
              .empty();
}

std::string unknown_verb_message(const CLI::App& app, const std::string& word) {
  if (const std::optional<std::string_view> now = new_verb_of(word)) {
    return fmt::format("unknown verb '{}'; its name is '{}' now", word, *now);
  }
  std::vector<std::string> known;
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    known.push_back(verb->get_name());
  }
  const std::string nearest = suggestion(word, known);
  return fmt::format("there is no verb '{}'{} `autoref help` lists them", word,
                     nearest.empty() ? ";" : nearest);
}

std::string message_of(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  const CLI::App& verb = parsed.empty() ? app : *parsed.front();
  // CLI11 reports unexpected words before the verb as extras of the program itself.
  const CLI::App& place = app.remaining().empty() ? verb : app;
  const std::vector<std::string> extras = place.remaining();
  const std::string message = extras.empty() ? error.what() : extras_message(place, extras);
  if (&place == &app)
    return fmt::format("{}{} `autoref help` lists the verbs", message, end_of(message));
  return fmt::format("{0}: {1}{2} `autoref help {0}` lists its options", place.get_name(), message,
                     end_of(message));
}

}  // namespace autoref::runner
