#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "app/output_file.hpp"
#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "io/build_id.hpp"
#include "io/errors.hpp"
#include "logs/log_page.hpp"
#include "logs/user_log.hpp"
#include "view/game_recording.hpp"
#include "view/page.hpp"

namespace autoref::app {
namespace {

struct ViewArguments {
  std::string log;
  std::string output;
  std::string events;  // file of the referee's decisions; empty: none
  std::string rules = "paper";
  logs::LogPart part;
};

void add_decisions(const std::string& file, const logs::LogPart& part,
                   view::GameRecording& recording) {
  if (file.empty()) return;
  for (view::RecordedDecision& decision : view::decisions_in(io::read_user_file(file), file))
    if (part.contains(decision.time_s)) recording.add(std::move(decision));
}

void check_part(const logs::LogPart& part) {
  if (part.from_s < part.to_s) return;
  throw io::InputError({}, "--to", fmt::format("must be later than --from, {} s", part.from_s));
}

std::string file_name_of(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

std::string about(const view::GameRecording& recording, const std::string& path,
                  std::size_t bytes) {
  return fmt::format("{}: {} frames, {:.1f} s, {:.1f} MB\n", path, recording.frames(),
                     recording.last_s() - recording.first_s(), static_cast<double>(bytes) / 1e6);
}

int view_verb(const ViewArguments& arguments) {
  check_outputs({{"-o", arguments.output}}, {arguments.log, arguments.events});
  check_part(arguments.part);
  std::optional<io::PendingFile> file;
  open_output(file, "-o", arguments.output);
  logs::LogRecorder recorder(arguments.part);
  add_decisions(arguments.events, arguments.part, recorder.recording);
  const league::LogSummary log = logs::read_user_log(arguments.log, recorder);
  if (recorder.recording.frames() == 0) {
    throw io::InputError(
        {arguments.log}, "--from",
        "the log has no frames between these times; autoref log info shows how long it is");
  }
  if (recorder.recording.is_full()) {
    io::write_message(stderr, fmt::format("autoref: {}: the page shows only the first {} frames\n",
                                          arguments.log, recorder.recording.frames()));
  }
  const std::string page = view::page_of({recorder.recording,
                                          logs::field_shown(arguments.log, log, arguments.rules),
                                          recorder.names,
                                          {{"log", file_name_of(arguments.log)},
                                           {"page made by build", std::string(io::build_id())}}});
  file->commit(page);
  fmt::print("{}", about(recorder.recording, arguments.output, page.size()));
  return log.damage ? io::kBadInput : io::kDone;
}

}  // namespace

void add_view_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("view", "Turn a recorded game into an HTML page.");
  auto arguments = std::make_shared<ViewArguments>();
  add_log_argument(*verb, arguments->log);
  add_output_option(*verb, arguments->output, "The page, a self-contained HTML file.");
  verb->add_option("--events", arguments->events,
                   "The referee's decisions, as written by play --events or referee log --events.")
      ->type_name("FILE");
  verb->add_option("--from", arguments->part.from_s,
                   "Show the game only from this time on, in seconds from the start of the log.")
      ->type_name("S");
  verb->add_option("--to", arguments->part.to_s, "Show the game only up to this time.")
      ->type_name("S");
  add_field_option(*verb, arguments->rules);
  verb->footer(
      "If the log is damaged, the page shows the part before the damage, and the exit code is "
      "2.\n\n"
      "Examples:\n  autoref view game.log.gz -o game.html\n"
      "  autoref view game.log.gz --from 80 --to 95 -o goal.html");
  choose(*verb, chosen, arguments, view_verb);
}

}  // namespace autoref::app
