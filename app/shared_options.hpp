// Options shared by several verbs.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace autoref::app {

// Adds --set. `about` is its help text.
void add_set_option(CLI::App& verb, std::vector<std::string>& sets,
                    const std::string& about =
                        "Change a setting, such as match.half_s=60 or b.robots=5 (for a named "
                        "team: teams.NAME.robots=5). May be repeated.");

// Adds --json.
void add_json_flag(CLI::App& verb, bool& json);

// Adds -j,--workers, which defaults to 0. `about` is its help text.
CLI::Option* add_workers_option(CLI::App& verb, int& workers,
                                const std::string& about = "Games played in parallel.");

// `workers`, or one per processor if it is 0.
int worker_count(int workers);

// Adds -o,--output, a required file.
void add_output_option(CLI::App& verb, std::string& output, const std::string& about);

// Adds --events and --game-events.
void add_decision_outputs(CLI::App& verb, std::string& events, std::string& game_events);

// Adds --chains and --actions.
void add_play_outputs(CLI::App& verb, std::string& chains, std::string& actions);

// Adds the required argument LOG.
void add_log_argument(CLI::App& verb, std::string& log);

// Adds the required arguments LOG..., for logs_in() (logs/user_log.hpp).
void add_logs_argument(CLI::App& verb, std::vector<std::string>& logs);

// Adds --rules, the rule book to use for a log without geometry.
void add_field_option(CLI::App& verb, std::string& rules);

// A check that accepts only these words; for any other word, its message suggests one of them. Help
// and completion (described_verb.hpp) list them.
CLI::Validator one_of(const std::vector<std::string>& words);

// The allowed words listed in an option's type name, such as "STYLE:{plain,json,none}" or
// "west|east". Words in capitals, such as FACTOR in "FACTOR|max", are left out.
std::vector<std::string> words_in_type(const std::string& type_name);

}  // namespace autoref::app
