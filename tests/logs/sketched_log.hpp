// Logs of a made-up game with the oddities that a test needs.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "league/messages/referee.pb.h"
#include "league/messages/vision.pb.h"
#include "soccer/field.hpp"
#include "soccer/rules/rule_book.hpp"
#include "soccer/side.hpp"

namespace autoref::logs {

// The first seconds of a game: robots move, the ball rolls over a touch line, and the referee sends
// STOP, a kick-off and NORMAL_START.
struct SketchedLog {
  double length_s = 6;
  Field field = {};
  int cameras = 4;
  PerSide<int> robots = {{6, 6}};
  bool has_geometry = true;
  bool has_referee = true;
  bool has_vision = true;
  // Each of these modifies what is written, unless it is empty.
  std::function<void(league::FieldSize&)> change_field = {};
  std::function<void(league::FieldSize&)> change_field_later = {};  // from the middle of the log on
  std::function<void(double time_s, league::RefereePacket&)> change_referee = {};
  std::function<void(league::DetectionFrame&)> change_detection = {};
  std::function<double(double time_s)> capture_s = {};  // in the clock of the cameras
  std::function<double(double time_s)> record_s = {};   // timestamps of the log's records
};

void write_sketch(const SketchedLog& sketch, const std::filesystem::path& log);

// Concatenates the records of all logs without changing their times.
void join_logs(const std::vector<std::string>& logs, const std::filesystem::path& log);

}  // namespace autoref::logs
