#include "app/shared_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "io/processes/workers.hpp"
#include "io/words.hpp"

namespace autoref::app {

void add_set_option(CLI::App& verb, std::vector<std::string>& sets, const std::string& about) {
  verb.add_option("--set", sets, about)->type_name("KEY=VALUE")->allow_extra_args(false);
}

void add_json_flag(CLI::App& verb, bool& json) {
  verb.add_flag("--json", json, "Print one JSON object.");
}

CLI::Option* add_workers_option(CLI::App& verb, int& workers, const std::string& about) {
  return verb.add_option("-j,--workers", workers, about + " Default: one per processor.")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
}

int worker_count(int workers) { return workers > 0 ? workers : io::processors(); }

void add_output_option(CLI::App& verb, std::string& output, const std::string& about) {
  verb.add_option("-o,--output", output, about)->type_name("FILE")->required();
}

void add_decision_outputs(CLI::App& verb, std::string& events, std::string& game_events) {
  verb.add_option("--events", events,
                  "Write AutoRef's decisions to FILE, one JSON object per line.")
      ->type_name("FILE");
  verb.add_option("--game-events", game_events,
                  "Write AutoRef's decisions to FILE as the league's game events, one JSON object "
                  "per line.")
      ->type_name("FILE");
}

void add_play_outputs(CLI::App& verb, std::string& chains, std::string& actions) {
  verb.add_option("--chains", chains, "Write the teams' possession chains to FILE, as CSV.")
      ->type_name("FILE");
  verb.add_option("--actions", actions,
                  "Write the passes, dribbles, shots, losses and fouls to FILE, as CSV, with what "
                  "each was worth.")
      ->type_name("FILE");
}

void add_log_argument(CLI::App& verb, std::string& log) {
  verb.add_option("LOG", log, "A .log or .log.gz file.")->required();
}

void add_logs_argument(CLI::App& verb, std::vector<std::string>& logs) {
  verb.add_option("LOG", logs, ".log and .log.gz files, or folders of them.")->required();
}

void add_field_option(CLI::App& verb, std::string& rules) {
  verb.add_option("--rules", rules, "Rule book that defines the field if the log has no geometry.")
      ->type_name("BOOK")
      ->capture_default_str();
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  const auto fault = [words](const std::string& word) -> std::string {
    if (std::find(words.begin(), words.end(), word) != words.end()) return {};
    return fmt::format("expected one of {}, found '{}'{}", io::listed(words), word,
                       io::suggestion(word, words));
  };
  return {fault, fmt::format("{{{}}}", fmt::join(words, ","))};
}

std::vector<std::string> words_in_type(const std::string& type_name) {
  const std::size_t brace = type_name.find(":{");
  const bool is_checked = brace != std::string::npos && type_name.ends_with('}');
  if (!is_checked && type_name.find('|') == std::string::npos) return {};
  std::istringstream list(is_checked ? type_name.substr(brace + 2, type_name.size() - brace - 3)
                                     : type_name);
  std::vector<std::string> words;
  for (std::string word; std::getline(list, word, is_checked ? ',' : '|');)
    if (io::lower_case(word) == word) words.push_back(word);
  return words;
}

}  // namespace autoref::app
