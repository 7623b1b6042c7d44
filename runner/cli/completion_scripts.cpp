#include <fmt/format.h>

#include "runner/cli/described_verb.hpp"

namespace autoref::runner {
namespace {

std::string quoted_word(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') {
      quoted += "'\\''";
    } else {
      quoted += c == '\n' ? ' ' : c;
    }
  }
  return quoted + "'";
}

// The names of options with dashes.
std::vector<std::string> dashed_names(const DescribedVerb& verb) {
  std::vector<std::string> names;
  for (const DescribedOption& option : verb.options)
    if (!option.is_positional) names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::string verb_names(const DescribedVerb& verb) {
  std::vector<std::string> names;
  for (const DescribedVerb& nested : verb.verbs) names.push_back(nested.name);
  return joined(names);
}

// A line for each verb, whose words are counted by `depth`: what may follow it.
std::string bash_cases(const DescribedVerb& verb, const std::string& path) {
  std::string cases =
      fmt::format("    {}) words={} verbs={} ;;\n", quoted_word(path),
                  quoted_word(joined(dashed_names(verb))), quoted_word(verb_names(verb)));
  for (const DescribedVerb& nested : verb.verbs)
    cases += bash_cases(nested, path.empty() ? nested.name : path + " " + nested.name);
  return cases;
}

// zsh: a description in an option's specification.
std::string zsh_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string zsh_options(const DescribedVerb& verb) {
  std::string words;
  for (const DescribedOption& option : verb.options) {
    if (option.is_positional) continue;
    for (const std::string& name : option.names) {
      const std::string value =
          option.value.empty() ? "" : ":" + zsh_text(option.value) + ":_files";
      words += " \\\n      " +
               quoted_word(fmt::format("{}[{}]{}", name, zsh_text(option.description), value));
    }
  }
  return words + " \\\n      '*:file:_files'\n";
}

// `place` is the number of the word after the verb's name.
std::string zsh_body(const DescribedVerb& verb, int place) {
  if (verb.verbs.empty()) return "    _arguments" + zsh_options(verb);
  std::string body = fmt::format("  if (( CURRENT == {} )); then\n    verbs=(", place);
  for (const DescribedVerb& nested : verb.verbs)
    body += "\n      " + quoted_word(nested.name + ":" + zsh_text(nested.description));
  body += fmt::format(
      "\n    )\n    _describe verb verbs\n    return\n  fi\n  case ${{words[{}]}} in\n", place);
  for (const DescribedVerb& nested : verb.verbs)
    body += fmt::format("  {})\n{}    ;;\n", nested.name, zsh_body(nested, place + 1));
  return body + "  esac\n";
}

void add_fish(const DescribedVerb& verb, const std::string& condition, std::string& script) {
  const auto complete = [&](const std::string& what, const std::string& about) {
    script += fmt::format("complete -c autoref -n {} {} -d {}\n", quoted_word(condition), what,
                          quoted_word(about));
  };
  for (const DescribedOption& option : verb.options) {
    if (option.is_positional) continue;
    std::string what;
    for (const std::string& name : option.names)
      what += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    complete(what.substr(1) + (option.value.empty() ? "" : " -r"), option.description);
  }
  const std::string before_verb = quoted_word(
      fmt::format("{}; and not __fish_seen_subcommand_from {}", condition, verb_names(verb)));
  for (const DescribedVerb& nested : verb.verbs) {
    script += fmt::format("complete -c autoref -n {} -f -a {} -d {}\n", before_verb, nested.name,
                          quoted_word(nested.description));
    add_fish(nested, condition + "; and __fish_seen_subcommand_from " + nested.name, script);
  }
}

}  // namespace

std::string bash_completion(const DescribedVerb& program) {
  return "# Completion of autoref in bash, printed by `autoref completion bash`.\n"
         "_autoref() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} path='' words='' verbs='' next word\n"
         "  _autoref_follow() {\n"
         "    case $1 in\n" +
         bash_cases(program, "") +
         "    *) return 1 ;;\n"
         "    esac\n"
         "  }\n"
         "  _autoref_follow ''\n"
         "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
         "    next=${path:+$path }$word\n"
         "    [[ \" $verbs \" == *\" $word \"* ]] && _autoref_follow \"$next\" && path=$next\n"
         "  done\n"
         "  unset -f _autoref_follow\n"
         "  COMPREPLY=()\n"
         "  [[ $current == -* ]] && verbs=$words\n"
         "  [[ -n $verbs ]] && mapfile -t COMPREPLY < <(compgen -W \"$verbs\" -- \"$current\")\n"
         "  return 0\n"
         "}\n"
         "complete -o default -F _autoref autoref\n";
}

std::string zsh_completion(const DescribedVerb& program) {
  return "#compdef autoref\n"
         "# Completion of autoref in zsh, printed by `autoref completion zsh`.\n"
         "_autoref() {\n"
         "  local -a verbs\n" +
         zsh_body(program, 2) + "}\n_autoref \"$@\"\n";
}

std::string fish_completion(const DescribedVerb& program) {
  std::string script = "# Completion of autoref in fish, printed by `autoref completion fish`.\n";
  add_fish(program, "true", script);
  return script;
}

}  // namespace autoref::runner
