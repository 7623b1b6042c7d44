// A log and AutoRef's decisions on it, alongside the recorded referee.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "referee/decision.hpp"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"

namespace autoref::logs {

struct RefereedLog {
  Field field;                // of the first game
  std::vector<Frame> frames;  // in the log's coordinates
  std::vector<referee::Decision> decisions;
  std::string report;  // all that `autoref referee log` and `autoref log info` write about the log
};

// Judges the log as `autoref referee log --camera realistic` does, under the rule book that its
// field and date suggest. Throws league::LogError, and InputError if the log cannot be refereed.
RefereedLog refereed(const std::filesystem::path& log);

// Whether every number in the decision is finite.
bool is_finite(const referee::Decision& decision);

}  // namespace autoref::logs
