// The vision of a played game, its log, and AutoRef's calls on that log.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "game/loop/game_configuration.hpp"
#include "league/log_contents.hpp"
#include "league/log_file.hpp"
#include "league/messages/vision.pb.h"
#include "logs/calls.hpp"

namespace autoref::logs {

// A game as seen by one camera above the field's centre.
struct RecordedVision {
  std::string book;
  Field field;
  double rate_hz = 0;
  std::vector<CameraPosition> cameras;
  std::vector<league::DetectionFrame> frames;
  std::vector<double> ball_height_m;  // at each of the played game's frames
  std::vector<league::LogRecord> referee;
  std::vector<league::LogRecord> tracker = {};
};

// Plays a game of two halves with the camera preset rc2026-b.
RecordedVision played_vision(const std::string& book, double half_s, std::uint64_t seed);

void write_log(const RecordedVision& vision, const std::filesystem::path& log);

// AutoRef's calls alongside the recorded referee. Fails the test if a number in a decision is not
// finite.
std::vector<Call> judged_calls(const RecordedVision& vision, const std::filesystem::path& log,
                               league::FrameSource source = league::FrameSource::kFirst);

}  // namespace autoref::logs
