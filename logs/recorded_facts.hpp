// Facts about the games in a log, collected before they are refereed.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "game/loop/event_log.hpp"
#include "league/log_contents.hpp"
#include "logs/recorded_teams.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"
#include "tracking/tracker.hpp"

namespace autoref::logs {

// The first occurrence of a command in the log.
struct RecordedCommand {
  double time_s = 0;  // time since the start of the log
  Command command;
  Stage stage = Stage::kFirstHalf;
};

struct RecordedCamera {
  std::int64_t packets = 0;
  double first_s = 0;
  double last_s = 0;
  double longest_gap_s = 0;
  int gaps = 0;  // number of gaps of at least 0.1 s

  // Packets per second; 0 if there are fewer than two.
  double rate_hz() const;
};

// Facts about one game. Most logs contain one.
struct RecordedGame {
  double begins_s = 0;
  std::optional<double> half_s = {};  // length of a half, from the clock of the first half
  int halves = 0;                     // number of halves that were started, without extra time
  bool is_knockout = false;           // whether the game went to extra time or a shoot-out
  // Length of a half of extra time, from the clock of its first half.
  std::optional<double> extra_half_s = {};
  std::optional<Side> first_kickoff = {};
};

// Detects the start of another game from the recorded referee's stages.
class NextGame {
 public:
  bool begins_with(Stage stage);

 private:
  Stage latest_ = Stage::kFirstHalfPre;  // latest stage of the current game
};

struct RecordedFacts {
  league::LogSummary log;
  std::vector<RecordedCommand> commands;            // recorded commands, at most kMostCommands
  std::int64_t commands_left_out = 0;               // number of further commands
  PerSide<std::string> names;                       // names of the teams; empty if unknown
  std::optional<RefereeSignal> last_signal;         // nullopt if there are no referee packets
  std::map<std::uint32_t, RecordedCamera> cameras;  // by camera number
  PerSide<int> robots;                              // maximum number of robots in a frame
  bool has_ball = false;                            // whether any frame has a ball
  // Games in the log: at least one, at most kMostGames.
  std::vector<RecordedGame> games = {{}};
  std::optional<tracking::VisionNoise> noise;     // measured (facts_collector.hpp)
  std::vector<game::TimedGameEvent> game_events;  // game events of the recorded referee
  RecordedTeams teams;                            // found out separately (recorded_teams.hpp)
  std::int64_t unknown_signals = 0;               // packets with an unknown stage or command

  static constexpr std::size_t kMostCommands = 100'000;
  static constexpr std::size_t kMostGames = 100;
};

// Reads the whole log. Throws league::LogError if the file is not a log.
RecordedFacts facts_of(const std::filesystem::path& log,
                       league::FrameSource source = league::FrameSource::kFirst);

}  // namespace autoref::logs
