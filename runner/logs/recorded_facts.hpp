// Facts about the games in a log, read before they are judged.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "league/log_contents.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"

namespace autoref::runner {

// A command as it stands in the log for the first time.
struct RecordedCommand {
  double time_s = 0;  // from the log's beginning
  Command command;
};

struct RecordedCamera {
  std::int64_t packets = 0;
  double first_s = 0;
  double last_s = 0;
  double longest_gap_s = 0;
  int gaps = 0;  // of 0.1 s and more

  // Packets a second; 0 where there are fewer than two.
  double rate_hz() const;
};

// Facts about one game. Most logs hold one.
struct RecordedGame {
  double begins_s = 0;
  std::optional<double> half_s = {};        // from the clock of the first half
  int halves = 0;                           // begun, without those of extra time
  bool is_knockout = false;                 // it has gone on to extra time or a shoot-out
  std::optional<double> extra_half_s = {};  // from the clock of extra time's first half
  std::optional<Side> first_kickoff = {};
};

// Notices by the stages that a recorded referee sends where it begins another game.
class NextGame {
 public:
  bool begins_with(Stage stage);

 private:
  Stage latest_ = Stage::kFirstHalfPre;  // of the game at hand
};

struct RecordedFacts {
  league::LogSummary log;
  std::vector<RecordedCommand> commands;            // at most kMostCommands
  std::int64_t commands_left_out = 0;               // beyond that
  PerSide<std::string> names;                       // empty where the log does not tell
  std::optional<RefereeSignal> last_signal;         // none where no referee is in the log
  std::map<std::uint32_t, RecordedCamera> cameras;  // by number
  PerSide<int> robots;                              // the most that a frame shows
  std::vector<RecordedGame> games = {{}};           // at least one, at most kMostGames
  std::int64_t unknown_signals = 0;                 // packets whose stage or command nobody knows

  static constexpr std::size_t kMostCommands = 100'000;
  static constexpr std::size_t kMostGames = 100;
};

// Reads the whole log. Throws league::LogError where it is none.
RecordedFacts facts_of(const std::filesystem::path& log);

}  // namespace autoref::runner
