// Lets AutoRef judge the frames of a real game, recorded or live, either alone or alongside the
// referee whose packets come with them.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "game/loop/event_log.hpp"
#include "league/log_contents.hpp"
#include "logs/calls.hpp"
#include "logs/recorded_ends.hpp"
#include "logs/recorded_facts.hpp"
#include "logs/recorded_play.hpp"
#include "referee/referee.hpp"
#include "soccer/robot_command.hpp"

namespace autoref::logs {

class LogReferee;

// Called with each decision.
using DecisionWatch = std::function<void(const referee::Decision&)>;
using FrameWatch = std::function<void(const LogReferee&)>;

// When a referee packet takes effect: in a log, after the last frame captured before the packet; in
// a live game, after the frame that is being received when the packet arrives.
enum class SignalOrder : std::uint8_t { kByTime, kByArrival };

// Under Control::kHuman, AutoRef follows the other referee's signals. Each game in the log has its
// own configuration and referee. If there are more games than configurations, the last
// configuration is reused. If the other referee says that blue defends the goal at -x, frames are
// rotated, since AutoRef assumes that yellow is west.
class LogReferee final : public league::LogVisitor {
 public:
  // `configurations` must not be empty. Throws std::invalid_argument if one is not valid for a
  // referee.
  LogReferee(std::vector<referee::Configuration> configurations, const RecordedTeams& teams,
             SignalOrder order, DecisionWatch watch);

  // `watch` is called after each frame that has been judged, and the signals that follow it.
  void watch_frames(FrameWatch watch) { watch_frame_ = std::move(watch); }

  void on_frame(const Frame& frame) override;
  void on_referee(double time_s, const league::RefereePacket& packet) override;

  const referee::Configuration& configuration() const { return configurations_[game_]; }
  const referee::AutoRef& referee() const { return referee_; }
  // The signal now in force: AutoRef's own or the one that it follows. In this signal, as in the
  // tracks, yellow is west.
  const RefereeSignal& signal() const { return signal_; }
  // Whether frames are rotated.
  bool is_turned() const { return ends_.yellow() == Side::kEast; }

 private:
  struct TimedSignal {
    double time_s = 0;
    RefereeSignal signal;
  };

  void set_ends();
  void judge(const Frame& frame);
  void note_keepers(const RefereeSignal& signal);

  std::vector<referee::Configuration> configurations_;
  PerSide<std::optional<int>> actual_keepers_;
  SignalOrder order_;
  DecisionWatch watch_;
  FrameWatch watch_frame_;
  PerSide<TeamRequests> requests_;
  std::size_t game_ = 0;
  NextGame next_game_;
  bool is_next_game_ = false;
  RecordedEnds ends_;
  referee::AutoRef referee_;
  RefereeSignal signal_;
  double judged_s_ = 0;              // time of the last frame
  std::deque<TimedSignal> signals_;  // signals given after the last frame judged
};

struct LogRefereeResult {
  Agreement agreement;      // between AutoRef's calls and those of the recorded referee
  std::vector<Call> calls;  // AutoRef's calls with their events, including those that stop nothing
  PerSide<int> goals;       // goals counted by AutoRef
  std::vector<game::TimedGameEvent> game_events;  // game events for AutoRef's decisions
  PlayOfLog play;      // chains and play counts, from the first game's rules
  std::string events;  // AutoRef's decisions, one JSON object per line (event_log.hpp)
  int decisions = 0;
  referee::Control control = referee::Control::kAutoref;  // control mode of the first game
};

// Judges every frame of the log in order. `frame_watch` is called after each frame. The goals in
// the result are those of the last game. Throws league::LogError, and std::invalid_argument if a
// configuration is not valid for a referee. `configurations` must not be empty.
LogRefereeResult referee_log(const std::filesystem::path& log, const RecordedFacts& facts,
                             const std::vector<referee::Configuration>& configurations,
                             const DecisionWatch& watch = {}, const FrameWatch& frame_watch = {});

}  // namespace autoref::logs
