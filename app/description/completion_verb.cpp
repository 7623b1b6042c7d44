#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "io/errors.hpp"

namespace autoref::app {
namespace {

// The scripts ask the program itself (completion.hpp). bash splits words at '=', ':' and '@' and
// completes only the part after the last of these; the program gets whole words.
std::string bash_completion() {
  return R"(# Completion of autoref in bash, printed by `autoref show completion bash`.
_autoref() {
  local -a words=() replies=()
  local i word before='' prefix='' last=${COMP_WORDS[COMP_CWORD]}
  for ((i = 1; i <= COMP_CWORD; i++)); do
    word=${COMP_WORDS[i]}
    if ((${#words[@]})) && { [[ $word =~ ^[=:@]+$ ]] || [[ $before =~ ^[=:@]+$ ]]; }; then
      words[-1]+=$word
    else
      words+=("$word")
    fi
    before=$word
  done
  if [[ ${words[-1]} != "$last" ]]; then
    prefix=${words[-1]}
    [[ $last =~ ^[=:@]+$ ]] || prefix=${prefix%"$last"}
  fi
  mapfile -t replies < <("${COMP_WORDS[0]/#\~/$HOME}" complete "${words[@]}" 2>/dev/null)
  COMPREPLY=()
  for word in "${replies[@]}"; do
    word=${word%%$'\t'*}
    word=${word#"$prefix"}
    [[ $word == *[!-A-Za-z0-9_./=:@~+]* ]] && printf -v word %q "$word"
    COMPREPLY+=("$word")
  done
  [[ ${COMPREPLY[0]} == *[.=] ]] && compopt -o nospace 2>/dev/null
  return 0
}
complete -o default -F _autoref autoref
)";
}

std::string zsh_completion() {
  return R"(#compdef autoref
# Completion of autoref in zsh, printed by `autoref show completion zsh`.
_autoref() {
  local -a replies whole begun
  local reply word
  replies=("${(@f)$(${(Q)words[1]/#\~/$HOME} complete "${(@Q)words[2,CURRENT-1]}" "${(Q)PREFIX}" 2>/dev/null)}")
  for reply in $replies; do
    word=${${reply%%$'\t'*}//:/\\:}
    if [[ $word == *[.=] ]]; then
      begun+=("$word:${reply#*$'\t'}")
    else
      whole+=("$word:${reply#*$'\t'}")
    fi
  done
  if ((${#whole} + ${#begun} == 0)); then
    _files
    return
  fi
  _describe -t words word whole
  _describe -t words word begun -S ''
}
if [[ $funcstack[1] == _autoref ]]; then
  _autoref "$@"
else
  compdef _autoref autoref
fi
)";
}

std::string fish_completion() {
  return R"(# Completion of autoref in fish, printed by `autoref show completion fish`.
function __autoref_complete
    set -l words (commandline -opc)
    set -l program $words[1]
    set -e words[1]
    set -l last (commandline -ct)
    set -l replies ($program complete $words "$last" 2>/dev/null)
    if test (count $replies) -gt 0
        printf '%s\n' $replies
    else
        __fish_complete_path "$last"
    end
end
complete -c autoref -f -a '(__autoref_complete)'
)";
}

int completion_verb(const std::string& shell) {
  fmt::print("{}", shell == "bash"  ? bash_completion()
                   : shell == "zsh" ? zsh_completion()
                                    : fish_completion());
  return io::kDone;
}

}  // namespace

void add_completion_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand(
      "completion", "Print a script that completes verbs, options and their values in a shell.");
  auto shell = std::make_shared<std::string>();
  verb->add_option("SHELL", *shell, "bash, zsh or fish.")
      ->required()
      ->check(one_of({"bash", "zsh", "fish"}));
  verb->footer(
      "Also completes settings, teams, rule books, cameras, languages of team programs, scenarios\n"
      "in the current folder and in scenarios/, and games of a results folder, where known.\n\n"
      "Example, for the current shell:\n  autoref show completion bash > autoref.bash && . "
      "./autoref.bash");
  choose(*verb, chosen, shell, completion_verb);
}

}  // namespace autoref::app
