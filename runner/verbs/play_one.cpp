#include "runner/verbs/play_one.hpp"

#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <optional>

#include "runner/build_id.hpp"
#include "runner/errors.hpp"
#include "runner/event_log.hpp"
#include "runner/files.hpp"
#include "runner/game_report.hpp"

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
  explicit Watch(EventLog& log) : log_(log) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, end_soon);
  }
  void on_frame(const Frame& /*frame*/, const RefereeSignal& /*signal*/,
                const sim::World& /*world*/) override {
    if (interrupted != 0) throw Interrupted();
  }
  void on_decision(const referee::Decision& decision) override { log_.on_decision(decision); }

 private:
  EventLog& log_;
};

// The file for the decisions, opened before the game so that a wrong name is noticed at once.
std::optional<PendingFile>& open_events(std::optional<PendingFile>& file, const std::string& path,
                                        const std::string& source) {
  if (path.empty()) return file;
  std::error_code none;
  if (std::filesystem::equivalent(path, source, none)) {
    throw InputError({"--events"}, "", "this is the scenario itself, which would be lost");
  }
  try {
    return file.emplace(path), file;
  } catch (const InputOutputError& error) {
    throw InputError({"--events"}, "", error.what());
  }
}

}  // namespace

GameRecord play_one(const GameConfiguration& game, const GameOutput& output) {
  std::optional<PendingFile> events;
  open_events(events, output.events, output.source);
  EventLog log;
  Watch watch(log);
  const auto start = std::chrono::steady_clock::now();
  GameRecord record = play(game, &watch);
  const double wall_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (events) events->commit(log.text());
  const GameReport report{game, record, wall_s, build_id()};
  fmt::print("{}\n", output.json ? json_of(report) : text_of(report));
  return record;
}

}  // namespace autoref::runner
