// The verbs of `autoref` and their command-line arguments.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/game/play_one.hpp"
#include "app/web_flags.hpp"

#include "experiments/kinds/scenario.hpp"
#include "game/settings/assignments.hpp"
#include "live/live_options.hpp"
#include "live/referee/live_referee.hpp"
#include "logs/log_page.hpp"
#include "logs/recorded_facts.hpp"

namespace autoref::app {

// Arguments of `autoref play`.
struct PlayArguments {
  std::string file;               // empty: the defaults, with --from
  std::string from;               // LOG@SECONDS where the game begins; empty: with a kick-off
  std::string seed;               // empty: the scenario's seed
  std::vector<std::string> sets;  // "key=value"
  std::string commands;           // file of recorded commands; empty: the programs play
  std::string game_controller;    // HOST[:PORT] of the one that commands; empty: the default
  GameOutput output;
};

// Arguments of `autoref live`.
struct LiveArguments {
  std::string file;
  std::string seed;               // empty: the scenario's seed
  std::vector<std::string> sets;  // "key=value"
  std::string speed = "1";        // a factor, "max" or "lockstep"
  live::LiveOptions options;      // without the speed
  bool broadcasts = false;        // instead of sending to the groups
  GameOutput output;
};

// Arguments common to the verbs that play many games.
struct BatchArguments {
  std::string file;
  std::string folder;                        // empty: results/runs/<scenario>
  int workers = 0;                           // 0: one per processor
  std::string pairs;                         // overrides the file's pairs unless empty
  std::string seed;                          // overrides the file's seed unless empty
  std::vector<std::string> sets;             // "key=value"
  std::vector<std::string> verbs = {"run"};  // whose scenarios are accepted

  std::filesystem::path results_folder() const;
  int worker_count() const;
};

// Arguments of `autoref run`.
struct RunArguments : BatchArguments {
  std::string shard = "0/1";
  bool allow_mixed_build = false;
  bool quiet = false;
  std::string progress;  // "plain", "json" or "none"; empty: depends on the stream
  WebFlags web;          // where to show the standings on the network
  double wait_s = 0;     // for other shards' games that the next ones depend on
};

// Arguments of `autoref submit`.
struct SubmitArguments : BatchArguments {
  int tasks = 0;                     // 0: the default number
  std::string time;                  // time limit of a task; empty: the partition's limit
  std::string partition;             // empty: the cluster's default
  std::vector<std::string> options;  // passed on to sbatch
  bool slurm = false;                // required; Slurm is the only engine so far
  bool dry_run = false;
};

// Arguments of `autoref check`.
struct CheckArguments : BatchArguments {
  bool games = false;
};

// Arguments common to the verbs that read a results folder.
struct FolderArguments {
  std::string folder;
  std::string build;  // only this build's rows count; empty: the folder's only build
};

// Arguments of `autoref report`.
struct ReportArguments : FolderArguments {
  bool allow_fewer = false;  // whether results.csv may lose games
};

// Arguments of `autoref verify`.
struct VerifyArguments : FolderArguments {
  int sample = 5;
  int workers = 0;  // 0: one per processor
};

// Arguments of `autoref replay`.
struct ReplayArguments : FolderArguments {
  std::string game;
  GameOutput output;
};

// Arguments of `autoref export`.
struct ExportArguments : FolderArguments {
  std::string sqlite;
  bool is_without_events = false;
  bool replaces = false;  // an existing file
  int workers = 0;        // 0: one per processor
};

// Arguments of `autoref judge`.
struct JudgeArguments : BatchArguments {
  std::string seeds;  // name of the only master seed to play; empty: all of the file's
  bool allow_mixed_build = false;
  bool json = false;
};

// Arguments of `autoref info`.
struct InfoArguments {
  std::string log;
  bool commands = false;
  bool json = false;
};

// Arguments of `autoref referee`.
struct RefereeArguments {
  std::string log;
  std::string rules;          // empty: guessed from the log
  std::string first_kickoff;  // empty: as in the log
  std::string control;        // empty: human if the log has a referee's commands, else none
  std::string source;         // vision or tracker; empty: vision if the log begins with it
  std::string camera;  // camera preset; empty: no vision error except the rounding in the packets
  std::vector<std::string> sets;  // "key=value"
  std::string events;             // output file for AutoRef's decisions; empty: none
  std::string game_events;        // output file for its game events; empty: none
  std::string annotations;        // CSV to compare with; empty: the recorded commands
  std::string report;             // output file for the page of both referees; empty: none
  bool json = false;

  bool is_live = false;           // the network instead of a log
  live::LiveRefereeOptions live;  // without the controller
  bool broadcasts = false;        // instead of sending to the groups
  std::string game_controller;    // auto or HOST[:PORT]; empty: none
  WebFlags web;                   // where to show the game on the network
};

// Arguments of `autoref lab`.
struct LabArguments {
  std::string file;
  std::string csv;  // empty: standard output
};

// Arguments of `autoref view`.
struct ViewArguments {
  std::string log;
  std::string output;
  std::string events;  // file of the referee's decisions; empty: none
  std::string rules = "paper";
  logs::LogPart part;
};

// Arguments of `autoref draw`; numbers are not yet parsed.
struct DrawArguments {
  std::string log;
  std::string output;
  std::string at;     // in seconds; empty if `trace` is given
  std::string trace;  // "from:to", in seconds
  std::string rules = "paper";
  std::string situation;  // to draw from a scenario instead of a log; empty: none
  int scene = 1;          // number of its scene
};

// Arguments of `autoref rules`.
struct RulesArguments {
  std::string book;      // empty: list the rule books
  bool machine = false;  // print the state machine as a graph instead
  bool json = false;
};

// Arguments of `autoref teams`.
struct TeamsArguments {
  std::string name;  // empty: list the teams
  bool json = false;
};

// Arguments of `autoref team new`.
struct TeamNewArguments {
  std::string language;
  std::string folder;
};

// Arguments of `autoref team play`.
struct TeamPlayArguments {
  std::string command;
  std::string opponent = "dummy";
  std::vector<std::string> sets;  // "key=value"
  GameOutput output;
};

// Arguments of `autoref team check`.
struct TeamCheckArguments {
  std::string command;
  std::vector<std::string> sets;  // "key=value"
  bool json = false;
};

// Arguments of `autoref sample-size`; numbers are not yet parsed.
struct SampleSizeArguments {
  std::string delta;
  std::string sd;
  std::string power = "0.8";
  bool json = false;
};

// Each of these functions runs its verb and returns the exit code. Errors are thrown (errors.hpp).
int play_verb(const PlayArguments& arguments);
int live_verb(const LiveArguments& arguments);
int run_verb(const RunArguments& arguments);
int tune_verb(const RunArguments& arguments);
int submit_verb(const SubmitArguments& arguments);
int check_verb(const CheckArguments& arguments);
int report_verb(const ReportArguments& arguments);
int status_verb(const FolderArguments& arguments);
int verify_verb(const VerifyArguments& arguments);
int export_verb(const ExportArguments& arguments);
int replay_verb(const ReplayArguments& arguments);
int judge_verb(const JudgeArguments& arguments);
int info_verb(const InfoArguments& arguments);
int referee_verb(const RefereeArguments& arguments);
int live_referee_verb(const RefereeArguments& arguments);
int lab_verb(const LabArguments& arguments);
int view_verb(const ViewArguments& arguments);
int draw_verb(const DrawArguments& arguments);
int sample_size_verb(const SampleSizeArguments& arguments);
int rules_verb(const RulesArguments& arguments);
int team_new_verb(const TeamNewArguments& arguments);
int team_play_verb(const TeamPlayArguments& arguments);
int team_check_verb(const TeamCheckArguments& arguments);
int teams_verb(const TeamsArguments& arguments);
// Explains the verb that the words lead to, such as "team", "new"; without words, lists the verbs.
int help_verb(const CLI::App& app, const std::vector<std::string>& words);

// Adds a verb to the command line; parsing sets `chosen` to the work to do.
using Chosen = std::function<int()>;
// Reads a whole log from `copy` (seekable_log()). Throws InputError if the file is not a log.
logs::RecordedFacts read_facts(const std::string& path, const std::string& copy,
                               league::FrameSource source = league::FrameSource::kFirst);
// Reads an experiment of one of the arguments' verbs and applies --set, --pairs and --seed. Throws
// InputError for a scenario of another kind, naming the verb that plays it.
experiments::Scenario read_experiment(const BatchArguments& arguments);
// The game of a scenario, with the assignments; an empty seed leaves the scenario's. Throws
// InputError for a scenario of another kind, naming the verb that plays it.
game::GameSettings game_in(const std::string& file, const std::string& seed,
                           const game::Assignments& assignments);
// The files that a game is read from: the scenario, recorded commands unless empty, and the robot
// type files named by the scenario or by --set.
std::vector<std::string> inputs_of(const std::string& file, const std::string& commands,
                                   const game::Assignments& assignments);
// Adds --set.
void add_set_option(CLI::App& verb, std::vector<std::string>& sets);
void add_batch_options(CLI::App& verb, BatchArguments& arguments);
// Adds --pairs and --seed.
void add_override_options(CLI::App& verb, BatchArguments& arguments);
void add_play_verb(CLI::App& app, Chosen& chosen);
void add_live_verb(CLI::App& app, Chosen& chosen);
void add_run_verb(CLI::App& app, Chosen& chosen);
void add_tune_verb(CLI::App& app, Chosen& chosen);
// Adds the options of a run, from --output to --quiet.
void add_run_options(CLI::App& verb, RunArguments& arguments);
// Describes the scenarios that these verbs play.
std::string about_scenario(const std::vector<std::string>& verbs);
void add_submit_verb(CLI::App& app, Chosen& chosen);
void add_check_verb(CLI::App& app, Chosen& chosen);
// Adds the folder and --build.
void add_folder_options(CLI::App& verb, FolderArguments& arguments);
void add_report_verb(CLI::App& app, Chosen& chosen);
void add_status_verb(CLI::App& app, Chosen& chosen);
void add_verify_verb(CLI::App& app, Chosen& chosen);
void add_export_verb(CLI::App& app, Chosen& chosen);
void add_replay_verb(CLI::App& app, Chosen& chosen);
void add_judge_verb(CLI::App& app, Chosen& chosen);
void add_info_verb(CLI::App& app, Chosen& chosen);
void add_referee_verb(CLI::App& app, Chosen& chosen);
// The address of --broadcast. Throws InputError if the interface has none.
std::string broadcast_of(const std::string& interface);

void add_live_referee_options(CLI::App& verb, RefereeArguments& arguments);
void add_lab_verb(CLI::App& app, Chosen& chosen);
void add_view_verb(CLI::App& app, Chosen& chosen);
void add_draw_verb(CLI::App& app, Chosen& chosen);
void add_sample_size_verb(CLI::App& app, Chosen& chosen);
void add_rules_verb(CLI::App& app, Chosen& chosen);
void add_team_verb(CLI::App& app, Chosen& chosen);
void add_team_new_verb(CLI::App& team, Chosen& chosen);
void add_team_play_verb(CLI::App& team, Chosen& chosen);
void add_team_check_verb(CLI::App& team, Chosen& chosen);
void add_teams_verb(CLI::App& app, Chosen& chosen);
void add_bench_verb(CLI::App& app, Chosen& chosen);
void add_completion_verb(CLI::App& app, Chosen& chosen);
void add_man_verb(CLI::App& app, Chosen& chosen);
void add_reference_verb(CLI::App& app, Chosen& chosen);
void add_help_verb(CLI::App& app, Chosen& chosen);

// Runs `work`; turns an exception into a message on stderr, which begins with the program's name,
// and an exit code (errors.hpp).
int exit_code_of(const Chosen& work, std::string_view program = "autoref");

}  // namespace autoref::app
