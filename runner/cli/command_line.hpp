// The verbs of `autoref`: what each can be told on the command line, and what it does.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "runner/cli/play_one.hpp"

#include "runner/experiments/scenario.hpp"
#include "runner/logs/recorded_facts.hpp"

namespace autoref::runner {

// What `autoref play` is told.
struct PlayArguments {
  std::string file;
  std::string seed;               // empty: the scenario's
  std::vector<std::string> sets;  // "key=value"
  GameOutput output;
};

// What verbs that play many games are told.
struct BatchArguments {
  std::string file;
  std::string folder;             // empty: results/runs/<scenario>
  int workers = 0;                // 0: one per processor
  std::string pairs;              // instead of the file's; empty: those
  std::string seed;               // likewise
  std::vector<std::string> sets;  // "key=value"

  std::filesystem::path results_folder() const;
  int worker_count() const;
};

// What `autoref run` is told.
struct RunArguments : BatchArguments {
  std::string shard = "0/1";
  bool allow_mixed_build = false;
  bool quiet = false;
  std::string progress;  // "plain", "json" or "none"; empty: as suits the stream
};

// What `autoref submit` is told.
struct SubmitArguments : BatchArguments {
  int tasks = 0;                     // 0: a few
  std::string time;                  // limit of a task; empty: the partition's
  std::string partition;             // empty: the cluster's
  std::vector<std::string> options;  // further ones of sbatch
  bool slurm = false;                // the only engine so far; has to be said
  bool dry_run = false;
};

// What `autoref check` is told.
struct CheckArguments : BatchArguments {
  bool games = false;
};

// What the verbs are told that look at a folder of results.
struct FolderArguments {
  std::string folder;
  std::string build;  // whose rows count; empty: the only one's
};

// What `autoref verify` is told.
struct VerifyArguments : FolderArguments {
  int sample = 5;
  int workers = 0;  // 0: one per processor
};

// What `autoref replay` is told.
struct ReplayArguments : FolderArguments {
  std::string game;
  GameOutput output;
};

// What `autoref judge` is told.
struct JudgeArguments : BatchArguments {
  bool allow_mixed_build = false;
  bool json = false;
};

// What `autoref info` is told.
struct InfoArguments {
  std::string log;
  bool commands = false;
  bool json = false;
};

// What `autoref referee` is told.
struct RefereeArguments {
  std::string log;
  std::string rules = "paper";
  std::string first_kickoff;      // empty: the recorded one
  std::string camera;             // preset; empty: the rounding of the packets is its only error
  std::vector<std::string> sets;  // "key=value"
  std::string events;             // file for AutoRef's decisions; empty: none
  bool json = false;
};

// What `autoref lab` is told.
struct LabArguments {
  std::string file;
  std::string csv;  // empty: standard output
};

// What `autoref view` is told.
struct ViewArguments {
  std::string log;
  std::string output;
  std::string events;  // file with the referee's decisions; empty: none
  std::string rules = "paper";
};

// What `autoref draw` is told: numbers as they were typed.
struct DrawArguments {
  std::string log;
  std::string output;
  std::string at;     // seconds; empty: `trace` is given
  std::string trace;  // "from:to", in seconds
  std::string rules = "paper";
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

// What `autoref sample-size` is told: numbers as they were typed.
struct SampleSizeArguments {
  std::string delta;
  std::string sd;
  std::string power = "0.8";
  bool json = false;
};

// Each does its verb's work and returns the exit code. Mistakes come as exceptions (errors.hpp).
int play_verb(const PlayArguments& arguments);
int run_verb(const RunArguments& arguments);
int submit_verb(const SubmitArguments& arguments);
int check_verb(const CheckArguments& arguments);
int report_verb(const FolderArguments& arguments);
int status_verb(const FolderArguments& arguments);
int verify_verb(const VerifyArguments& arguments);
int replay_verb(const ReplayArguments& arguments);
int judge_verb(const JudgeArguments& arguments);
int info_verb(const InfoArguments& arguments);
int referee_verb(const RefereeArguments& arguments);
int lab_verb(const LabArguments& arguments);
int view_verb(const ViewArguments& arguments);
int draw_verb(const DrawArguments& arguments);
int sample_size_verb(const SampleSizeArguments& arguments);
int rules_verb(const RulesArguments& arguments);
int teams_verb(const TeamsArguments& arguments);
int help_verb(const CLI::App& app, const std::string& word);  // empty: lists the verbs

// Adds a verb to the command line; parsing sets `chosen` to its work.
using Chosen = std::function<int()>;
// Reads a whole log; a file that is none is an InputError.
RecordedFacts read_facts(const std::string& log);
// Reads an experiment, with the settings, the pairs and the seed that flags give; a scenario of
// another kind is refused with the verb that plays it.
Scenario read_experiment(const BatchArguments& arguments);
// Adds the file and the options that all verbs of many games have.
void add_set_option(CLI::App& verb, std::vector<std::string>& sets);
void add_batch_options(CLI::App& verb, BatchArguments& arguments, const std::string& about_file);
// Adds --pairs and --seed, which all verbs of experiments have.
void add_override_options(CLI::App& verb, BatchArguments& arguments);
void add_play_verb(CLI::App& app, Chosen& chosen);
void add_run_verb(CLI::App& app, Chosen& chosen);
void add_submit_verb(CLI::App& app, Chosen& chosen);
void add_check_verb(CLI::App& app, Chosen& chosen);
// Adds the folder and the build that all verbs of folders have.
void add_folder_options(CLI::App& verb, FolderArguments& arguments);
void add_report_verb(CLI::App& app, Chosen& chosen);
void add_status_verb(CLI::App& app, Chosen& chosen);
void add_verify_verb(CLI::App& app, Chosen& chosen);
void add_replay_verb(CLI::App& app, Chosen& chosen);
void add_judge_verb(CLI::App& app, Chosen& chosen);
void add_info_verb(CLI::App& app, Chosen& chosen);
void add_referee_verb(CLI::App& app, Chosen& chosen);
void add_lab_verb(CLI::App& app, Chosen& chosen);
void add_view_verb(CLI::App& app, Chosen& chosen);
void add_draw_verb(CLI::App& app, Chosen& chosen);
void add_sample_size_verb(CLI::App& app, Chosen& chosen);
void add_rules_verb(CLI::App& app, Chosen& chosen);
void add_teams_verb(CLI::App& app, Chosen& chosen);
void add_bench_verb(CLI::App& app, Chosen& chosen);
void add_help_verb(CLI::App& app, Chosen& chosen);

// Does `work` and turns what it throws into a message on stderr and an exit code (errors.hpp).
int exit_code_of(const Chosen& work);

// The whole program.
int run_command_line(int argc, const char* const* argv);

}  // namespace autoref::runner
