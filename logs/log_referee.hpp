// Lets AutoRef referee a recorded game: alone, or beside the recorded referee.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "game/loop/game_event_log.hpp"
#include "logs/calls.hpp"
#include "logs/record_referee.hpp"
#include "logs/recorded_facts.hpp"
#include "referee/referee.hpp"

namespace autoref::logs {

struct LogRefereeResult {
  Agreement agreement;      // between AutoRef's calls and those of the recorded referee
  std::vector<Call> calls;  // each of AutoRef's calls, with its event; also those that stop nothing
  PerSide<int> goals;       // goals counted by AutoRef
  std::vector<game::TimedGameEvent> game_events;  // of AutoRef's decisions
  std::string events;  // AutoRef's decisions, one JSON object per line (event_log.hpp)
  int decisions = 0;
  referee::Control control = referee::Control::kAutoref;  // of the first game
};

// Judges every frame of the log in order (record_referee.hpp). The goals in the result are those of
// the last game. Throws league::LogError, and
// std::invalid_argument if a configuration is not valid for a referee. `configurations` must not be
// empty.
LogRefereeResult referee_log(const std::filesystem::path& log, const RecordedFacts& facts,
                             const std::vector<referee::Configuration>& configurations,
                             const DecisionWatch& watch = {});

}  // namespace autoref::logs
