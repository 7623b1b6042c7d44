// Options that several verbs have.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace autoref::app {

// Adds --set.
void add_set_option(CLI::App& verb, std::vector<std::string>& sets);

// Adds --json.
void add_json_flag(CLI::App& verb, bool& json);

// Adds -j,--workers, which is 0 unless given. `about` says what it counts.
CLI::Option* add_workers_option(CLI::App& verb, int& workers,
                                const std::string& about = "Games played in parallel.");

// One per processor if `workers` is 0.
int worker_count(int workers);

// Adds -o,--output, a file, which is required.
void add_output_option(CLI::App& verb, std::string& output, const std::string& about);

// Adds --events and --game-events.
void add_decision_outputs(CLI::App& verb, std::string& events, std::string& game_events);

// Adds the argument LOG, which is required.
void add_log_argument(CLI::App& verb, std::string& log);

// Adds --rules, the rule book of a log without geometry.
void add_field_option(CLI::App& verb, std::string& rules);

// A check that accepts only these words; its message suggests one for another word. Help lists
// them, and so does completion (described_verb.hpp).
CLI::Validator one_of(const std::vector<std::string>& words);

// The words of a check in an option's type name, such as "STYLE:{plain,json,none}", or of a type
// name such as "west|east"; words in capitals, such as FACTOR of "FACTOR|max", do not count.
std::vector<std::string> words_in_type(const std::string& type_name);

}  // namespace autoref::app
