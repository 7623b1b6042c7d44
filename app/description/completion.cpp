#include "app/description/completion.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "app/description/described_verb.hpp"
#include "app/former_names.hpp"
#include "io/errors.hpp"

namespace autoref::app {
namespace {

constexpr std::size_t kMostProposals = 200;

const DescribedVerb* find_nested(const DescribedVerb& verb, const std::string& name) {
  const auto found = std::find_if(verb.verbs.begin(), verb.verbs.end(),
                                  [&name](const DescribedVerb& one) { return one.name == name; });
  return found == verb.verbs.end() ? nullptr : &*found;
}

const DescribedOption* find_option(const DescribedVerb& verb, const std::string& name) {
  const auto has_name = [&name](const DescribedOption& option) {
    return !option.is_positional &&
           std::find(option.names.begin(), option.names.end(), name) != option.names.end();
  };
  const auto found = std::find_if(verb.options.begin(), verb.options.end(), has_name);
  return found == verb.options.end() ? nullptr : &*found;
}

// A partly typed command line.
struct BegunLine {
  const DescribedVerb* verb = nullptr;
  const DescribedOption* awaits_value = nullptr;  // option whose value is the last word
  std::vector<std::string> positionals;
  std::string last;
};

BegunLine begun_line(const DescribedVerb& program, const std::vector<std::string>& words) {
  BegunLine line;
  line.verb = &program;
  line.last = words.empty() ? "" : words.back();
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    const std::string& word = words[i];
    if (line.awaits_value != nullptr) {
      line.awaits_value = nullptr;
    } else if (word.starts_with('-')) {
      const DescribedOption* option = find_option(*line.verb, word);
      if (option != nullptr && !option->value.empty()) line.awaits_value = option;
    } else if (const DescribedVerb* nested = find_nested(*line.verb, word)) {
      line.verb = nested;
    } else {
      line.positionals.push_back(word);
    }
  }
  return line;
}

// The words with a verb's former name replaced, unless it is still being typed.
std::vector<std::string> present_words(const std::vector<std::string>& words) {
  if (words.empty()) return words;
  std::vector<std::string> present = with_present_names({words.begin(), words.end() - 1});
  present.push_back(words.back());
  return present;
}

void add_if_begun(const std::string& word, const std::string& about, const std::string& begun,
                  std::vector<Proposal>& proposals) {
  if (word.starts_with(begun)) proposals.push_back({word, about});
}

std::vector<Proposal> verbs_in(const DescribedVerb& verb, const std::string& begun) {
  std::vector<Proposal> proposals;
  for (const DescribedVerb& nested : verb.verbs)
    add_if_begun(nested.name, nested.description, begun, proposals);
  return proposals;
}

std::vector<Proposal> options_in(const DescribedVerb& verb, const std::string& begun) {
  std::vector<Proposal> proposals;
  for (const DescribedOption& option : verb.options) {
    if (option.is_positional) continue;
    for (const std::string& name : option.names)
      add_if_begun(name, option.description, begun, proposals);
  }
  return proposals;
}

std::vector<Proposal> option_values(const DescribedOption& option, ValuePlace place) {
  place.kind = option.is_positional ? option.names.front() : option.value;
  if (option.allowed_words.empty()) return values_at(place);
  std::vector<Proposal> proposals;
  for (const std::string& word : option.allowed_words)
    add_if_begun(word, "", place.begun, proposals);
  return proposals;
}

// "--rules=2026-b" for "--rules=20".
std::vector<Proposal> values_after_equals(const BegunLine& line) {
  const std::size_t equals = line.last.find('=');
  const DescribedOption* option = find_option(*line.verb, line.last.substr(0, equals));
  if (option == nullptr) return {};
  std::vector<Proposal> proposals =
      option_values(*option, {"", line.last.substr(equals + 1), line.positionals});
  for (Proposal& one : proposals) one.word.insert(0, line.last.substr(0, equals + 1));
  return proposals;
}

// The verbs that `autoref help WORD ...` explains.
std::vector<Proposal> explained_verbs(const DescribedVerb& program, const BegunLine& line) {
  const DescribedVerb* verb = &program;
  for (const std::string& word : line.positionals)
    if (verb != nullptr) verb = find_nested(*verb, word);
  return verb == nullptr ? std::vector<Proposal>() : verbs_in(*verb, line.last);
}

std::vector<Proposal> positional_values(const DescribedVerb& program, const BegunLine& line) {
  std::vector<const DescribedOption*> places;
  for (const DescribedOption& option : line.verb->options)
    if (option.is_positional) places.push_back(&option);
  if (!places.empty() && places.front()->names.front() == "VERB")
    return explained_verbs(program, line);
  if (line.positionals.size() >= places.size()) return {};
  return option_values(*places[line.positionals.size()], {"", line.last, line.positionals});
}

std::vector<Proposal> all_proposals(const DescribedVerb& program, const BegunLine& line) {
  if (line.awaits_value != nullptr)
    return option_values(*line.awaits_value, {"", line.last, line.positionals});
  const bool has_unknown_verb = !line.verb->verbs.empty() && !line.positionals.empty();
  if (has_unknown_verb) return {};
  if (!line.last.starts_with('-')) {
    return line.verb->verbs.empty() ? positional_values(program, line)
                                    : verbs_in(*line.verb, line.last);
  }
  return line.last.find('=') == std::string::npos ? options_in(*line.verb, line.last)
                                                  : values_after_equals(line);
}

}  // namespace

std::vector<Proposal> proposals_for(const DescribedVerb& program,
                                    const std::vector<std::string>& words) {
  std::vector<Proposal> proposals =
      all_proposals(program, begun_line(program, present_words(words)));
  if (proposals.size() > kMostProposals) proposals.resize(kMostProposals);
  return proposals;
}

int complete_verb(const DescribedVerb& program, const std::vector<std::string>& words) {
  for (Proposal& one : proposals_for(program, words)) {
    std::replace(one.about.begin(), one.about.end(), '\n', ' ');
    fmt::print("{}\t{}\n", one.word, one.about);
  }
  return io::kDone;
}

}  // namespace autoref::app
