// The page of a recorded game with the calls of both referees, and the parts of the log that it
// shows.
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "league/log_contents.hpp"
#include "logs/calls.hpp"
#include "soccer/side.hpp"
#include "view/game_recording.hpp"
#include "view/page.hpp"

namespace autoref::logs {

// The part of a log between two times (inclusive), in seconds on the frames' clock.
struct LogPart {
  double from_s = -std::numeric_limits<double>::infinity();
  double to_s = std::numeric_limits<double>::infinity();

  bool contains(double time_s) const { return time_s >= from_s && time_s <= to_s; }
};

// Collects a log's frames and signals for a page.
class LogRecorder final : public league::LogVisitor {
 public:
  explicit LogRecorder(LogPart part = {}) : part_(part) {}

  void on_frame(const Frame& frame) override;
  void on_referee(double time_s, const league::RefereePacket& packet) override;

  // The frames and signals of the part. The first signal is the last one before the part.
  view::GameRecording recording;
  PerSide<std::string> names;  // names of the teams, as in the last packet

 private:
  void add_signal_before();

  LogPart part_;
  std::optional<RefereeSignal> before_;  // the last signal before the part, until it is recorded
};

// The calls of both referees in order of time.
std::vector<view::ComparedCall> compared_calls(const Agreement& agreement);

// `recording` has AutoRef's decisions, and the chains and shots of the game; their `chain_kinds` as
// in view::PageContent. `name` is the path that the user gave for the log. Throws league::LogError.
std::string log_page(const std::filesystem::path& log, const std::string& name, const Field& field,
                     const view::GameRecording& recording,
                     const std::optional<view::ChainKinds>& chain_kinds, const Agreement& agreement,
                     league::FrameSource source = league::FrameSource::kFirst);

// The address of a moment on the page of a recorded game, such as "game.html#t=83.20".
std::string moment_in(const std::string& page, double time_s);

}  // namespace autoref::logs
