#include "runner/verbs/play_one.hpp"

#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <optional>

#include "league/game_log.hpp"
#include "runner/build_id.hpp"
#include "runner/errors.hpp"
#include "runner/event_log.hpp"
#include "runner/files.hpp"
#include "runner/game_report.hpp"
#include "runner/match_rules.hpp"
#include "sim/camera.hpp"

namespace autoref::runner {
namespace {

volatile std::sig_atomic_t interrupted = 0;

// The second time ends the program at once: the game may hang.
void end_soon(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

// Ends the game at its next frame once the user has asked for it.
class Watch final : public Observer {
 public:
  Watch(EventLog& events, league::GameLog* log) : events_(events), log_(log) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, end_soon);
  }
  void on_frame(const Frame& frame, const RefereeSignal& signal,
                const sim::World& /*world*/) override {
    if (log_ != nullptr) log_->add(frame, signal);
    if (interrupted != 0) throw Interrupted();
  }
  void on_decision(const referee::Decision& decision) override {
    events_.on_decision(decision);
    if (log_ != nullptr && decision.command) log_->note(*decision.command);
  }

 private:
  EventLog& events_;
  league::GameLog* log_;  // none where the game is not recorded
};

// Throws InputError where `flag` would write over the game's own file.
void spare_source(const char* flag, const std::string& path, const std::string& source) {
  std::error_code none;
  if (!std::filesystem::equivalent(path, source, none)) return;
  throw InputError({flag}, "", "this is the scenario itself, which would be lost");
}

// The file for the decisions, opened before the game so that a wrong name is noticed at once.
std::optional<PendingFile>& open_events(std::optional<PendingFile>& file, const std::string& path,
                                        const std::string& source) {
  if (path.empty()) return file;
  spare_source("--events", path, source);
  try {
    return file.emplace(path), file;
  } catch (const InputOutputError& error) {
    throw InputError({"--events"}, "", error.what());
  }
}

league::TeamSheet sheet_on(const GameConfiguration& game, Side side) {
  return {team_on(game, side).strategy};
}

void open_log(std::optional<league::GameLog>& log, const GameConfiguration& game,
              const std::string& path, const std::string& source) {
  if (path.empty()) return;
  spare_source("--log", path, source);
  const auto cameras = sim::camera_places(game.field);
  log.emplace(
      path, game.field, std::vector<CameraPlace>(cameras.begin(), cameras.end()),
      PerSide<league::TeamSheet>{{sheet_on(game, Side::kWest), sheet_on(game, Side::kEast)}});
}

}  // namespace

void add_output_options(CLI::App& verb, GameOutput& output) {
  verb.add_option("--events", output.events,
                  "Write the referee's decisions to FILE, one JSON object a line.")
      ->type_name("FILE");
  verb.add_option("--log", output.log,
                  "Write the game to FILE as a log of the league; compressed if it ends in .gz.")
      ->type_name("FILE");
  verb.add_flag("--json", output.json, "Print one JSON object.");
}

GameRecord play_one(const GameConfiguration& game, const GameOutput& output,
                    const std::string& source) {
  std::optional<PendingFile> events;
  open_events(events, output.events, source);
  std::optional<league::GameLog> log;
  open_log(log, game, output.log, source);
  EventLog decisions;
  Watch watch(decisions, log ? &*log : nullptr);
  const auto start = std::chrono::steady_clock::now();
  GameRecord record = play(game, &watch);
  const double wall_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (log) log->close();
  if (events) events->commit(decisions.text());
  const GameReport report{game, record, wall_s, build_id()};
  fmt::print("{}\n", output.json ? json_of(report) : text_of(report));
  return record;
}

}  // namespace autoref::runner
