#include "app/mistyped.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <vector>

#include "app/former_names.hpp"
#include "io/words.hpp"

namespace autoref::app {
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

// "; did you mean '--seed'?", or empty if no option of the verb has a similar name.
std::string option_suggestion(const CLI::App& verb, const std::string& word) {
  const std::string name = option_name(word);
  if (name.size() < 2) return {};
  std::vector<std::string> meant = io::suggested_words(name, long_options(verb));
  for (std::string& option : meant) option.insert(0, "--");
  return io::suggestion_text(meant);
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

// Punctuation to put between `message` and the next clause.
std::string_view end_of(std::string_view message) { return message.ends_with('?') ? "" : ";"; }

// The verbs that help lists.
std::vector<const CLI::App*> nested_verbs(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* verb) { return !verb->get_group().empty(); });
}

std::vector<std::string> names_of_verbs(const std::vector<const CLI::App*>& verbs) {
  std::vector<std::string> names;
  names.reserve(verbs.size());
  for (const CLI::App* verb : verbs) names.push_back(verb->get_name());
  return names;
}

// "team new"; empty for the program.
std::string words_to(const CLI::App& verb) {
  const CLI::App* parent = verb.get_parent();
  if (parent == nullptr) return {};
  const std::string before = words_to(*parent);
  return before.empty() ? verb.get_name() : before + " " + verb.get_name();
}

// The words that call a verb, by the verb's own name: "replay" maps to "results replay".
using CallsByName = std::map<std::string, std::string>;

// All words that call a verb, including those of verbs in groups and former names.
CallsByName all_calls(const CLI::App& program) {
  CallsByName calls;
  for (const CLI::App* verb : nested_verbs(program)) calls[verb->get_name()] = verb->get_name();
  for (const CLI::App* group : nested_verbs(program)) {
    for (const CLI::App* verb : nested_verbs(*group))
      calls.emplace(verb->get_name(), words_to(*verb));
  }
  for (const FormerName& name : former_names()) calls.emplace(name.former, name.present);
  return calls;
}

// A verb of the program or group that may have been meant, or a verb of exactly this name
// elsewhere.
std::string verb_suggestion(const std::string& word, const CLI::App& app) {
  const CLI::App* program = &app;
  while (program->get_parent() != nullptr) program = program->get_parent();
  const CallsByName calls = all_calls(*program);
  if (const auto exact = calls.find(word); exact != calls.end())
    return io::suggestion_text({"autoref " + exact->second});
  if (program != &app) return io::suggestion(word, names_of_verbs(nested_verbs(app)));
  std::vector<std::string> names;
  for (const auto& [name, call] : calls) names.push_back(name);
  std::vector<std::string> meant = io::suggested_words(word, names);
  for (std::string& name : meant) name = calls.at(name);
  return io::suggestion_text(meant);
}

// The verb that caused an error: the first one on the line with unexpected words, otherwise the
// last one. CLI11 reports unexpected words before a verb as extras of the program itself.
const CLI::App& blamed_verb(const CLI::App& app) {
  const CLI::App* verb = &app;
  while (verb->remaining().empty() && !verb->get_subcommands().empty())
    verb = verb->get_subcommands().front();
  return *verb;
}

// CLI11 begins the message with the argument's name in help, such as "BOOK: ".
std::string without_argument_name(const CLI::App& verb, const std::string& message) {
  for (const CLI::Option* option : verb.get_options()) {
    const std::string front = option->get_name(true) + ": ";
    if (option->get_positional() && message.starts_with(front)) return message.substr(front.size());
  }
  return message;
}

// Replaces CLI11's message if an argument is missing; empty otherwise.
std::string missing_message(const CLI::App& verb, const CLI::ParseError& error) {
  if (error.get_name() != "RequiredError") return {};
  const std::vector<std::string> verbs = names_of_verbs(nested_verbs(verb));
  if (!verbs.empty()) return "expected one of its verbs: " + io::listed(verbs);
  for (const CLI::Option* option : verb.get_options()) {
    if (error.what() != option->get_name() + " is required" || !option->get_positional()) continue;
    std::string about = option->get_description();
    if (about.ends_with('.')) about.pop_back();
    return fmt::format("an argument is missing: {} ({})", option->get_name(true), about);
  }
  return {};
}

// Replaces CLI11's message about a value that is out of range or not a number, "--seconds: Value x
// not in range 0.000000 to 1000.000000".
std::string out_of_range_message(const std::string& message) {
  constexpr std::string_view kValue = ": Value ";
  constexpr std::string_view kRange = " not in range ";
  constexpr std::string_view kTo = " to ";
  const std::size_t value = message.find(kValue);
  const std::size_t range = message.rfind(kRange);
  const std::size_t to = message.rfind(kTo);
  if (value == std::string::npos || range == std::string::npos || to == std::string::npos ||
      range < value + kValue.size() || to < range + kRange.size())
    return {};
  const auto part = [&message](std::size_t from, std::size_t end) {
    return message.substr(from, end - from);
  };
  const auto number = [](const std::string& text) { return io::number_in(text).value_or(0); };
  return fmt::format("{}: expected a number from {:g} to {:g}, found '{}'", part(0, value),
                     number(part(range + kRange.size(), to)),
                     number(part(to + kTo.size(), message.size())),
                     part(value + kValue.size(), range));
}

// Replaces CLI11's message about a value that is not a number, "Could not convert: --from = x".
std::string unreadable_message(const CLI::ParseError& error) {
  constexpr std::string_view kFront = "Could not convert: ";
  const std::string message = error.what();
  if (std::string text = out_of_range_message(message); !text.empty()) return text;
  const std::size_t equals = message.find(" = ");
  if (!message.starts_with(kFront) || equals == std::string::npos) return {};
  return fmt::format("{}: expected a number, found '{}'",
                     message.substr(kFront.size(), equals - kFront.size()),
                     message.substr(equals + 3));
}

std::string message_about(const CLI::App& verb, const CLI::ParseError& error) {
  const std::vector<std::string> extras = verb.remaining();
  if (!extras.empty()) return extras_message(verb, extras);
  for (const std::string& message : {missing_message(verb, error), unreadable_message(error)})
    if (!message.empty()) return message;
  return without_argument_name(verb, error.what());
}

}  // namespace

bool is_verb(const CLI::App& app, const std::string& word) {
  return !app.get_subcommands([&word](const CLI::App* verb) { return verb->check_name(word); })
              .empty();
}

std::string unknown_verb_message(const CLI::App& app, const std::string& word) {
  const std::string before = words_to(app);
  if (nested_verbs(app).empty()) {
    return fmt::format("'{0}' does not take a verb such as '{1}'; `autoref help {0}` explains it",
                       before, word);
  }
  const std::string nearest = verb_suggestion(word, app);
  const std::string end = nearest.empty() ? ";" : nearest;
  if (!before.empty()) {
    return fmt::format("'{0}' has no verb '{1}'{2} `autoref help {0}` lists its verbs", before,
                       word, end);
  }
  return fmt::format("unknown verb '{}'{} `autoref help` lists them", word, end);
}

std::string message_of(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& verb = blamed_verb(app);
  const std::vector<std::string> extras = verb.remaining();
  const bool is_word = !extras.empty() && option_name(extras.front()).empty();
  if (&verb != &app && is_word && !nested_verbs(verb).empty())
    return unknown_verb_message(verb, extras.front());
  const std::string message = message_about(verb, error);
  if (&verb == &app)
    return fmt::format("{}{} `autoref help` lists the verbs", message, end_of(message));
  return fmt::format("{0}: {1}{2} `autoref help {0}` {3}", words_to(verb), message, end_of(message),
                     nested_verbs(verb).empty() ? "lists its options" : "lists its verbs");
}

}  // namespace autoref::app
