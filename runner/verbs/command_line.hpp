// The verbs of `autoref`: what each can be told on the command line, and what it does.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace autoref::runner {

// What `autoref play` is told.
struct PlayArguments {
  std::string file;
  std::string seed;               // empty: the scenario's
  std::vector<std::string> sets;  // "key=value"
  std::string events;             // file for the referee's decisions; empty: none
  bool json = false;
};

// What verbs that play many games are told.
struct BatchArguments {
  std::string file;
  std::string folder;  // empty: results/runs/<scenario>
  int workers = 0;     // 0: one per processor

  std::filesystem::path results_folder() const;
  int worker_count() const;
};

// What `autoref run` is told.
struct RunArguments : BatchArguments {
  bool allow_mixed_build = false;
};

// What `autoref judge` is told.
struct JudgeArguments : BatchArguments {
  bool json = false;
};

// What `autoref lab` is told.
struct LabArguments {
  std::string file;
  std::string csv;  // empty: standard output
};

// What `autoref rules` is told.
struct RulesArguments {
  std::string book;  // empty: list the books
  bool json = false;
};

// What `autoref teams` is told.
struct TeamsArguments {
  std::string name;  // empty: list the teams
  bool json = false;
};

// Each does its verb's work and returns the exit code. Mistakes come as exceptions (errors.hpp).
int play_verb(const PlayArguments& arguments);
int run_verb(const RunArguments& arguments);
int judge_verb(const JudgeArguments& arguments);
int lab_verb(const LabArguments& arguments);
int rules_verb(const RulesArguments& arguments);
int teams_verb(const TeamsArguments& arguments);

// Adds a verb to the command line; parsing sets `chosen` to its work.
using Chosen = std::function<int()>;
// Adds the file and the options that all verbs of many games have.
void add_batch_options(CLI::App& verb, BatchArguments& arguments, const std::string& about_file);
void add_play_verb(CLI::App& app, Chosen& chosen);
void add_run_verb(CLI::App& app, Chosen& chosen);
void add_judge_verb(CLI::App& app, Chosen& chosen);
void add_lab_verb(CLI::App& app, Chosen& chosen);
void add_rules_verb(CLI::App& app, Chosen& chosen);
void add_teams_verb(CLI::App& app, Chosen& chosen);
void add_bench_verb(CLI::App& app, Chosen& chosen);

// Does `work` and turns what it throws into a message on stderr and an exit code (errors.hpp).
int exit_code_of(const Chosen& work);

// The whole program.
int run_command_line(int argc, const char* const* argv);

}  // namespace autoref::runner
